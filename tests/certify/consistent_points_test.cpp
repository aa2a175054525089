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

// The same history without any collision: the three go on through each other.
TEST(ConsistentFaults, APointBetweenTwoAndOn) {
  const Scene scene =
      scene_of(30, 4, {disk(-3, 0, 1, 1, 0, 1), disk(3, 0, 1, -1, 0, 1), disk(0, 0, 0, 0, 0, 1)});
  expect_refuted(scene, history_of(scene, run(scene).initial, {}));
}

// Two points that graze a disk from two sides, and meet there: they are no neighbours before, and
// have changed places after, by no flip. The names of the edges around the disk do not tell of it,
// and where a fourth is in the ring they are wrong. Where one passes under the other all is right.
TEST(ConsistentFaults, PointsThatMeetAtADisk) {
  for (const bool fourth : {false, true}) {
    const auto scene = [fourth](double under) {
      std::vector<DiskInput> disks{disk(-1, 0, 0, 1, 0, 1), disk(1, -under, 0, -1, 0, 1),
                                   disk(0, 2, 2, 0, 0, 1)};
      if (fourth) disks.push_back(disk(0, 7, 0.5, 0, 0, 1));
      return scene_of(10, 2, disks);
    };
    const Scene under = scene(0x1p-10), meeting = scene(0);
    expect_certified(under, claimed_history(under, run(under)));
    const History h = history_of(meeting, run(meeting).initial, {});
    for (const Truth truth : {Truth::exact, Truth::recorded}) {
      expect(Verdict::undecided, meeting, h, truth);
    }
  }
}

// Two points that meet as neighbours.
TEST(ConsistentFaults, PointsThatMeet) {
  const Scene scene = scene_of(10, 2, {disk(-1, 0, 0, 1, 0, 1), disk(1, 0, 0, -1, 0, 1)});
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    expect(Verdict::undecided, scene, history_of(scene, kTwo, {}), truth);
  }
  // The true motion ends there: no claim after it is right or wrong.
  expect(Verdict::undecided, scene,
         history_of(scene, kTwo, {collision(1.5, container_id, 0, {}, {-1, 0})}), Truth::exact);
}

// A point passes between two disks at the instant at which these touch, and grazes both: nothing
// turns, no flip is due, and the point has the same neighbours before and after.
TEST(ConsistentFaults, APointPassesBetweenTwoThatTouch) {
  for (const double speed : {2.0, 0.5, -3.0}) {
    const Scene scene = scene_of(30, 2,
                                 {disk(-1, 0, 1, 0, 0, 1), disk(1, -1, 1, 0, 1, 1),
                                  disk(0, -speed, 0, 0, speed, 1), disk(9, 12, 2, 0, 0, 1)});
    const RecordedRun made = run(scene);
    ASSERT_EQ(made.outcome.kind, Outcome::Kind::complete) << made.outcome.reason;
    const History right = claimed_history(scene, made);
    for (const auto& event : right.events) EXPECT_TRUE(std::holds_alternative<FlipEvent>(event));
    expect_certified(scene, right);
    for (std::size_t k = 0; k < right.events.size(); ++k) {
      History wrong = right;
      wrong.events.erase(wrong.events.begin() + static_cast<std::ptrdiff_t>(k));
      wrong.count();
      expect_refuted(scene, wrong);
    }
  }
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
