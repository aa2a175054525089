// Collisions and maneuvers of one instant: their order decides what comes of them.
#include <gtest/gtest.h>

#include <algorithm>

#include "certify/report.h"
#include "tests/certify/claimed_history.h"

namespace voroproof::internal::testing {
namespace {

CollideEvent collision(double t, GenId i, GenId j, double vi, double vj) {
  CollideEvent e;
  e.t = t;
  e.i = i;
  e.j = j;
  e.v = {Vec2{vi, 0}, Vec2{vj, 0}};
  return e;
}

// The collisions of disks in a row along the x axis, by the law, from these velocities and masses.
std::vector<voroproof::internal::Event> collide_in_row(double t, std::vector<Rational> v,
                                                       const std::vector<Rational>& m,
                                                       std::vector<GenId> first) {
  std::vector<voroproof::internal::Event> out;
  const GenId n = static_cast<GenId>(v.size());
  for (;;) {
    GenId i = 0;
    while (i + 1 < n && v[i] <= v[i + 1]) ++i;
    if (i + 1 == n) return out;
    if (!first.empty()) {
      i = first.front();
      first.erase(first.begin());
    }
    const Rational k = 2 * (v[i + 1] - v[i]) / (m[i] + m[i + 1]);
    v[i] += m[i + 1] * k;
    v[i + 1] -= m[i] * k;
    out.emplace_back(collision(t, i, i + 1, round_nearest(v[i]), round_nearest(v[i + 1])));
  }
}

Verdict verdict_with(const Scene& scene, std::vector<voroproof::internal::Event> events) {
  ClaimedHistory h = claimed_history(scene, run(scene));
  h.events = std::move(events);
  h.count();
  CertifyOptions options;
  options.strict = true;
  return certify(scene, h, options).verdict;
}

// A row of touching disks, into both ends of which one runs at t = 1, or at 0: the pairs in the
// middle do not approach before.
TEST(Simultaneous, CollisionsAtBothEndsOfARow) {
  const std::vector<Rational> masses{1, 2, 4, 3};
  for (const int t : {0, 1}) {
    const Scene scene =
        scene_of(60, 3,
                 {disk(-3 - t, 0, 1, 1, 0, masses[0]), disk(-1, 0, 1, 0, 0, masses[1]),
                  disk(1, 0, 1, 0, 0, masses[2]), disk(3 + t, 0, 1, -1, 0, masses[3])});
    EXPECT_EQ(verdict_with(scene, collide_in_row(t, {1, 0, 0, -1}, masses, {})),
              Verdict::certified);
    EXPECT_EQ(verdict_with(scene, collide_in_row(t, {1, 0, 0, -1}, masses, {2})), Verdict::refuted);
  }
}

// Three that touch and approach at t = 0, before there is a diagram.
TEST(Simultaneous, CollisionsThatShareADiskAtTheStart) {
  const std::vector<Rational> masses{1, 2, 4};
  const Scene scene = scene_of(60, 3,
                               {disk(-2, 0, 1, 1, 0, masses[0]), disk(0, 0, 1, 0, 0, masses[1]),
                                disk(2, 0, 1, -1, 0, masses[2])});
  EXPECT_EQ(verdict_with(scene, collide_in_row(0, {1, 0, -1}, masses, {})), Verdict::certified);
  EXPECT_EQ(verdict_with(scene, collide_in_row(0, {1, 0, -1}, masses, {1})), Verdict::refuted);
}

// A history that stops between the turns of an instant is right so far if the next ones can be what
// it does not tell.
TEST(Simultaneous, AHistoryThatStopsBetweenTwoTurns) {
  for (const int t : {0, 1}) {
    const Scene scene =
        scene_of(60, 3, {disk(-2 - t, 0, 1, 1, 0), disk(0, 0, 1, 0, 0), disk(2 + t, 0, 1, -1, 0)});
    ClaimedHistory h = claimed_history(scene, run(scene));
    const auto verdict_so_far = [&](std::vector<voroproof::internal::Event> events) {
      h.events = std::move(events);
      h.stop = HistoryStop{static_cast<double>(t), "of a test", {}, {}};
      return certify(scene, h).verdict;
    };
    const auto right = h.events;
    ASSERT_EQ(right.size(), 3u);
    for (std::size_t k = 0; k <= right.size(); ++k) {
      EXPECT_EQ(verdict_so_far({right.begin(), right.begin() + static_cast<std::ptrdiff_t>(k)}),
                Verdict::undecided);
    }
    const auto wrong = collide_in_row(t, {1, 0, -1}, {1, 1, 1}, {1});
    EXPECT_EQ(verdict_so_far({wrong[0], wrong[1]}), Verdict::refuted);
  }
}

// Two collisions at the same instant may be told in any order where they commute: far from each
// other, or side by side, where one disk of each touch and do not approach.
TEST(Simultaneous, CollisionsThatCommute) {
  const std::vector<std::vector<DiskInput>> scenes{
      {disk(-21, 0, 1, 1, 0), disk(-18, 0, 1, 0, 0), disk(10, 0, 1, 0, 0, 2),
       disk(10, 3, 1, 0, -1, 2)},
      {disk(-3, 0, 1, 1, 0), disk(0, 0, 1, 0, 0), disk(0, 2, 1, 0, 0), disk(3, 2, 1, -1, 0)}};
  for (const auto& disks : scenes) {
    const Scene scene = scene_of(60, Rational(3, 2), disks);
    std::vector<voroproof::internal::Event> events = claimed_history(scene, run(scene)).events;
    std::vector<voroproof::internal::Event*> hits;
    for (auto& e : events) {
      if (std::holds_alternative<CollideEvent>(e)) hits.push_back(&e);
    }
    ASSERT_EQ(hits.size(), 2u);
    EXPECT_EQ(time(*hits[0]), time(*hits[1]));
    EXPECT_EQ(verdict_with(scene, events), Verdict::certified);
    std::swap(*hits[0], *hits[1]);
    EXPECT_EQ(verdict_with(scene, events), Verdict::certified);
  }
}

// A flip that only the velocity before a collision of the same instant would bring about, and its
// way back after the collision.
TEST(Simultaneous, AFlipBeforeACollision) {
  // The square of the first four is closed at t = 1 by the last of them, which turns back then.
  const Scene scene = scene_of(30, Rational(3, 2),
                               {disk(0, 5, 1, 0, 0), disk(5, 0, 1, 0, 0), disk(-5, 0, 1, 0, 0),
                                disk(0, -4, 1, 0, -1), disk(0, -7, 1, 0, 0, 3)});
  const ClaimedHistory right = claimed_history(scene, run(scene));
  ASSERT_EQ(right.events.size(), 1u);
  ClaimedHistory wrong = right;
  wrong.events.insert(wrong.events.begin(), FlipEvent{1, Quad{0, 3, 2, 1}, {}});
  wrong.events.push_back(FlipEvent{1, Quad{1, 2, 0, 3}, {}});
  wrong.count();
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    CertifyOptions options;
    options.truth = truth;
    EXPECT_EQ(certify(scene, right, options).verdict, Verdict::certified);
    EXPECT_EQ(certify(scene, wrong, options).verdict, Verdict::refuted);
  }
}

// A disk that a blow would reach at the instant of its maneuver turns after the blow, not before.
TEST(Simultaneous, AManeuverAtTheEndOfARow) {
  for (const int t : {0, 1}) {
    Scene scene =
        scene_of(60, 3, {disk(-3 - t, 0, 1, 1, 0), disk(-1, 0, 1, 0, 0), disk(1, 0, 1, 0, 0)});
    scene.maneuvers.push_back({t, 2, 5, 0});
    const ClaimedHistory right = claimed_history(scene, run(scene));
    ASSERT_EQ(right.events.size(), 3u);
    EXPECT_EQ(verdict_with(scene, right.events), Verdict::certified);
    EXPECT_EQ(verdict_with(scene, {right.events[2], right.events[0]}), Verdict::refuted);
  }
}

// Both of two that touch have a maneuver, the first of which sends one into the other.
TEST(Simultaneous, NoCollisionComesBetweenTwoManeuvers) {
  for (const int t : {0, 1}) {
    Scene scene = scene_of(60, 3, {disk(-1, 0, 1, 0, 0), disk(1, 0, 1, 0, 0)});
    scene.maneuvers.push_back({t, 0, 2, 0});
    scene.maneuvers.push_back({t, 1, 1, 0});
    const ClaimedHistory right = claimed_history(scene, run(scene));
    ASSERT_EQ(right.events.size(), 3u);
    EXPECT_EQ(verdict_with(scene, right.events), Verdict::certified);
    EXPECT_EQ(verdict_with(scene, {right.events[1], right.events[0], right.events[2]}),
              Verdict::certified);
    EXPECT_EQ(verdict_with(scene, {right.events[0], collision(t, 0, 1, 0, 2), right.events[1]}),
              Verdict::refuted);
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
