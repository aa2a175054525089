// Histories that err once and go on consistently in their own world: small ones, made by hand, each
// wrong at one rule of docs/claim.md and right everywhere else, with neighbours that are right.
// Here they err in collisions and the horizon.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "tests/certify/claimed_history.h"
#include "tests/certify/handmade_history.h"

namespace voroproof::internal::testing {
namespace {

// Two that touch and approach at 0, head-on and aslant, and pass through each other.
TEST(ConsistentFaults, TouchingAtStartAndPassingThrough) {
  for (const double vy : {0.0, 0.5}) {
    const Scene scene = scene_of(50, 10, {disk(-1, 0, 1, 1, vy), disk(1, 0, 1, -1, 0)});
    expect_refuted(scene, history_of(scene, kTwo, {}));
    const History right = claimed_history(scene, run(scene));
    expect_certified(scene, right);
    // Claimed late, within the tolerance and beyond it.
    for (const double late : {9e-7, 2e-6}) {
      History h = right;
      std::get<CollideEvent>(h.events.front()).t = late;
      std::get<CollideEvent>(h.events.front()).p = {};
      expect(late < 1e-6 ? Verdict::certified : Verdict::refuted, scene, h, Truth::exact);
    }
  }
}

// The same from a maneuver on, and with a third disk that goes on meanwhile.
TEST(ConsistentFaults, TouchingFromAManeuverOn) {
  Scene scene = scene_of(50, 4, {disk(-1, 0, 1, 0, 0), disk(1, 0, 1, 0, 0)});
  scene.maneuvers.push_back({2, 0, 1, 0});
  const ManeuverEvent turn{2, 0, Vec2{1, 0}, Vec2{-1, 0}, {}};
  expect_refuted(scene, history_of(scene, kTwo, {turn}));
  expect_certified(scene, claimed_history(scene, run(scene)));
}

// Of disks smaller than their way in the tolerance, two that pass through each other.
TEST(ConsistentFaults, TinyDisksPassThroughEachOther) {
  for (const auto& [radius, speed] : {std::pair(1e-7, 1.0), {4e-7, 1.0}, {0.1, 1e7}, {1e-3, 1e5}}) {
    const double start = 0.25 * speed;
    const Scene scene =
        scene_of(Rational(100 * speed), 1,
                 {disk(-start, 0, radius, speed, 0), disk(start, 0, radius, -speed, 0)});
    expect_refuted(scene, history_of(scene, kTwo, {}));
    expect_certified(scene, claimed_history(scene, run(scene)));
  }
}

// Two that pass through each other sideways, on the lines that they are on from 0 to the end, and
// are neighbours no more when the history ends: the flip that parts them has to tell. Of equal
// radii the diagram depends on R + r alone, so that a history of smaller disks is that of these.
TEST(ConsistentFaults, PassingThroughAndPartedByAFlip) {
  const auto scene = [](const Rational& radius) {
    return scene_of(51 - radius, 25,
                    {disk(-10, 1.875, radius, 1, 0), disk(0, 0, radius, 0, 0),
                     disk(8, 6, radius, 0, 0), disk(8, -5, radius, 0, 0)});
  };
  const Scene small = scene(Rational(1, 2)), large = scene(1);
  const History right = claimed_history(small, run(small));
  expect_certified(small, right);
  EXPECT_TRUE(std::any_of(right.events.begin(), right.events.end(), [](const auto& event) {
    const auto* f = std::get_if<FlipEvent>(&event);
    return f != nullptr && std::min(f->quad.l, f->quad.r) == 0 &&
           std::max(f->quad.l, f->quad.r) == 1;
  }));
  expect_refuted(large, right);
}

// Disks smaller than the rounding, that lose nearly all of their speed: claimed late within the
// tolerance they stay in each other for long after it, which no rounding excuses.
TEST(ConsistentFaults, TinyDisksThatStayInEachOther) {
  for (const auto& [restitution, late] :
       {std::pair(Rational(1), 5e-7), {Rational(1, 1000), 0.0}, {Rational(1, 1000), 5e-7}}) {
    Scene scene =
        scene_of(100, 1, {disk(-3e-15, 0, 1e-15, 5e-11, 0), disk(3e-15, 0, 1e-15, -5e-11, 0)});
    scene.restitution = restitution;
    const double v = 5e-11 * restitution.get_d();
    const History h =
        history_of(scene, kTwo, {collision(4e-5 + late, 0, 1, Vec2{-v, 0}, Vec2{v, 0})});
    const bool stay = restitution < 1 && late > 0;
    expect(stay ? Verdict::refuted : Verdict::certified, scene, h, Truth::recorded);
  }
}

// A disk that passes through another, turns, and comes back, all within the tolerance: a collision
// claimed a little before it is back answers that entry, and not the first one.
TEST(ConsistentFaults, PassedThroughBeforeTheNextEntry) {
  const double v = 1e5, t = 1 + 1e-7;
  for (const bool through : {true, false}) {
    const Rational way = Rational(v) * Rational(t), near(1, 125);
    Scene scene = scene_of(1'000'000, Rational(3, 2),
                           {through ? disk(near - way, 0, Rational(1, 1000), v, 0)
                                    : disk(near, -way, Rational(1, 1000), 0, v),
                            disk(0, 0, Rational(1, 1000), 0, 0)});
    scene.maneuvers.push_back({Rational(t), 0, Rational(-v), 0});
    const ManeuverEvent turn{t, 0, Vec2{-v, 0}, {}, {}};
    const History h =
        history_of(scene, kTwo, {turn, collision(t + 5e-8, 0, 1, Vec2{0, 0}, Vec2{-v, 0})});
    expect(through ? Verdict::refuted : Verdict::certified, scene, h, Truth::recorded);
  }
}

// A collision that never happens: disks that pass each other closely; claimed when they are
// nearest, before and after. The velocities obey the law.
TEST(ConsistentFaults, NearMissTakenForAHit) {
  for (const double gap : {1e-5, 1e-7, 1e-9}) {
    for (const double when : {0.0, -1e-6, 1e-6, -1e-4}) {
      const double speed = 1000;
      const Scene scene =
          scene_of(2000, 1, {disk(0, 0, 1, 0, 0), disk(-250, 2 + gap, 1, speed, 0)});
      const double t = 0.25 + when;
      const double x = -250 + speed * t, y = 2 + gap, n2 = x * x + y * y;
      const double q = speed * x / n2;  // (w.n) / n.n, equal masses
      const CollideEvent hit = collision(t, 0, 1, Vec2{q * x, q * y}, Vec2{speed - q * x, -q * y});
      History h = history_of(scene, kTwo, {hit});
      expect(Verdict::refuted, scene, h, Truth::recorded);
      expect(Verdict::refuted, scene, h, Truth::exact);
      h = history_of(scene, kTwo, {});
      expect_certified(scene, h);
    }
  }
}

// Two that touch without overlapping: a collision when they do is right and counted as a graze, at
// another time it is wrong, though it obeys the law.
TEST(ConsistentFaults, GrazeClaimedAtAnotherTime) {
  const Scene scene = scene_of(50, 8, {disk(0, 0, 1, 0, 0), disk(-4, 2, 1, 1, 0)});
  for (const double when : {0.0, -0x1p-21, 0x1p-21, -0x1p-10}) {
    const double q = when / (when * when + 4);  // (w.n) / n.n, equal masses
    const CollideEvent hit =
        collision(4 + when, 0, 1, Vec2{q * when, 2 * q}, Vec2{1 - q * when, -2 * q});
    const History h = history_of(scene, kTwo, {hit});
    const bool right = std::fabs(when) < 1e-6;
    expect(right ? Verdict::certified : Verdict::refuted, scene, h, Truth::recorded);
    CertifyOptions options;
    options.truth = Truth::recorded;
    EXPECT_EQ(certify(scene, h, options).grazes, right ? 1 : 0);
  }
}

// Two that come into each other so slowly that the overlap stays a rounding: a collision answers it
// within the tolerance of its beginning only.
TEST(ConsistentFaults, ClaimedLongAfterAShallowEntry) {
  const double e = 0x1p-46;
  const Scene scene = scene_of(50, 3, {disk(-1 - e, 0, 1, e, 0), disk(1 + e, 0, 1, -e, 0)});
  for (const double late : {0.0, 5e-7, 2e-6, 0.25}) {
    const History h = history_of(scene, kTwo, {collision(1 + late, 0, 1, Vec2{-e, 0}, Vec2{e, 0})});
    expect(late < 1e-6 ? Verdict::certified : Verdict::refuted, scene, h, Truth::recorded);
  }
}

// A collision after the horizon.
TEST(ConsistentFaults, CollisionAfterTheHorizon) {
  const Scene scene = scene_of(50, 2, {disk(-3, 0, 1, 1, 0), disk(3.0000000002, 0, 1, -1, 0)});
  const CollideEvent hit = collision(2, 0, 1, Vec2{-1, 0}, Vec2{1, 0});
  const History with = history_of(scene, kTwo, {hit}), without = history_of(scene, kTwo, {});
  expect(Verdict::refuted, scene, with, Truth::exact);
  expect(Verdict::certified, scene, without, Truth::exact);
  // The recorded truth may have it or not, and says so.
  for (const History& h : {with, without}) expect(Verdict::certified, scene, h, Truth::recorded);
  CertifyOptions options;
  options.truth = Truth::recorded;
  EXPECT_EQ(certify(scene, with, options).at_horizon, 1);
}

// A collision line twice: without restitution the second changes nothing; of tiny disks it is near.
TEST(ConsistentFaults, CollisionLineTwice) {
  for (const double radius : {1.0, 1e-7}) {
    for (const int restitution : {0, 1}) {
      Scene scene = scene_of(50, 10, {disk(-3, 0, radius, 1, 0, 1), disk(3, 0, radius, -1, 0, 1)});
      scene.restitution = restitution;
      History h = claimed_history(scene, run(scene));
      ASSERT_FALSE(h.events.empty());
      expect_certified(scene, h);
      const auto first = std::get<CollideEvent>(h.events.front());
      for (const double later : {0.0, 5e-7}) {
        History twice = h;
        CollideEvent again = first;
        again.t += later;
        again.p = {};
        twice.events.insert(twice.events.begin() + 1, again);
        twice.count();
        expect_refuted(scene, twice);
      }
    }
  }
}

// Velocities that are not those of the collision, where another disk is fast for a moment: no
// stranger widens the bound.
TEST(ConsistentFaults, WrongVelocitiesBesideAFastStranger) {
  Scene scene =
      scene_of(1000, 10, {disk(-3, 0, 1, 1, 0), disk(3, 0, 1, -1, 0), disk(500, 500, 1, 0, 0)});
  scene.maneuvers.push_back({1, 2, Rational(-100000), 0});
  scene.maneuvers.push_back({Rational(1) + Rational(1, 1000), 2, 0, 0});
  const History right = claimed_history(scene, run(scene));
  expect_certified(scene, right);
  History wrong = right;
  for (auto& event : wrong.events) {
    auto* hit = std::get_if<CollideEvent>(&event);
    if (hit == nullptr) continue;
    hit->p = {};
    hit->v = {Vec2{-1, 0.01}, Vec2{1, 0.01}};
    break;
  }
  expect_refuted(scene, wrong);
}

// A history that sets its own horizon is certified up to that, and says so; not with --strict.
TEST(ConsistentFaults, AnotherHorizon) {
  const Scene scene = scene_of(50, 10, {disk(-3, 0, 1, 1, 0), disk(3, 0, 1, -1, 0)});
  History h = history_of(scene, kTwo, {});
  h.header.horizon = 1;
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    CertifyOptions options;
    options.truth = truth;
    const Certificate c = certify(scene, h, options);
    EXPECT_EQ(c.verdict, Verdict::certified);
    EXPECT_EQ(horizon_line(c), "horizon 1 of the scene's 10");
    options.strict = true;
    EXPECT_EQ(certify(scene, h, options).verdict, Verdict::refuted);
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
