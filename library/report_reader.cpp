#include "library/report_reader.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "history/scene.h"

namespace voroproof::internal {
namespace {

GenId read_id(const JsonField& field) {
  const std::int64_t id = field.integer();
  if (id < container_id || id >= max_disks) field.fail("no generator");
  return static_cast<GenId>(id);
}

Quad read_quad(const JsonField& field) {
  return {read_id(field[0]), read_id(field[1]), read_id(field[2]), read_id(field[3])};
}

// A whole number or a fraction, of any length.
std::string read_fraction(const JsonField& field) {
  const std::string text = field.text();
  const auto digits = [](std::string_view part) {
    return !part.empty() && part.find_first_not_of("0123456789") == std::string_view::npos;
  };
  std::string_view rest = text;
  if (rest.starts_with('-')) rest.remove_prefix(1);
  const std::size_t slash = rest.find('/');
  const bool right = slash == std::string_view::npos
                         ? digits(rest)
                         : digits(rest.substr(0, slash)) && digits(rest.substr(slash + 1)) &&
                               rest.find_first_not_of('0', slash + 1) != std::string_view::npos;
  if (!right) field.fail("no fraction");
  return text;
}

EvidenceNumber read_number(const JsonField& field) {
  if (field.json().is_string()) return {read_fraction(field), {}, {}};
  for (const std::size_t side : {0u, 1u}) read_exact(field[side]);  // decimal bounds
  return {{}, field[0].text(), field[1].text()};
}

Vec2 read_vector(const JsonField& field) { return {field[0].number(), field[1].number()}; }

std::array<std::optional<Vec2>, 2> read_vectors(const JsonField& claim, const char* name) {
  std::array<std::optional<Vec2>, 2> vectors;
  if (!claim.has(name)) return vectors;
  for (const std::size_t side : {0u, 1u}) {
    const JsonField vector = claim[name][side];
    if (!vector.json().is_null()) vectors[side] = read_vector(vector);
  }
  return vectors;
}

Event read_claim(const JsonField& claim) {
  const JsonField time = claim["t"];
  const double t = time.number();
  std::shared_ptr<const ExactValues> exact;
  if (time.json().is_string()) {
    exact = std::make_shared<const ExactValues>(ExactValues{read_exact(time), {}, {}});
  }
  if (claim.has("flip")) return FlipEvent{t, read_quad(claim["flip"]), exact};
  if (claim.has("collide")) {
    const JsonField pair = claim["collide"];
    return CollideEvent{t,
                        read_id(pair[0]),
                        read_id(pair[1]),
                        read_vectors(claim, "v"),
                        read_vectors(claim, "p"),
                        exact};
  }
  ManeuverEvent m{.t = t, .disk = read_id(claim["maneuver"]), .exact = exact};
  if (claim.has("v")) m.v = read_vector(claim["v"]);
  if (claim.has("p")) m.p = read_vector(claim["p"]);
  return m;
}

Witness read_witness(const JsonField& field) {
  Witness w;
  if (field.has("generators")) {
    for (const JsonField& g : field["generators"].elements()) {
      w.generators.push_back({read_id(g["id"]), read_exact(g["t0"]), read_number(g["center"][0]),
                              read_number(g["center"][1]), read_number(g["velocity"][0]),
                              read_number(g["velocity"][1]), read_number(g["signed_radius"])});
    }
  }
  if (field.has("polynomial")) {
    w.polynomial_is = field["polynomial"]["is"].text();
    for (const JsonField& c : field["polynomial"]["coefficients"].elements()) {
      w.polynomial.push_back(read_number(c));
    }
  }
  if (field.has("isolating_interval")) {
    const JsonField root = field["isolating_interval"];
    w.root = std::array{read_exact(root[0]), read_exact(root[1])};
  }
  if (field.has("t")) w.t = read_exact(field["t"]);
  if (field.has("vertex")) {
    const JsonField v = field["vertex"];
    w.vertex = Triple{read_id(v[0]), read_id(v[1]), read_id(v[2])};
  }
  if (field.has("contains")) w.conflict = read_id(field["contains"]);
  return w;
}

Divergence read_divergence(const JsonField& field) {
  Divergence d;
  const auto* const kind = std::find(fault_names.begin(), fault_names.end(), field["kind"].text());
  if (kind == fault_names.end()) field["kind"].fail("no kind of fault");
  d.fault = static_cast<Fault>(kind - fault_names.begin());
  d.line = read_count(field["line"]);
  d.t = field["t"].number();
  if (!field["claim"].json().is_null()) d.claim = read_claim(field["claim"]);
  d.truth = field["truth"].text();
  if (field.has("true_flip")) d.true_flip = read_quad(field["true_flip"]);
  if (field.has("true_contact")) {
    const JsonField pair = field["true_contact"];
    d.true_contact = std::pair(read_id(pair[0]), read_id(pair[1]));
  }
  if (field.has("true_time")) d.true_time = read_vector(field["true_time"]);
  d.witness = read_witness(field["witness"]);
  return d;
}

Verdict read_verdict(const JsonField& field) {
  for (const Verdict v : {Verdict::certified, Verdict::refuted, Verdict::undecided}) {
    if (verdict_line(v).substr(2) == field.text()) return v;
  }
  field.fail("no verdict");
}

// "line 7: why": see reason_line().
void read_reason(const JsonField& field, Certificate& c) {
  const std::string text = field.text(), before = "line ";
  const std::size_t colon = text.find(": ");
  if (!text.starts_with(before) || colon == std::string::npos) field.fail("no reason");
  const auto number = parse_rational(text.substr(before.size(), colon - before.size()));
  if (!number || number->get_den() != 1 || !number->get_num().fits_slong_p()) {
    field.fail("names no line");
  }
  c.reason_line = number->get_num().get_si();
  c.reason = text.substr(colon + 2);
}

// "horizon 5 of the scene's 1000": see horizon_line(). Nothing where the text is empty.
std::optional<std::array<Rational, 2>> read_horizons(const JsonField& field) {
  const std::string text = field.text(), before = "horizon ", between = " of the scene's ";
  if (text.empty()) return std::nullopt;
  const std::size_t middle = text.find(between);
  if (!text.starts_with(before) || middle == std::string::npos) field.fail("no two horizons");
  const auto own = parse_rational(text.substr(before.size(), middle - before.size()));
  const auto of_scene = parse_rational(text.substr(middle + between.size()));
  if (!own || !of_scene) field.fail("no two horizons");
  return std::array{*own, *of_scene};
}

}  // namespace

std::int64_t read_count(const JsonField& field) {
  const std::int64_t count = field.integer();
  if (count < 0 || count > std::int64_t{1} << 42) field.fail("out of range");
  return count;
}

Rational read_exact(const JsonField& field) {
  const auto value = parse_rational(field.text());
  if (!value) field.fail("no number");
  return *value;
}

Certificate read_certificate(const JsonField& report) {
  Certificate c;
  c.verdict = read_verdict(report["verdict"]);
  if (c.verdict == Verdict::refuted) c.divergence = read_divergence(report["divergence"]);
  if (c.verdict != Verdict::refuted && report.has("divergence")) {
    report["divergence"].fail("in a report that refutes nothing");
  }
  if (c.verdict == Verdict::undecided) read_reason(report["reason"], c);
  const JsonField prefix = report["certified_prefix"];
  c.prefix_events = read_count(prefix["events"]);
  c.prefix_t = prefix["t"].number();
  const JsonField proved = report["proved"];
  c.flips = read_count(proved["flips"]);
  c.collisions = read_count(proved["collisions"]);
  c.maneuvers = read_count(proved["maneuvers"]);
  c.edge_lives = read_count(proved["edge_lives"]);
  c.pair_lives = read_count(proved["pair_lives"]);
  c.tiers.beyond_filter = read_count(proved["beyond_first_filter"]);
  c.simultaneous = read_count(proved["simultaneous"]);
  const JsonField lenient = report["leniency"];
  c.swaps = read_count(lenient["swaps"]);
  c.resolved = read_count(lenient["resolved_quadruplets"]);
  c.grazes = read_count(lenient["grazes"]);
  c.rounding_overlaps = read_count(lenient["rounding_overlaps"]);
  c.at_horizon = read_count(lenient["at_horizon"]);
  c.left_out = read_count(lenient["left_out"]);
  c.proved_anew = read_count(lenient["proved_anew"]);
  c.computed_velocities = read_count(lenient["computed_velocities"]);
  c.other_horizon = read_horizons(lenient["other_horizon"]);
  if (report.has("flips_not_judged")) c.flips_not_judged = read_count(report["flips_not_judged"]);
  c.other_orders = read_count(lenient["other_orders"]);
  c.highest_bits = static_cast<int>(
      std::min<std::int64_t>(read_count(report["highest_bits"]), std::numeric_limits<int>::max()));
  for (const JsonField& remark : report["remarks"].elements()) c.remarks.push_back(remark.text());
  return c;
}

CertificationRun read_run(const JsonField& report) {
  const std::int64_t disks = report["disks"].integer();
  if (disks < 0 || disks > max_disks) report["disks"].fail("out of range");
  return {.producer = report["producer"].text(),
          .scene_file = report["scene"].text(),
          .history_file = report["history"].text(),
          .scene_sha256 = report["scene_sha256"].text(),
          .history_sha256 = report.has("history_sha256") ? report["history_sha256"].text() : "",
          .history_producer = report["history_producer"].text(),
          .disks = static_cast<int>(disks),
          .horizon = read_exact(report["horizon"])};
}

CertifyOptions read_options(const JsonField& report) {
  CertifyOptions options;
  const std::string truth = report["truth"].text(), events = report["events"].text();
  if (truth != "exact" && truth != "recorded") report["truth"].fail("no truth");
  if (events != "all" && events != "collisions") report["events"].fail("no kind of events");
  options.truth = truth == "exact" ? Truth::exact : Truth::recorded;
  options.events = events == "all" ? EventKinds::all : EventKinds::collisions;
  options.any_order = report.has("order") && report["order"].text() == "any";
  options.tolerance = read_exact(report["tolerance"]);
  options.law_tolerance = read_exact(report["law_tolerance"]);
  if (!report["strict"].json().is_boolean()) report["strict"].fail("neither true nor false");
  options.strict = report["strict"].json().get<bool>();
  return options;
}

}  // namespace voroproof::internal
