#include "kernel/kernel.h"

#include "kernel/lives.h"

namespace voroproof_kernel {
namespace {

std::int64_t Counts::*const kCounts[] = {
    &Counts::flips,  &Counts::collisions, &Counts::maneuvers,         &Counts::lives,
    &Counts::pair_lives, &Counts::fresh_proofs, &Counts::swaps, &Counts::grazes,
    &Counts::rounding_overlaps, &Counts::horizon_events, &Counts::unoriented};

void judge(Problem& p, Result& result) {
  const History& h = p.history;
  if (!h.stopped && h.horizon != p.scene.horizon) {
    if (p.options.strict) refute("the history has another horizon than its scene");
    result.horizon_note = "horizon " + h.horizon.str() + " of the scene's " + p.scene.horizon.str();
  }
  trace_paths(p, result.counts);
  if (!h.initial && p.disks() >= 2) undecided("the history has no initial diagram");
  if (h.initial && p.disks() < 2 && !h.initial->empty()) refute("wrong initial diagram");
  std::int64_t line = 0;
  try {
    check_contacts(p, result.counts, line);
    if (p.disks() >= 2) {
      for (const Part& part : parts_of(p)) check_lives(p, part, result.counts, line);
    }
  } catch (Stop& stop) {
    if (stop.line == 0) stop.line = line;
    throw;
  }
  const Counts& c = result.counts;
  const std::int64_t claimed[] = {c.flips, c.collisions, c.maneuvers};
  for (int k = 0; k < 3; ++k) {
    if (h.stopped) undecided("the history stops before its horizon");
    if (h.ended[k] != claimed[k]) throw Stop{Verdict::refuted, "bad count", h.last_line};
  }
}

}  // namespace

Result check(const std::string& scene_text, const std::string& history_text,
             const Options& options) {
  Result result;
  try {
    Problem p;
    p.options = options;
    p.tolerance = exact_string(options.tolerance);
    p.law_tolerance = exact_string(options.law_tolerance);
    if (p.tolerance <= 0 || p.law_tolerance < 0 || p.law_tolerance > 1) invalid("a bad tolerance");
    p.scene = read_scene(scene_text);
    p.history = read_history(history_text, p.disks());
    p.horizon = p.history.horizon;
    if (p.history.scene_sha256 != sha256(scene_text)) invalid("another scene's history", 1);
    judge(p, result);
    result.verdict = Verdict::certified;
  } catch (const Stop& stop) {
    result.verdict = stop.verdict;
    result.reason = stop.reason;
    result.line = stop.line;
  }
  return result;
}

}  // namespace voroproof_kernel
