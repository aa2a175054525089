#include "certify/report.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "history/json_text.h"

namespace voroproof::internal {

namespace {

using Json = nlohmann::ordered_json;

Json json(const Quad& q) { return Json::array({q.l, q.r, q.s, q.e}); }
Json json(const Triple& v) { return Json::array({v[0], v[1], v[2]}); }
Json json(const EvidenceNumber& n) {
  if (!n.exact.empty()) return n.exact;
  return Json::array({n.lower, n.upper});
}

Json json(const Event& event) {
  Json j = Json::object();
  j["t"] = exact_time(event) == to_rational(time(event)) ? Json(time(event))
                                                         : Json(exact_time(event).get_str());
  const auto vectors = [](const std::array<std::optional<Vec2>, 2>& v) {
    Json out = Json::array();
    for (const auto& x : v) out.push_back(x ? Json::array({(*x)[0], (*x)[1]}) : Json());
    return out;
  };
  if (const auto* f = std::get_if<FlipEvent>(&event)) {
    j["flip"] = json(f->quad);
  } else if (const auto* c = std::get_if<CollideEvent>(&event)) {
    j["collide"] = Json::array({c->i, c->j});
    if (c->v[1]) j["v"] = vectors(c->v);
    if (c->p[1]) j["p"] = vectors(c->p);
  } else {
    const auto& m = std::get<ManeuverEvent>(event);
    j["maneuver"] = m.disk;
    if (m.v) j["v"] = Json::array({(*m.v)[0], (*m.v)[1]});
    if (m.p) j["p"] = Json::array({(*m.p)[0], (*m.p)[1]});
  }
  return j;
}

Json json(const Witness& w) {
  Json j = Json::object();
  if (!w.generators.empty()) {
    Json all = Json::array();
    for (const EvidenceMotion& m : w.generators) {
      all.push_back({{"id", m.id},
                     {"t0", m.t0.get_str()},
                     {"center", Json::array({json(m.x), json(m.y)})},
                     {"velocity", Json::array({json(m.vx), json(m.vy)})},
                     {"signed_radius", json(m.radius)}});
    }
    j["generators"] = std::move(all);
  }
  if (!w.polynomial.empty()) {
    Json coefficients = Json::array();
    for (const EvidenceNumber& n : w.polynomial) coefficients.push_back(json(n));
    j["polynomial"] = {{"is", w.polynomial_is}, {"coefficients", std::move(coefficients)}};
  }
  if (w.root)
    j["isolating_interval"] = Json::array({(*w.root)[0].get_str(), (*w.root)[1].get_str()});
  if (w.t) j["t"] = w.t->get_str();
  if (w.vertex) j["vertex"] = json(*w.vertex);
  if (w.conflict) j["contains"] = *w.conflict;
  return j;
}

Json json(const Divergence& d) {
  Json j = Json::object();
  j["kind"] = fault_names[static_cast<int>(d.fault)];
  j["line"] = d.line;
  j["t"] = d.t;
  j["claim"] = d.claim ? json(*d.claim) : Json();
  j["truth"] = d.truth;
  if (d.true_flip) j["true_flip"] = json(*d.true_flip);
  if (d.true_contact)
    j["true_contact"] = Json::array({d.true_contact->first, d.true_contact->second});
  if (d.true_time) j["true_time"] = Json::array({(*d.true_time)[0], (*d.true_time)[1]});
  j["witness"] = json(d.witness);
  return j;
}

// As the shortest decimal of a binary64, where it is that number or that decimal; else "p/q".
std::string exact_text(const Rational& q) {
  const double near = round_nearest(q);
  if (!std::isfinite(near)) return q.get_str();
  const std::string decimal = number_text(near);
  return to_rational(near) == q || parse_rational(decimal) == q ? decimal : q.get_str();
}

// Says what a verdict is not about, where only collisions were judged; else empty.
std::string scope_line(const CertifyOptions& options, const Certificate& c) {
  if (options.judges_flips()) return {};
  return "flips were not judged (" + std::to_string(c.flips_not_judged) +
         " in the history), and no diagram is claimed";
}

// Where times are so late that rounding them to binary64 may take them out of the tolerance: which
// tolerance lets all times of a history be that are rounded correctly. Else empty.
std::string coarse_times_line(const Rational& tolerance, const Rational& horizon) {
  const double last = round_up(horizon);
  const double ulp = std::nextafter(last, std::numeric_limits<double>::infinity()) - last;
  if (!std::isfinite(ulp) || tolerance >= to_rational(ulp / 2)) return {};
  return "binary64 numbers near t = " + number_text(last) + " are " + number_text(ulp) +
         " apart, so that rounding alone takes a time out of the tolerance: --tolerance " +
         number_text(ulp) + " allows for it";
}

// Where the tolerance is as long as the time that is judged, so that no event had to be claimed.
// Else empty.
std::string long_tolerance_line(const Rational& tolerance, const Rational& horizon) {
  if (horizon == 0 || tolerance < horizon) return {};
  return "the tolerance is as long as the time that is judged: no event of it had to be claimed";
}

std::string horizon_line(const Rational& horizon, const Rational& of_scene) {
  return "horizon " + exact_text(horizon) + " of the scene's " + exact_text(of_scene);
}

// The end of what a verdict is about.
std::string up_to_line(const Rational& horizon, const Rational& tolerance) {
  return "up to t = " + exact_text(horizon) + ", times within " + exact_text(tolerance);
}

}  // namespace

std::string_view verdict_line(Verdict verdict) {
  switch (verdict) {
    case Verdict::certified:
      return "s CERTIFIED";
    case Verdict::refuted:
      return "s REFUTED";
    case Verdict::undecided:
      break;
  }
  return "s UNDECIDED";
}

std::string reason_line(const Certificate& c) {
  if (c.divergence) {
    const Divergence& d = *c.divergence;
    return "line " + std::to_string(d.line) + ": " +
           std::string(fault_names[static_cast<int>(d.fault)]) + ": " + d.truth;
  }
  if (c.verdict == Verdict::certified) return {};
  return "line " + std::to_string(c.reason_line) + ": " + c.reason;
}

std::vector<Leniency> leniencies(const Certificate& c) {
  return {
      {"swaps", c.swaps, "claims out of order within the tolerance, which commute"},
      {"resolved_quadruplets", c.resolved, "quadruplets without orientation"},
      {"grazes", c.grazes, "collisions of two that come within the rounding of each other"},
      {"rounding_overlaps", c.rounding_overlaps, "overlaps no deeper than the rounding"},
      {"at_horizon", c.at_horizon, "claims within the tolerance of the horizon"},
      {"left_out", c.left_out, "events within the tolerance of the horizon that are not claimed"},
      {"proved_anew", c.proved_anew, "pairs of which one lay inside the other for a moment"},
      {"computed_velocities", c.computed_velocities, "collisions without velocities"},
      {"other_orders", c.other_orders,
       "instants whose turns are not proved to be in the format's order"},
  };
}

std::string horizon_line(const Certificate& c) {
  if (!c.other_horizon) return {};
  return horizon_line((*c.other_horizon)[0], (*c.other_horizon)[1]);
}

VerdictWords words_of(const CertifyOptions& options, const Rational& horizon,
                      const Certificate& c) {
  VerdictWords words;
  const bool all = options.judges_flips();
  words.verdict =
      std::string(verdict_line(c.verdict).substr(2)) + (all ? "" : " (collisions alone)");
  words.about = std::string(all ? "all events" : "collisions and maneuvers") + ", " +
                (options.truth == Truth::exact ? "exact" : "recorded") + " truth, " +
                up_to_line(horizon, options.tolerance) + ", velocities within " +
                exact_text(options.law_tolerance) +
                (options.any_order ? ", touching collisions in any order" : "") +
                (options.strict ? ", strict" : "");
  for (const Leniency& l : leniencies(c)) {
    if (l.count == 0) continue;
    words.reservations.push_back("leniency: " + std::to_string(l.count) + " " +
                                 std::string(l.words));
  }
  for (const std::string& line :
       {horizon_line(c), coarse_times_line(options.tolerance, horizon),
        long_tolerance_line(options.tolerance, horizon), scope_line(options, c)}) {
    if (!line.empty()) words.reservations.push_back(line);
  }
  return words;
}

VerdictWords words_of_world(Verdict verdict, const Rational& horizon, const Rational& of_scene,
                            const Rational& tolerance) {
  VerdictWords words;
  words.verdict = verdict_line(verdict).substr(2);
  words.about = "all events of a world, " + up_to_line(horizon, tolerance);
  if (horizon != of_scene) words.reservations.push_back(horizon_line(horizon, of_scene));
  for (const std::string& line :
       {coarse_times_line(tolerance, horizon), long_tolerance_line(tolerance, horizon)}) {
    if (!line.empty()) words.reservations.push_back(line);
  }
  return words;
}

std::string report_text(const CertificationRun& run, const CertifyOptions& options,
                        const Certificate& c) {
  Json j = Json::object();
  j["format"] = "voroproof-report";
  j["version"] = 1;
  j["producer"] = run.producer;
  j["scene"] = run.scene_file;
  j["history"] = run.history_file;
  j["scene_sha256"] = run.scene_sha256;
  if (!run.history_sha256.empty()) j["history_sha256"] = run.history_sha256;
  j["history_producer"] = run.history_producer;
  j["disks"] = run.disks;
  j["horizon"] = run.horizon.get_str();
  j["truth"] = options.truth == Truth::exact ? "exact" : "recorded";
  j["events"] = options.judges_flips() ? "all" : "collisions";
  if (!options.judges_flips()) j["flips_not_judged"] = c.flips_not_judged;
  if (options.truth == Truth::exact) j["order"] = options.any_order ? "any" : "format";
  j["tolerance"] = options.tolerance.get_str();
  j["law_tolerance"] = options.law_tolerance.get_str();
  j["strict"] = options.strict;
  j["verdict"] = verdict_line(c.verdict).substr(2);
  const VerdictWords words = words_of(options, run.horizon, c);
  j["words"] = {
      {"verdict", words.verdict}, {"about", words.about}, {"reservations", words.reservations}};
  j["reason"] = reason_line(c);
  j["certified_prefix"] = {{"events", c.prefix_events}, {"t", c.prefix_t}};
  if (c.divergence) {
    j["divergence"] = json(*c.divergence);
    j["evidence"] = run.evidence;
  }
  j["proved"] = {{"flips", c.flips},
                 {"collisions", c.collisions},
                 {"maneuvers", c.maneuvers},
                 {"edge_lives", c.edge_lives},
                 {"pair_lives", c.pair_lives},
                 {"beyond_first_filter", c.tiers.beyond_filter},
                 {"simultaneous", c.simultaneous}};
  j["swaps"] = c.swaps;
  j["resolved_quadruplets"] = c.resolved;
  Json lenient = Json::object();
  for (const Leniency& l : leniencies(c)) lenient[std::string(l.name)] = l.count;
  lenient["other_horizon"] = horizon_line(c);
  j["leniency"] = std::move(lenient);
  if (options.truth == Truth::exact) {
    j["time_error_ulps"] = {
        {"max", c.ulps_max}, {"max_line", c.ulps_max_line}, {"mean", c.ulps_mean()}};
  }
  if (run.least) {
    j["least_tolerances"] = {{"times", run.least->times.get_str()},
                             {"velocities", run.least->velocities.get_str()}};
  }
  for (const auto& [field, said] : run.second) j[field] = said;
  j["highest_bits"] = c.highest_bits;
  j["remarks"] = c.remarks;
  // File names need not be UTF-8.
  return j.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace voroproof::internal
