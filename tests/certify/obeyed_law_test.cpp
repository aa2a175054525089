// Where exactly the law of collision draws the line between velocities that obey it and others.
#include "certify/collision_law.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <optional>
#include <utility>

#include "tests/certify/collision_cases.h"
#include "tests/support/compact_arithmetic.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {
namespace {

BallPair ball(const ExactPair& p) { return {internal::ball(p[0]), internal::ball(p[1])}; }

// ---- obeyed ----

RC_GTEST_PROP(CollisionLaw, ObeyedByWhatItGives, ()) {
  const Contact c = any_contact();
  RC_PRE(c.has_normal() && c.has_mass());
  const Rational tolerance = *rc::gen::element(Rational(0), kTolerance);
  const CollisionLaw law(c.scene, tolerance);
  const Rational t =
      *rc::gen::element(Rational(0), Rational(1, 3), Rational("1000000000000000000"));
  RC_ASSERT(law.obeyed(claim_of(c.i, 1, law.after(c.i, 1, c.p, c.v)), c.p, c.v, t));
}

// The two touch and all that is known is small and written well: then the line is at the tolerance
// times the speeds that meet, here 3 + 4, up to the roundings, below a part in 10^5 of it.
TEST(CollisionLaw, ObeyedWithinTheTolerance) {
  Scene scene = two(1, 1, 1, 2);
  const ExactPair p{ExactVec2{0, 0}, ExactVec2{2, 0}}, v{ExactVec2{3, 0}, ExactVec2{0, 4}};
  const CollisionLaw law(scene, kTolerance);
  const ExactPair right = law.after(0, 1, p, v);
  const Rational bound = 7 * kTolerance, in = Rational(99999, 100000) * bound,
                 out = Rational(100001, 100000) * bound;
  for (const int side : {0, 1}) {
    for (const int axis : {0, 1}) {
      for (const int sign : {-1, 1}) {
        ExactPair claimed = right;
        claimed[side][axis] = right[side][axis] + sign * in;
        EXPECT_TRUE(law.obeyed(claim_of(0, 1, claimed), p, v, 0)) << side << axis << sign;
        claimed[side][axis] = right[side][axis] + sign * out;
        EXPECT_FALSE(law.obeyed(claim_of(0, 1, claimed), p, v, 0)) << side << axis << sign;
      }
    }
    // The length counts, not the components.
    ExactPair claimed = right;
    claimed[side] = plus(right[side], {Rational(3, 5) * in, Rational(4, 5) * in});
    EXPECT_TRUE(law.obeyed(claim_of(0, 1, claimed), p, v, 0));
    claimed[side] = plus(right[side], {Rational(3, 5) * out, Rational(4, 5) * out});
    EXPECT_FALSE(law.obeyed(claim_of(0, 1, claimed), p, v, 0));
  }
}

TEST(CollisionLaw, ObeyedWithinTheToleranceAtTheContainer) {
  for (const ContainerLaw kind : {ContainerLaw::normal, ContainerLaw::whole}) {
    Scene scene = two(1, 1, 1, 2);
    scene.law = kind;
    scene.container_restitution = Rational(1, 8);
    // Only the disk's speed counts: what stands for the container's is not looked at.
    const ExactPair p{ExactVec2{}, ExactVec2{1, 11}}, v{ExactVec2{100, 0}, ExactVec2{3, 4}};
    const CollisionLaw law(scene, kTolerance);
    const ExactVec2 right = law.after(container_id, 1, p, v)[1];
    for (const auto& [factor, accepted] : {std::pair(99999, true), std::pair(100001, false)}) {
      const Rational off = 5 * kTolerance * Rational(factor, 100000);
      EXPECT_EQ(law.obeyed(claim_of(container_id, 1, std::nullopt, plus(right, {0, off})), p, v, 0),
                accepted);
      EXPECT_EQ(
          law.obeyed(claim_of(container_id, 1, std::nullopt, plus(right, {-off, 0})), p, v, 0),
          accepted);
    }
  }
}

// Doubles that are the nearest to the law's velocities are no less right than these.
TEST(CollisionLaw, ObeyedByRoundedVelocities) {
  const Scene scene = two(1, 1, 1, 2);
  const ExactPair p{ExactVec2{0, 0}, ExactVec2{1, 1}}, v{ExactVec2{3, 1}, ExactVec2{0, 1}};
  const CollisionLaw law(scene, kTolerance);
  const ExactPair right = law.after(0, 1, p, v);
  const auto near = [](const ExactVec2& x) {
    return Vec2{round_nearest(x[0]), round_nearest(x[1])};
  };
  EXPECT_TRUE(law.obeyed(plain_claim(0, 1, near(right[0]), near(right[1])), p, v, 0));
  Vec2 wrong = near(right[1]);
  wrong[0] += 1e-8;
  EXPECT_FALSE(law.obeyed(plain_claim(0, 1, near(right[0]), wrong), p, v, 0));
}

// Without any speed no tolerance is left.
TEST(CollisionLaw, NobodyMoves) {
  const Scene scene = two(1, 1, 1, 1);
  CollisionLaw law(scene, kTolerance);
  const ExactPair p{ExactVec2{0, 0}, ExactVec2{2, 0}}, rest{ExactVec2{0, 0}, ExactVec2{0, 0}};
  EXPECT_TRUE(law.obeyed(claim_of(0, 1, rest), p, rest, 0));
  ExactPair pushed = rest;
  pushed[1][0] = Rational(1, 1000000) * kTolerance;
  EXPECT_FALSE(law.obeyed(claim_of(0, 1, pushed), p, rest, 0));
  EXPECT_FALSE(law.certainly_obeyed(claim_of(0, 1, pushed), ball(p), ball(rest)));
}

// ---- Unknown normals ----

// Two points meet at one place: head on, by the same speed, they leave in any direction, opposite
// to each other.
TEST(CollisionLaw, CoincidentPointsHaveSomeNormal) {
  const Scene scene = two(0, 1, 0, 1);
  const CollisionLaw law(scene, kTolerance);
  const ExactPair p{ExactVec2{3, 4}, ExactVec2{3, 4}}, v{ExactVec2{1, 0}, ExactVec2{-1, 0}};
  const auto obeyed = [&](const ExactVec2& v0, const ExactVec2& v1) {
    return law.obeyed(claim_of(0, 1, v0, v1), p, v, 0);
  };
  EXPECT_TRUE(obeyed({-1, 0}, {1, 0}));
  EXPECT_TRUE(obeyed({0, 1}, {0, -1}));
  EXPECT_TRUE(obeyed({Rational(3, 5), Rational(4, 5)}, {Rational(-3, 5), Rational(-4, 5)}));
  // A normal across the velocities changes nothing.
  EXPECT_TRUE(obeyed({1, 0}, {-1, 0}));
  // Energy without momentum, momentum without energy.
  EXPECT_FALSE(obeyed({0, 1}, {0, 1}));
  EXPECT_FALSE(obeyed({0, 2}, {0, -2}));
  EXPECT_FALSE(obeyed({0, 0}, {0, 0}));
  // Either alone.
  EXPECT_FALSE(obeyed({0, Rational(3, 2)}, {0, -1}));
  EXPECT_FALSE(obeyed({0, 1}, {0, Rational(-3, 2)}));
}

// The same with masses and a restitution: by every normal of a fan, and by no other velocities.
TEST(CollisionLaw, CoincidentPointsOfEveryNormal) {
  Scene scene = two(0, 1, 0, 3);
  scene.restitution = Rational(1, 2);
  const CollisionLaw law(scene, kTolerance);
  const ExactPair p{ExactVec2{0, 0}, ExactVec2{0, 0}}, v{ExactVec2{2, 1}, ExactVec2{-1, 0}};
  for (int x = -3; x <= 3; ++x) {
    const ExactPair by_normal = law.after(0, 1, {ExactVec2{0, 0}, ExactVec2{x, 2}}, v);
    EXPECT_TRUE(law.obeyed(claim_of(0, 1, by_normal), p, v, 0)) << x;
    for (const int side : {0, 1}) {
      ExactPair off = by_normal;
      off[side] = plus(off[side], {Rational(1, 1000000), Rational(1, 1000000)});
      EXPECT_FALSE(law.obeyed(claim_of(0, 1, off), p, v, 0)) << x;
    }
  }
}

// A disk that fills the container, or nearly.
TEST(CollisionLaw, AtTheContainerWithoutNormal) {
  Scene scene = two(1, 1, 10, 1);
  scene.container_restitution = Rational(1, 2);
  const ExactPair p{ExactVec2{}, ExactVec2{1, 2}}, v{ExactVec2{}, ExactVec2{4, 0}};
  const auto obeyed = [&](const ExactVec2& v1) {
    return CollisionLaw(scene, kTolerance)
        .obeyed(claim_of(container_id, 1, std::nullopt, v1), p, v, 0);
  };
  scene.law = ContainerLaw::normal;
  EXPECT_TRUE(obeyed({-2, 0}));
  EXPECT_TRUE(obeyed({4, 0}));
  EXPECT_TRUE(obeyed({1, -3}));  // by the normal (1, 1)
  EXPECT_FALSE(obeyed({0, -2}));
  scene.law = ContainerLaw::whole;
  EXPECT_TRUE(obeyed({-2, 0}));
  EXPECT_TRUE(obeyed({0, 2}));
  EXPECT_FALSE(obeyed({1, -3}));
  EXPECT_FALSE(obeyed({4, 0}));
}

// Centres in doubles at a late time are known no better than by their roundings: near the reach
// of the two any normal will do, and before that the bound grows with them.
TEST(CollisionLaw, RoundingsOfFarCentresHideTheNormal) {
  const Scene scene = two(1, 1, 1, 1);
  const CollisionLaw law(scene, kTolerance);
  const ExactPair p{ExactVec2{0, 0}, ExactVec2{2, 0}}, v{ExactVec2{1, 0}, ExactVec2{-1, 0}};
  const CollideEvent as_seen = claim_of(0, 1, ExactVec2{-1, 0}, ExactVec2{1, 0}),
                     other = claim_of(0, 1, ExactVec2{0, 1}, ExactVec2{0, -1}),
                     turned = claim_of(0, 1, ExactVec2{Rational(-4, 5), Rational(3, 5)},
                                       ExactVec2{Rational(4, 5), Rational(-3, 5)}),
                     none = claim_of(0, 1, ExactVec2{-1, 0}, ExactVec2{2, 0});
  const auto obeyed = [&](const CollideEvent& claim, long power) {
    return law.obeyed(claim, p, v, Rational(1) << power);
  };
  // Of 2^53 times the reach, 2, the error is 16 (2 + 2 t): all of it at t = 2^49, and half of it at
  // 2^48, of which the speeds, 2, make velocities that are off by 1.
  EXPECT_FALSE(obeyed(other, 0));
  EXPECT_FALSE(obeyed(other, 48));
  EXPECT_TRUE(obeyed(other, 49));
  EXPECT_FALSE(obeyed(turned, 46));
  EXPECT_TRUE(obeyed(turned, 48));
  for (const long power : {0L, 48L, 49L, 60L}) {
    EXPECT_TRUE(obeyed(as_seen, power)) << power;
    // No normal explains these.
    EXPECT_FALSE(obeyed(none, power)) << power;
  }
}

// The whole law shrinks what it reflects. Velocities within the tolerance obey it all the same
// where the normal is not known.
TEST(CollisionLaw, TheToleranceWithoutNormalIsOfWhatIsClaimed) {
  Scene scene = two(1, 1, 10, 1);
  scene.law = ContainerLaw::whole;
  for (const Rational& restitution : {Rational(1), Rational(1, 10), Rational(1, 1000)}) {
    scene.container_restitution = restitution;
    const CollisionLaw law(scene, kTolerance);
    const ExactPair p{ExactVec2{}, ExactVec2{1, 2}}, v{ExactVec2{}, ExactVec2{4, 0}};
    for (const ExactVec2& n : {ExactVec2{1, 0}, ExactVec2{1, 1}, ExactVec2{0, 1}}) {
      const ExactVec2 right =
          law.after(container_id, 1, {ExactVec2{}, plus(ExactVec2{1, 2}, n)}, v)[1];
      const Rational off = Rational(99, 100) * kTolerance * 4;
      for (const ExactVec2& d : {ExactVec2{off, 0}, ExactVec2{-off, 0}, ExactVec2{0, off}}) {
        EXPECT_TRUE(law.obeyed(claim_of(container_id, 1, std::nullopt, plus(right, d)), p, v, 0));
      }
    }
  }
}

// Two points, one hardly faster than the other, change little by whatever normal. What is off by
// ten tolerances from all of these is no velocity of any, however slow the approach.
TEST(CollisionLaw, TheToleranceWithoutNormalOfASlowApproach) {
  const Scene scene = two(0, 1, 0, 1);
  const CollisionLaw law(scene, kTolerance);
  const ExactPair p{ExactVec2{0, 0}, ExactVec2{0, 0}};
  for (const Rational& approach :
       {Rational(0), Rational(1, 1000000), Rational(1, 1000), Rational(1)}) {
    const ExactPair v{ExactVec2{1 + approach, 0}, ExactVec2{1, 0}};
    // By the normal along the velocities, across them, and between.
    for (const ExactVec2& n : {ExactVec2{1, 0}, ExactVec2{0, 1}, ExactVec2{1, 1}}) {
      const ExactPair right = law.after(0, 1, {ExactVec2{0, 0}, n}, v);
      for (const auto& [factor, accepted] :
           {std::pair(Rational(99, 100), true), std::pair(Rational(10), false)}) {
        // Opposite to each other, so that the momentum is kept, and away from the circle on which
        // the velocities by all normals lie.
        ExactVec2 outward = minus(right[0], {1 + approach / 2, 0});
        const Rational length = approach == 0 ? Rational(1) : Rational(approach / 2);
        outward = approach == 0 ? ExactVec2{0, 1} : times(1 / length, outward);
        const ExactVec2 off = times(factor * kTolerance * (2 + approach), outward);
        EXPECT_EQ(law.obeyed(claim_of(0, 1, plus(right[0], off), minus(right[1], off)), p, v, 0),
                  accepted)
            << approach << " " << n[0] << n[1] << " " << factor;
      }
    }
  }
}

// ---- In doubles ----

TEST(CollisionLaw, CertainlyObeyedNextToTheTolerance) {
  const Scene scene = two(1, 1, 1, 2);
  CollisionLaw law(scene, kTolerance);
  const ExactPair p{ExactVec2{0, 0}, ExactVec2{2, 0}}, v{ExactVec2{3, 0}, ExactVec2{0, 4}};
  const ExactPair right = law.after(0, 1, p, v);
  EXPECT_TRUE(law.certainly_obeyed(claim_of(0, 1, right), ball(p), ball(v)));
  for (const int side : {0, 1}) {
    for (const auto& [factor, accepted] : {std::pair(999, true), std::pair(1001, false)}) {
      ExactPair claimed = right;
      claimed[side][1] += 7 * kTolerance * Rational(factor, 1000);
      EXPECT_EQ(law.certainly_obeyed(claim_of(0, 1, claimed), ball(p), ball(v)), accepted);
      const Vec2 v0{claimed[0][0].get_d(), claimed[0][1].get_d()},
          v1{claimed[1][0].get_d(), claimed[1][1].get_d()};
      EXPECT_EQ(law.certainly_obeyed(plain_claim(0, 1, v0, v1), ball(p), ball(v)), accepted);
    }
  }
  // Centres that may coincide, and those known to a thousandth, say nothing.
  BallPair wide = ball(p);
  wide[1][0].rad = 2;
  EXPECT_FALSE(law.certainly_obeyed(claim_of(0, 1, right), wide, ball(v)));
  wide[1][0].rad = 0;
  wide[1][1].rad = 1e-3;
  EXPECT_FALSE(law.certainly_obeyed(claim_of(0, 1, right), wide, ball(v)));
}

RC_GTEST_PROP(CollisionLaw, CertainlyObeyedIsObeyed, ()) {
  const Contact c = any_contact();
  const Rational tolerance = *rc::gen::element(kTolerance, Rational(1, 1000), Rational(1) >> 45);
  CollisionLaw law(c.scene, tolerance);
  RC_PRE(c.has_mass());
  // By a normal that may be another one, and off by a factor of what the tolerance allows.
  ExactPair p = c.p;
  if (*rc::gen::element(false, false, false, true)) p[1] = plus(p[1], any_vector());
  Contact seen = c;
  seen.p = p;
  RC_PRE(seen.has_normal());
  ExactPair claimed = law.after(c.i, 1, p, c.v);
  const Rational speed =
      length_bound(c.v[1]) + (c.at_container() ? Rational(0) : length_bound(c.v[0]));
  const Rational off = speed * tolerance *
                       *rc::gen::element(Rational(0), Rational(1, 2), Rational(9999, 10000),
                                         Rational(10001, 10000), Rational(2));
  const ExactVec2 direction = *rc::gen::element(ExactVec2{1, 0}, ExactVec2{0, -1},
                                                ExactVec2{Rational(-3, 5), Rational(4, 5)});
  for (const int side : {0, 1}) {
    if (*rc::gen::arbitrary<bool>()) claimed[side] = plus(claimed[side], times(off, direction));
  }
  const CollideEvent claim = claim_of(c.i, 1, claimed);
  const bool certainly = law.certainly_obeyed(claim, ball(c.p), ball(c.v));
  const Rational t = *rc::gen::element(Rational(0), Rational(1), Rational(1) << 40);
  RC_CLASSIFY(certainly, "certainly obeyed");
  if (certainly) RC_ASSERT(law.obeyed(claim, c.p, c.v, t));
}

}  // namespace
}  // namespace voroproof::internal::testing
