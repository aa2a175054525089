// Inelastic collapse is seen before it happens, whether it is proved or taken to be one.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {
namespace {

// The time in "... infinitely often before t = X"; NaN where that is not the reason.
double proved_end(const RecordedRun& history) {
  const std::string& reason = history.outcome.reason;
  const std::string mark = "collides with the container infinitely often before t = ";
  const std::size_t at = reason.find(mark);
  return at == std::string::npos ? NAN : std::stod(reason.substr(at + mark.size()));
}

Scene lone(Rational restitution, Rational horizon) {
  Scene scene =
      scene_of(10, std::move(horizon), {disk(0, Rational(-899, 100), 1, 1, Rational(-1, 100))});
  scene.container_restitution = std::move(restitution);
  return scene;
}

TEST(InelasticCollapse, OfALoneDiskIsProvedWithItsTime) {
  for (const Rational& e : {Rational(1, 20), Rational(1, 2), Rational(9, 10)}) {
    const RecordedRun history = run(lone(e, 1000));
    const double end = proved_end(history);
    ASSERT_FALSE(std::isnan(end)) << e << ": " << history.outcome.reason;
    EXPECT_EQ(history.outcome.events.size(), 1u);
    // The flights are shorter by e each, nearly so as the normal speed is small: their sum, found
    // from the last three collisions.
    const std::size_t n = history.events.size();
    ASSERT_GE(n, 3u);
    const double a = history.events[n - 3].t, b = history.events[n - 2].t,
                 c = history.events[n - 1].t;
    const double ratio = (c - b) / (b - a);
    const double limit = c + (c - b) * ratio / (1 - ratio);
    EXPECT_NEAR(ratio, e.get_d(), 1e-3 * e.get_d());
    EXPECT_NEAR(end, limit, 1e-3 * (end - c)) << e;
    EXPECT_LE(history.outcome.t, end);
    EXPECT_LE(c, history.outcome.t);
  }
}

// The weakest losses are recognized after 48 bounces, not after thousands.
TEST(InelasticCollapse, WeakLossesNeedNoMoreBounces) {
  const RecordedRun history = run(lone(Rational(99, 100), 1000));
  EXPECT_FALSE(std::isnan(proved_end(history)));
  EXPECT_EQ(history.events.size(), 47u);
}

TEST(InelasticCollapse, NeitherAlongADiameterNorBeyondTheHorizon) {
  Scene scene = scene_of(10, 50, {disk(0, 0, 1, 1, 0)});
  scene.container_restitution = Rational(1, 2);
  EXPECT_TRUE(run(scene).complete());  // the flights become longer
  const double end = proved_end(run(lone(Rational(1, 2), 1000)));
  // Up to where infinitely many bounces are still to come.
  const RecordedRun shorter = run(lone(Rational(1, 2), to_rational(end - 0.01)));
  EXPECT_TRUE(shorter.complete()) << shorter.outcome.reason;
}

TEST(InelasticCollapse, IsNotProvedWhereAManeuverComesFirst) {
  Scene scene = lone(Rational(9, 10), 1000);
  const RecordedRun first = run(scene);
  const double end = proved_end(first);
  ASSERT_LT(first.outcome.t, end);
  scene.maneuvers = {{to_rational(0.5 * (first.outcome.t + end)), 0, 0, 1}};
  const RecordedRun second = run(scene);
  EXPECT_EQ(second.count(Event::Kind::maneuver), 1u) << second.outcome.reason;
}

TEST(InelasticCollapse, IsNotProvedWhereAnotherDiskIsMetFirst) {
  Scene scene = lone(Rational(9, 10), 1000);
  const RecordedRun first = run(scene);
  const double end = proved_end(first);
  const Event& last = first.events.back();
  const double hit = 0.5 * (first.outcome.t + end);
  // Another disk is at rest ahead, near the wall, so that the disk arrives there between its
  // bounces at time `hit`.
  const RoundedState& s = last.second;
  const double w = (s.px * s.vy - s.py * s.vx) / 9;
  const double d = 8.99;
  const double apart = std::acos((81 + d * d - 4) / (2 * 9 * d));
  const double angle = std::atan2(s.py, s.px) + (hit - last.t) * w / 9 + apart;
  scene.disks.push_back(
      disk(to_rational(d * std::cos(angle)), to_rational(d * std::sin(angle)), 1, 0, 0));
  const RecordedRun second = run(scene);
  bool met = false;
  for (const Event& e : second.events) {
    met = met || (e.kind == Event::Kind::collision && e.i == 0 && e.j == 1);
  }
  EXPECT_TRUE(met) << second.outcome.reason;
}

// The case that used to end after a minute, as undecided.
TEST(InelasticCollapse, AfterACollisionOfTwoDisks) {
  Scene scene = scene_of(12, 2, {disk(4, 9, 1, -1, 2), disk(0, 10, 1, 1, 1)});
  scene.container_restitution = Rational(1, 4);
  const RecordedRun history = run(scene);
  EXPECT_GT(proved_end(history), history.outcome.t) << history.outcome.reason;
  const std::pair<GenId, GenId> pair{container_id, 1};
  ASSERT_EQ(history.outcome.events.size(), 1u);
  EXPECT_EQ(std::get<1>(history.outcome.events.front()), pair);
}

// The disk collides in turns with two neighbours that come together.
TEST(InelasticCollapse, OfADiskBetweenTwoOthersIsSeen) {
  for (const Rational& e : {Rational(0), Rational(1, 20)}) {
    Scene scene = scene_of(50, 100,
                           {disk(-10, 0, 1, 1, 0), disk(1, Rational(1, 100), 1, 0, 0),
                            disk(11, Rational(-1, 50), 1, -1, Rational(1, 1000))});
    scene.restitution = e;
    const RecordedRun history = run(scene);
    EXPECT_NE(history.outcome.reason.find("inelastic collapse"), std::string::npos)
        << history.outcome.reason;
  }
}

// A stopped history says the same, in whatever way its decisions were made.
TEST(InelasticCollapse, StopsAtATimeThatDoesNotDependOnTheFilters) {
  Scene scene = scene_of(16, 20,
                         {disk(-6, 0, 1, 1, 0), disk(Rational(-7, 3), 0, 1, 0, 0),
                          disk(Rational(5, 2), 0, 1, 0, 0), disk(6, 0, 1, -1, 0)});
  scene.restitution = Rational(1, 10);
  const RecordedRun quick = run(scene), slow = run(scene, {.filters = false});
  EXPECT_EQ(difference(quick, slow), "");
  EXPECT_EQ(quick.outcome.reason, slow.outcome.reason);
  EXPECT_EQ(quick.outcome.t, slow.outcome.t);
  EXPECT_GT(quick.outcome.t, quick.events.back().t);
}

}  // namespace
}  // namespace voroproof::internal::testing
