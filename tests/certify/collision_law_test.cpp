// The law of collision: what it keeps, and what it says without a normal or a mass.
#include "certify/collision_law.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <utility>

#include "filtered/motion/options.h"
#include "tests/certify/collision_cases.h"
#include "tests/exact/fraction.h"
#include "tests/support/compact_arithmetic.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {
namespace {

Rational dot(const ExactVec2& a, const ExactVec2& b) { return a[0] * b[0] + a[1] * b[1]; }

// ---- reach ----

TEST(CollisionLaw, ReachOfDisksIsTheSumOfRadii) {
  EXPECT_EQ(CollisionLaw(two(2, 1, 3, 1), kTolerance).reach(0, 1), 5);
  EXPECT_EQ(CollisionLaw(two(2, 1, 2, 1), kTolerance).reach(0, 1), 4);
  EXPECT_EQ(CollisionLaw(two(0, 1, 3, 1), kTolerance).reach(0, 1), 3);
  EXPECT_EQ(CollisionLaw(two(0, 1, 0, 1), kTolerance).reach(0, 1), 0);
  // Without rounding.
  EXPECT_EQ(CollisionLaw(two(fraction(1, 3), 1, fraction(1, 7), 1), kTolerance).reach(0, 1),
            fraction(10, 21));
}

TEST(CollisionLaw, ReachAtTheContainerIsTheGapOfRadii) {
  const Scene scene = two(0, 1, fraction(1, 3), 1);
  const CollisionLaw law(scene, kTolerance);
  EXPECT_EQ(law.reach(container_id, 0), 10);
  EXPECT_EQ(law.reach(container_id, 1), fraction(29, 3));
  EXPECT_EQ(CollisionLaw(two(1, 1, 10, 1), kTolerance).reach(container_id, 1), 0);
}

// ---- bounds of lengths ----

// Their squares have no double.
TEST(CollisionLaw, LengthsOfAnySizeHaveCloseBounds) {
  for (const double size : {0.0, 5e-324, 1e-200, 1.0, 1e200, 1e308}) {
    const Rational side = to_rational(size);
    const Rational length = length_bound(ExactVec2{3 * side, -4 * side});
    EXPECT_GE(length, 5 * side);
    EXPECT_LE(length, 5 * side * (1 + fraction(1, 1'000'000'000'000'000)));
  }
}

// ---- after ----

TEST(CollisionLaw, KnownCollisions) {
  const ExactPair p{ExactVec2{0, 0}, ExactVec2{2, 0}};
  {
    // Equal masses exchange what they have along the normal.
    const Scene scene = two(1, 5, 1, 5);
    const ExactPair v = CollisionLaw(scene, 0).after(0, 1, p, {ExactVec2{3, 7}, ExactVec2{-1, 4}});
    EXPECT_EQ(v, (ExactPair{ExactVec2{-1, 7}, ExactVec2{3, 4}}));
  }
  {
    // Nothing is left of the approach without restitution.
    Scene scene = two(1, 1, 1, 3);
    scene.restitution = 0;
    const ExactPair v = CollisionLaw(scene, 0).after(0, 1, p, {ExactVec2{4, 0}, ExactVec2{0, 0}});
    EXPECT_EQ(v, (ExactPair{ExactVec2{1, 0}, ExactVec2{1, 0}}));
  }
  {
    // A disk without mass bounces off one that does not notice.
    const Scene scene = two(1, 0, 1, 3);
    const ExactPair v = CollisionLaw(scene, 0).after(0, 1, p, {ExactVec2{4, 1}, ExactVec2{1, 1}});
    EXPECT_EQ(v, (ExactPair{ExactVec2{-2, 1}, ExactVec2{1, 1}}));
  }
  {
    // Nobody moves.
    const ExactPair rest{ExactVec2{0, 0}, ExactVec2{0, 0}};
    EXPECT_EQ(CollisionLaw(two(1, 1, 1, 2), 0).after(0, 1, p, rest), rest);
  }
}

TEST(CollisionLaw, KnownCollisionsWithTheContainer) {
  Scene scene = two(1, 1, 1, 1);
  scene.container_restitution = Rational(1, 4);
  // The centre of the container is (1, 2): the normal is (0, 9).
  const ExactPair p{ExactVec2{}, ExactVec2{1, 11}}, v{ExactVec2{}, ExactVec2{8, 4}};
  EXPECT_EQ(CollisionLaw(scene, 0).after(container_id, 1, p, v)[1], (ExactVec2{8, -1}));
  scene.law = ContainerLaw::whole;
  EXPECT_EQ(CollisionLaw(scene, 0).after(container_id, 1, p, v)[1], (ExactVec2{2, -1}));
  scene.container_restitution = 1;
  EXPECT_EQ(CollisionLaw(scene, 0).after(container_id, 1, p, v)[1], (ExactVec2{8, -4}));
}

RC_GTEST_PROP(CollisionLaw, KeepsMomentumAndEnergyAndReversesTheApproach, ()) {
  Contact c = any_contact();
  c.i = 0;
  RC_PRE(c.has_normal() && c.has_mass());
  const ExactPair after = CollisionLaw(c.scene, 0).after(0, 1, c.p, c.v);
  const Rational m0 = c.scene.disks[0].mass, m1 = c.scene.disks[1].mass, e = c.scene.restitution;
  RC_ASSERT(plus(times(m0, after[0]), times(m1, after[1])) ==
            plus(times(m0, c.v[0]), times(m1, c.v[1])));
  const auto energy = [&](const ExactPair& v) -> Rational {
    return m0 * norm2(v[0]) + m1 * norm2(v[1]);
  };
  RC_CLASSIFY(e == 1, "elastic");
  if (e == 1) RC_ASSERT(energy(after) == energy(c.v));
  RC_ASSERT(energy(after) <= energy(c.v));
  const ExactVec2 n = c.normal(), along{-n[1], n[0]};
  RC_ASSERT(dot(minus(after[1], after[0]), n) == -e * dot(minus(c.v[1], c.v[0]), n));
  // Neither is pushed along the line of contact.
  RC_ASSERT(dot(after[0], along) == dot(c.v[0], along));
  RC_ASSERT(dot(after[1], along) == dot(c.v[1], along));
}

RC_GTEST_PROP(CollisionLaw, OfTheContainer, ()) {
  Contact c = any_contact();
  c.i = container_id;
  RC_PRE(c.has_normal());
  const ExactVec2 v = CollisionLaw(c.scene, 0).after(container_id, 1, c.p, c.v)[1];
  const ExactVec2 n = c.normal(), along{-n[1], n[0]};
  const Rational e = c.scene.container_restitution;
  const bool whole = c.scene.law == ContainerLaw::whole;
  RC_ASSERT(dot(v, n) == -e * dot(c.v[1], n));
  RC_ASSERT(dot(v, along) == (whole ? e : Rational(1)) * dot(c.v[1], along));
}

TEST(CollisionLaw, IsUndecidedWithoutNormalOrMass) {
  const ExactPair together{ExactVec2{3, 4}, ExactVec2{3, 4}},
      apart{ExactVec2{0, 0}, ExactVec2{1, 0}};
  const ExactPair v{ExactVec2{1, 0}, ExactVec2{0, 0}};
  const Scene points = two(0, 1, 0, 1), massless = two(0, 0, 0, 0);
  try {
    CollisionLaw(points, kTolerance).after(0, 1, together, v);
    ADD_FAILURE() << "a normal of coincident centres";
  } catch (const Undecided& u) {
    EXPECT_EQ(u.contact, std::pair(0, 1));
    EXPECT_NE(std::string(u.what()).find("normal"), std::string::npos);
  }
  try {
    CollisionLaw(massless, kTolerance).after(0, 1, apart, v);
    ADD_FAILURE() << "a response of two without mass";
  } catch (const Undecided& u) {
    EXPECT_EQ(u.contact, std::pair(0, 1));
    EXPECT_NE(std::string(u.what()).find("mass"), std::string::npos);
  }
  EXPECT_THROW(CollisionLaw(massless, kTolerance).obeyed(claim_of(0, 1, v), apart, v, 0),
               Undecided);
  EXPECT_THROW(CollisionLaw(massless, kTolerance).obeyed(claim_of(0, 1, v), together, v, 0),
               Undecided);
  // A disk that fills the container, at its centre.
  const Scene full = two(1, 1, 10, 1);
  EXPECT_THROW(CollisionLaw(full, 0).after(container_id, 1, {ExactVec2{}, ExactVec2{1, 2}}, v),
               Undecided);
  // No mass is needed at the container.
  EXPECT_EQ(CollisionLaw(massless, 0)
                .after(container_id, 1, {ExactVec2{}, ExactVec2{1, 12}},
                       {ExactVec2{}, ExactVec2{1, 1}})[1],
            (ExactVec2{1, -1}));
}

// ---- In words ----

TEST(CollisionLaw, ExpectationTellsTheVelocitiesAndHowFarTheClaimIsOff) {
  const Scene scene = two(1, 1, 1, 1);
  const Rational tolerance = fraction(1, 1024);
  const CollisionLaw law(scene, tolerance);
  const ExactPair p{ExactVec2{0, 0}, ExactVec2{2, 0}}, v{ExactVec2{3, 0}, ExactVec2{-1, 0}};
  const std::string off =
      ", and the claimed ones are off by 0.25 of the speeds that meet, where 0.000976562 and what "
      "roundings do are allowed (--law-tolerance)";
  CollideEvent claim;
  claim.j = 1;
  claim.v = {Vec2{-1, 0}, Vec2{3, 1}};
  EXPECT_EQ(law.expectation(claim, p, v),
            "by the law of collision the velocities are (-1, 0) and (3, 0)" + off);
  EXPECT_EQ(law.expectation(claim, {ExactVec2{1, 1}, ExactVec2{1, 1}}, v),
            "the centres coincide and give no normal");
  claim.i = container_id;
  claim.v = {std::nullopt, Vec2{0, -3}};
  EXPECT_EQ(law.expectation(claim, {ExactVec2{}, ExactVec2{1, 11}}, {ExactVec2{}, ExactVec2{0, 4}}),
            "by the law of collision the velocities are (0, -4)" + off);
}

}  // namespace
}  // namespace voroproof::internal::testing
