// Runs whose states beyond double-doubles come of a second thread, against runs without it.
#include <gtest/gtest.h>

#include "corpus/generate.h"
#include "tests/support/random_scenes.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {
namespace {

MotionOptions late(MotionOptions options = {}) {
  options.late_states = true;
  return options;
}

void expect_same(const Scene& scene, const MotionOptions& options = {}) {
  const RecordedRun now = run(scene, options), later = run(scene, late(options));
  EXPECT_EQ(difference(now, later), "");
  EXPECT_EQ(now.outcome.kind, later.outcome.kind);
  EXPECT_EQ(now.outcome.t, later.outcome.t);
  EXPECT_EQ(now.outcome.reason, later.outcome.reason);
  EXPECT_EQ(now.final_diagram, later.final_diagram);
  EXPECT_EQ(now.stats.highest_bits, later.stats.highest_bits);
}

TEST(EngineLateStates, Reference) {
  for (const double density : {0.05, 0.4}) {
    ReferenceOptions options;
    options.n = 60;
    options.horizon = 100;
    options.density = density;
    expect_same(generate_reference(options));
  }
}

TEST(EngineLateStates, TiesAndMirrorSymmetry) {
  GridOptions options;
  options.n = 25;
  options.spacing = 2.5;
  options.horizon = 20;
  for (const auto motion : {GridOptions::Motion::random, GridOptions::Motion::shear}) {
    options.motion = motion;
    expect_same(generate_grid(options));
  }
}

TEST(EngineLateStates, LawsAndManeuvers) {
  Random random(6);
  for (int k = 0; k < 6; ++k) {
    Scene scene = random_scene({.n = 20, .rmin = 3, .rmax = 12, .maneuvers = 3 * k}, random);
    if (k % 3 == 1) scene.restitution = Rational(4, 5);
    if (k % 3 == 2) scene.law = ContainerLaw::whole;
    if (k % 3 == 2) scene.container_restitution = Rational(9, 10);
    expect_same(scene);
  }
}

// Near the budget nothing is late: a run stops at the same event.
TEST(EngineLateStates, StopsOfTheBudget) {
  ReferenceOptions scene;
  scene.n = 30;
  scene.horizon = 300;
  scene.density = 0.4;
  for (const int bits : {192, 320, 704}) {
    MotionOptions options;
    options.max_bits = bits;
    const RecordedRun run_of = run(generate_reference(scene), late(options));
    EXPECT_EQ(run_of.outcome.kind, Outcome::Kind::stopped);
    expect_same(generate_reference(scene), options);
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
