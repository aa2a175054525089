// Histories in which points hit and rest on other generators: what is decided of them, and what
// not.
#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include "tests/certify/claimed_history.h"
#include "tests/certify/handmade_history.h"

namespace voroproof::internal::testing {
namespace {

// A point hits a disk and the wall, by rounding a little inside and outside: right, and what
// depends on the tangency is proved anew.
TEST(ConsistentFaults, PointsHitByARounding) {
  int anew = 0;
  for (int k = 0; k < 20; ++k) {
    const Scene scene = scene_of(
        10, 40,
        {disk(-3.1 + 0.01 * k, 0.3, 0, 1, 0.11 + 0.01 * k, 1), disk(3, 0.1 * k, 1, -1, 0.2),
         disk(0.3, -4, 0, 0.3, -0.7, 2), disk(1, 5, 1.5, 0.1, 0.3)});
    const History right = claimed_history(scene, run(scene));
    expect_certified(scene, right);
    CertifyOptions options;
    options.truth = Truth::recorded;
    anew += static_cast<int>(certify(scene, right, options).proved_anew);
  }
  EXPECT_GT(anew, 0);
}

// A point hits a disk, head-on and without restitution, and goes on with it: its cell has no area.
// A flip around it in that time is seen by nobody, and with it the diagram is wrong once the point
// leaves. Nobody certifies that, and the engine stops where the point begins to rest. With
// restitution the point leaves at once, and all is decided.
TEST(ConsistentFaults, APointThatRestsOnADisk) {
  Scene scene = scene_of(30, 34,
                         {disk(5, 0, 0, -1, 0, 1), disk(0, 0, 3, 0, 0), disk(14, -12, 1, 0, 1),
                          disk(-9, 12, 2, 0, 0)});
  scene.maneuvers = {{30, 0, 1, 0}};
  const std::vector<Quad> initial{{-1, 0, 1, 2}, {-1, 1, 2, 3}, {-1, 1, 3, 0},
                                  {-1, 2, 0, 1}, {-1, 3, 1, 1}, {0, 1, -1, 2},
                                  {0, 2, 1, -1}, {1, 2, -1, 0}, {1, 3, -1, -1}};
  scene.restitution = 0;
  CollideEvent hit = collision(2, 0, 1, Vec2{-0.1, 0}, {-0.1, 0});
  hit.p = {Vec2{3, 0}, Vec2{0, 0}};
  const History resting =
      history_of(scene, initial,
                 {FlipEvent{1.8709714839465492, {-1, 0, 1, 2}}, hit,
                  FlipEvent{14.169258536887346, {-1, 1, 3, 2}}, ManeuverEvent{.t = 30, .disk = 0},
                  FlipEvent{30.024300022225376, {1, 2, -1, 0}}});
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    expect(Verdict::undecided, scene, resting, truth);
  }
  const RecordedRun stopped = run(scene);
  EXPECT_EQ(stopped.outcome.kind, Outcome::Kind::stopped);
  EXPECT_NE(stopped.outcome.reason.find("point 0 may rest"), std::string::npos);
  scene.restitution = Rational(1, 2);
  const RecordedRun leaving = run(scene);
  EXPECT_EQ(leaving.outcome.kind, Outcome::Kind::complete);
  expect_certified(scene, claimed_history(scene, leaving));
}

// The same by a maneuver at the instant of an elastic collision, with the velocity that the disk
// has after it, and with nearly that.
TEST(ConsistentFaults, AManeuverMakesAPointRest) {
  for (const bool rests : {true, false}) {
    Scene scene = scene_of(30, 4, {disk(5, 0, 0, -1, 0, 1), disk(0, 0, 3, 0, 0, 7)});
    scene.maneuvers = {{2, 0, rests ? Rational(-1, 4) : Rational(-1, 8), 0}};
    const RecordedRun made = run(scene);
    EXPECT_EQ(made.outcome.kind, rests ? Outcome::Kind::stopped : Outcome::Kind::complete);
    const History h = history_of(
        scene, kTwo,
        {collision(2, 0, 1, Vec2{0.75, 0}, {-0.25, 0}), ManeuverEvent{.t = 2, .disk = 0}});
    for (const Truth truth : {Truth::exact, Truth::recorded}) {
      expect(rests ? Verdict::undecided : Verdict::certified, scene, h, truth);
    }
  }
}

// A point between two disks that meet there: it touches both at one instant.
TEST(ConsistentFaults, APointBetweenTwo) {
  const Scene scene =
      scene_of(30, 4, {disk(-3, 0, 1, 1, 0, 1), disk(3, 0, 1, -1, 0, 1), disk(0, 0, 0, 0, 0, 1)});
  const RecordedRun made = run(scene);
  EXPECT_EQ(made.outcome.kind, Outcome::Kind::stopped);
  EXPECT_NE(made.outcome.reason.find("two generators"), std::string::npos) << made.outcome.reason;
}

// A fast point enters a disk, is claimed to have hit it while it is inside, and leaves it
// elsewhere. With the third disk on the right the point comes from between the two and leaves
// towards the wall: its neighbours have changed while it had no cell, by no flip, and the diagram
// is wrong from then on. No in-circle function of it vanishes before the horizon: only the proof
// anew tells. With the third disk below the point has the same neighbours before and after.
TEST(ConsistentFaults, OtherNeighboursAfterAHiddenMoment) {
  for (const bool right : {true, false}) {
    const DiskInput third = right ? disk(5, 0, 1, 0, 0, 1) : disk(0, -8, 0.5, 0, 0, 1);
    const Scene scene =
        scene_of(10, Rational(4e-6),
                 {disk(0, 0, 1, 0, 0, 1e12), disk(1.81, 0.29, 0, -1087500, 65000, 1), third});
    History h = history_of(scene, run(scene).initial, {collision(1.6e-6, 0, 1, {}, {})});
    std::get<CollideEvent>(h.events.front()).v = {};
    expect(right ? Verdict::undecided : Verdict::certified, scene, h, Truth::recorded);
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
