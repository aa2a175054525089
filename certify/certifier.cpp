#include "certify/certifier.h"

#include <memory>

#include "certify/checker.h"
#include "certify/exact_turns.h"

namespace voroproof::internal {

Certificate certify(const Scene& scene, HistorySource& history, const CertifyOptions& asked) {
  if (asked.truth == Truth::recorded) return certify_recorded(scene, history, asked);
  return certify_by(scene, history, asked,
                    [&](const MotionInput& input, const CertifyOptions& options) {
                      ComputedMotion motion(checked_input(input, history.header()), options.motion);
                      const auto make = [&motion](const ExactTruth::Parts& parts) {
                        return std::make_unique<ExactTurns>(motion, parts);
                      };
                      return Checker(scene, motion, history, options, make).run();
                    });
}

}  // namespace voroproof::internal
