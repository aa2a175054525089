#include "certify/certifier.h"

#include <memory>

#include "certify/exact_parts.h"
#include "certify/exact_turns.h"

namespace voroproof::internal {

Certificate certify(const Scene& scene, HistorySource& history, const CertifyOptions& asked) {
  if (asked.truth == Truth::recorded) return certify_recorded(scene, history, asked);
  return certify_by(
      scene, history, asked, [&](const MotionInput& input, const CertifyOptions& options) {
        if (options.judges_flips()) {
          ExactParts parts(scene, input, history.header(), options);
          return certify_in_parts(scene, input, history, options, parts.truth());
        }
        ComputedMotion motion(checked_input(input, history.header()), options.motion);
        ComputedTurns turns(scene, motion);
        const auto make = [&](const ExactTruth::Parts& of) {
          return std::make_unique<ExactTurns>(of, turns, Births(scene.disks.size()));
        };
        return Checker(scene, motion, history, options, Replay(scene, options), {}, {}, make).run();
      });
}

}  // namespace voroproof::internal
