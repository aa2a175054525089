#include "certify/certifier.h"

#include <algorithm>

#include "certify/checker.h"
#include "certify/parts.h"
#include "history/error.h"

namespace voroproof {

namespace {

// Quadruplets that had to be resolved are the producer's way only where there are many.
void settle_orientation(Certificate& c, bool strict) {
  if (!c.first_resolved) return;
  if (!strict && c.resolved >= 2 && 5 * c.resolved >= c.flips) {
    c.remarks.push_back("the quadruplets are not oriented: " + std::to_string(c.resolved) +
                        " were resolved by the diagram, the first on line " +
                        std::to_string(c.first_resolved->line));
    return;
  }
  if (c.verdict == Verdict::undecided) return;
  c.verdict = Verdict::refuted;
  c.divergence = c.first_resolved;
  c.prefix_events = c.first_resolved_prefix;
  c.prefix_t = std::min(c.prefix_t, c.first_resolved->t);
}

// A missing flip may be claimed, as one that is none.
void name_shadow(Certificate& c, HistorySource& history, double tolerance) {
  if (!c.divergence || c.divergence->fault != Fault::missing_event || !c.divergence->true_flip) {
    return;
  }
  Divergence& d = *c.divergence;
  const double far = kMistimed * tolerance;
  // The file has been read as far as the checkers came: on to the end of what is asked for.
  try {
    while (const auto event = history.next()) {
      if (time(*event) > (*d.true_time)[1] + far) break;
    }
  } catch (const InputError&) {
    // Where it cannot be read it says nothing.
  }
  const auto line =
      history.shadow_line(*d.true_flip, (*d.true_time)[0] - far, (*d.true_time)[1] + far);
  if (!line) return;
  d.line = *line;
  d.truth += ", which the file takes for a shadow flip";
}

}  // namespace

Certificate certify(const Scene& scene, const MotionInput& input, HistorySource& history,
                    const CertifyOptions& options) {
  Certificate c;
  if (options.truth == Truth::recorded) {
    c = certify_in_parts(scene, input, history, options);
  } else {
    Motion motion(checked_input(input, history.header()), options.motion);
    c = Checker(scene, motion, history, options, Replay(scene, options)).run();
  }
  const auto told = history.remarks();
  c.remarks.insert(c.remarks.begin(), told.begin(), told.end());
  settle_orientation(c, options.strict);
  name_shadow(c, history, round_up(options.tolerance));
  return c;
}

}  // namespace voroproof
