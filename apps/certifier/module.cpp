// The kernel as a module of the page: text(0 ... 2) takes scene, history and options, judge()
// answers, all in JSON.
//
// Only Emscripten compiles this (packaging/cmake/KernelModule.cmake). page/kernel.js calls it.
#include <nlohmann/json.hpp>

#include "certify/kernel/motion.h"

namespace voroproof_kernel {
namespace {

using Json = nlohmann::json;

std::string texts[3], answer;

Options options() {
  const Json asked = Json::parse(texts[2]);
  Options o;
  o.truth = asked.at("truth") == "exact" ? Truth::exact : Truth::recorded;
  o.tolerance = asked.at("tolerance");
  o.law_tolerance = asked.at("lawTolerance");
  o.strict = asked.at("strict");
  o.unoriented = asked.at("unoriented");
  return o;
}

Json counts(const Counts& c) {
  return {{"flips", c.flips},
          {"collisions", c.collisions},
          {"maneuvers", c.maneuvers},
          {"lives", c.lives},
          {"pairLives", c.pair_lives},
          {"freshProofs", c.fresh_proofs},
          {"swaps", c.swaps},
          {"grazes", c.grazes},
          {"roundingOverlaps", c.rounding_overlaps},
          {"horizonEvents", c.horizon_events},
          {"unoriented", c.unoriented}};
}

double near(const Rat& x) { return x.convert_to<double>(); }

// Where the verdict sees its fault, or the place of the claim in its line.
Sight sight_of(const Problem& p, const Result& r) {
  if (r.sight.named > 0 || r.line == 0) return r.sight;
  for (const Claim& c : p.history.claims) {
    if (c.line != r.line) continue;
    if (c.kind == Claim::Kind::flip) return sight(c.t, c.quad);
    return c.kind == Claim::Kind::collision ? sight(c.t, {c.id[0], c.id[1]})
                                            : sight(c.t, {c.id[1]});
  }
  return {};
}

// All generators on their claimed paths; null where nothing is to be drawn.
Json drawing(const Problem& p, const Sight& seen) {
  if (seen.named == 0 || p.legs.empty()) return nullptr;
  const Rat t = exactly(seen.t);
  Json generators = Json::array();
  for (int g = container; g < p.disks(); ++g) {
    const auto& legs = p.legs[g + 1];
    auto leg = std::upper_bound(legs.begin(), legs.end(), t,
                                [](const Rat& x, const Leg& l) { return x < l.start; });
    if (leg != legs.begin()) --leg;
    const Vec at = leg->at(t), &v = leg->velocity;
    generators.push_back({{"id", g},
                          {"x", near(at[0])},
                          {"y", near(at[1])},
                          {"r", near(p.radius(g))},
                          {"vx", near(v[0])},
                          {"vy", near(v[1])}});
  }
  const std::vector<int> named(seen.generators, seen.generators + seen.named);
  return {{"t", seen.t}, {"named", named}, {"generators", generators}};
}

}  // namespace
}  // namespace voroproof_kernel

extern "C" {

__attribute__((import_module("page"), import_name("progress"))) void page_progress(
    const char* rule, std::size_t claim, std::size_t of);

__attribute__((export_name("text"))) char* text(int which, std::size_t size) {
  voroproof_kernel::texts[which].resize(size);
  return voroproof_kernel::texts[which].data();
}

__attribute__((export_name("judge"))) const char* judge() {
  using namespace voroproof_kernel;
  Problem p{.options = options()};
  p.options.progress = page_progress;
  const Result r = check(texts[0], texts[1], p);
  const char* verdicts[] = {"CERTIFIED", "REFUTED", "UNDECIDED", "INVALID"};
  const Json horizon = p.history.last_line > 0 ? Json(near(p.history.horizon)) : Json();
  answer = Json({{"verdict", verdicts[static_cast<int>(r.verdict)]},
                 {"reason", r.reason},
                 {"line", r.line},
                 {"isFirst", r.is_first},
                 {"counts", counts(r.counts)},
                 {"lines", lines_of(r)},
                 {"horizon", horizon},
                 {"horizonNote", r.horizon_note},
                 {"drawing", drawing(p, sight_of(p, r))}})
               .dump();
  return answer.c_str();
}

}  // extern "C"
