// Searches at the end of runs of random scenes, where motion is known after collisions.
#pragma once

#include <gtest/gtest.h>

#include "engine/engine.h"
#include "library/maneuver_input.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {

// Calls check(engine) for 12 scenes of a family, each after its run to the horizon.
template <class Check>
void at_end_of_runs(const RandomScene& family, const char* horizon, unsigned seed, Check&& check) {
  struct Silence : EventSink {
    void begin(const std::vector<Quad>&) override {}
    void flip(double, const Quad&) override {}
    void collide(double, GenId, GenId, const RoundedState&, const RoundedState&) override {}
    void maneuver(double, GenId, const RoundedState&) override {}
  };
  Random random(seed);
  for (int k = 0; k < 12; ++k) {
    Scene scene = random_scene(family, random);
    scene.horizon = Rational(horizon);
    Engine engine(motion_input(scene), {}, {});
    Silence silence;
    ASSERT_EQ(engine.run(silence).kind, Outcome::Kind::complete);
    ASSERT_NO_FATAL_FAILURE(check(engine));
  }
}

}  // namespace voroproof::internal::testing
