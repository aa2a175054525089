#include "library/true_moment.h"

#include <utility>

#include "engine/static_diagram.h"
#include "exact/patience.h"
#include "history/json_text.h"
#include "library/maneuver_input.h"
#include "library/queries/replayed_motion.h"

namespace voroproof::internal {
std::unique_ptr<Engine> run_to(const Scene& scene, const Rational& t,
                               const EngineOptions& options) {
  MotionInput input = motion_input(scene);
  input.horizon = t;
  auto engine = std::make_unique<Engine>(input, maneuver_input(scene), options);
  NoSink sink;
  const Outcome outcome = engine->run(sink);
  if (outcome.kind == Outcome::Kind::interrupted) throw Interrupted();
  if (outcome.kind == Outcome::Kind::stopped) {
    throw Undecided("the motion is known before t = " + number_text(outcome.t) +
                    " only: " + outcome.reason);
  }
  return engine;
}

Diagram diagram_at(Motion& motion, const Rational& t) {
  TierCounts counts;
  Diagram diagram = static_diagram(motion, t, counts);
  settle(diagram, motion, Moment::at(t), counts);
  return diagram;
}

TrueMoment true_moment(const Scene& scene, const std::string& history_path, const Rational& t,
                       const EngineOptions& options) {
  ComputedMotion motion = history_path.empty()
                              ? std::move(run_to(scene, t, options)->motion())
                              : replayed_motion(scene, history_path, t, options.motion).motion;
  Diagram diagram = diagram_at(motion, t);
  return {std::move(motion), std::move(diagram)};
}

}  // namespace voroproof::internal
