// Properties of the engine over small integer scenes, where ties are ordinary. A failing scene
// is shrunk and shown as a scene file. RC_PARAMS="max_success=10000" looks further.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/history_check.h"
#include "tests/support/lattice_scene.h"

namespace voroproof::internal::testing {
namespace {

// A run may stop: at an inelastic collapse, where two points meet (a contact without a
// normal), where a point touches at the start, or two generators at one instant (a cell without
// area), where a maneuver or a collision at the wall makes a disk slide along it, or where a tie
// after several collisions is beyond the stated budget, which symmetric lattices reach. Such cases
// are counted and say why; whatever is complete must be right.
void expect_right(const LatticeScene& lattice, bool may_collapse = false) {
  const Scene scene = scene_of(lattice);
  MotionOptions small_budget;
  small_budget.max_bits = 1024;
  const RecordedRun history = run(scene, small_budget);
  if (!history.complete()) {
    const std::string& reason = history.outcome.reason;
    const bool collapse = reason.find("inelastic collapse") != std::string::npos;
    const bool points = reason.find("two points meet") != std::string::npos;
    const bool touch = reason.find("a point touches another generator") != std::string::npos;
    const bool twice = reason.find("may touch two generators at one instant") != std::string::npos;
    const bool rests = reason.find("may rest on another generator") != std::string::npos;
    const bool slides = reason.find("slides along the container") != std::string::npos;
    const bool budget = reason.find("budget of exact arithmetic") != std::string::npos ||
                        reason.find("needs more than 1024 bits") != std::string::npos ||
                        reason.find("not decided with 1024 bits") != std::string::npos ||
                        reason.find("may become a line at the flip") != std::string::npos;
    RC_ASSERT((collapse && may_collapse) || points || touch || twice || rests || slides || budget);
    RC_CLASSIFY(collapse, "inelastic collapse");
    RC_CLASSIFY(points, "two points meet");
    RC_CLASSIFY(touch, "a point touches at the start");
    RC_CLASSIFY(twice, "a point touches two");
    RC_CLASSIFY(slides, "slides along the container");
    RC_CLASSIFY(budget, "undecided");
    return;
  }
  CheckCounts seen;
  const std::string fault = check_history(scene, history, {}, &seen);
  RC_ASSERT(fault == std::string());
  RC_CLASSIFY(history.count(Event::Kind::flip) > 0, "flips");
  RC_CLASSIFY(history.count(Event::Kind::collision) > 0, "collisions");
  RC_CLASSIFY(seen.ties > 0, "simultaneous events");
}

RC_GTEST_PROP(EngineOnLattice, Elastic, ()) { expect_right(*lattice_scenes({})); }

RC_GTEST_PROP(EngineOnLattice, EqualRadii, ()) {
  LatticeFamily family;
  family.max_radius = 1;
  expect_right(*lattice_scenes(family));
}

RC_GTEST_PROP(EngineOnLattice, WithPoints, ()) {
  LatticeFamily family;
  family.min_radius = 0;
  family.max_radius = 2;
  expect_right(*lattice_scenes(family));
}

RC_GTEST_PROP(EngineOnLattice, WithManeuvers, ()) {
  LatticeFamily family;
  family.maneuvers = true;
  expect_right(*lattice_scenes(family));
}

RC_GTEST_PROP(EngineOnLattice, AtRestButForManeuvers, ()) {
  LatticeFamily family;
  family.maneuvers = true;
  family.max_speed = 1;
  expect_right(*lattice_scenes(family));
}

RC_GTEST_PROP(EngineOnLattice, Inelastic, ()) {
  LatticeFamily family;
  family.elastic = false;
  family.maneuvers = true;
  expect_right(*lattice_scenes(family), true);
}

}  // namespace
}  // namespace voroproof::internal::testing
