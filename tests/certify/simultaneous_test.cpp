// Collisions and maneuvers of one instant: their order decides what comes of them.
#include <gtest/gtest.h>

#include <algorithm>

#include "certify/report.h"
#include "tests/certify/claimed_history.h"

namespace voroproof::testing {
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
std::vector<voroproof::Event> collide_in_row(double t, std::vector<Rational> v,
                                             const std::vector<Rational>& m,
                                             std::vector<GenId> first) {
  std::vector<voroproof::Event> out;
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

Verdict verdict_with(const Scene& scene, std::vector<voroproof::Event> events) {
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

}  // namespace
}  // namespace voroproof::testing
