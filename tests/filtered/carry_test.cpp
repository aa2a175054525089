// Outcomes of collisions that share a disk: which are carried onto each other, and which are not.
#include "filtered/carry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "apps/scene_motion.h"
#include "tests/support/scene_run.h"

namespace voroproof::testing {
namespace {

const Rational kTiny("1/1000000000000000000000000000000");

// Four disks of radius 1 around the origin, images of each other by quarter turns, that meet in a
// ring: the first is at (4, 0). `spin` is what its velocity has beside -1 along the radius.
std::vector<DiskSpec> ring(const Rational& spin) {
  return {disk(4, 0, 1, -1, spin), disk(0, 4, 1, -spin, -1), disk(-4, 0, 1, 1, -spin),
          disk(0, -4, 1, spin, 1)};
}

// When they do: (4 - t)^2 + (spin t)^2 = 2.
double meeting(double spin) {
  const double a = 1 + spin * spin;
  return (4 - std::sqrt(16 - 14 * a)) / a;
}

constexpr double kSpin = 0.25;

struct Pair {
  GenId i, j;
};

// The motion after these collisions, near t.
Motion after(const std::vector<DiskSpec>& disks, const std::vector<Pair>& collisions, double t) {
  Motion motion(motion_input(scene_of(30, 10, disks)), {});
  for (const Pair& c : collisions) motion.collide(c.i, c.j, t);
  return motion;
}

// By the law for simultaneous collisions.
const std::vector<Pair> kLawful{{0, 1}, {0, 3}, {1, 2}, {2, 3}};

void note(Motion& motion, double t) { note_right_angles(motion, 0, t - 1e-9, t + 1e-9); }

std::vector<Isometry> carried(const Motion& motion, std::vector<GenId> from,
                              std::vector<GenId> to) {
  const auto states = [&](const std::vector<GenId>& ids) {
    std::vector<DiskState> out;
    for (const GenId g : ids) out.push_back({g, motion.state_id(g)});
    return out;
  };
  return carry(motion, states(from), states(to));
}

TEST(Carry, ARingOfCollisionsWhereverItBegins) {
  const double t = meeting(kSpin);
  for (const auto& order :
       {kLawful, {{2, 3}, {1, 2}, {0, 1}, {0, 3}}, {{0, 1}, {2, 3}, {1, 2}, {0, 3}}}) {
    Motion motion = after(ring(kSpin), order, t);
    // One after the other, the pasts differ, but not what came of them.
    EXPECT_TRUE(carried(motion, {0, 1, 2, 3}, {1, 2, 3, 0}).empty());
    note(motion, t);
    const auto found = carried(motion, {0, 1, 2, 3}, {1, 2, 3, 0});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_FALSE(found[0].reflects);
    EXPECT_TRUE(found[0]({1, 0}) == (Vector{0, 1}));
    EXPECT_TRUE(carried(motion, {0, 1, 2, 3}, {3, 2, 1, 0}).empty());
    EXPECT_TRUE(carried(motion, {0, 1}, {0, 3}).empty());
    // As numbers tell: to all the bits there are.
    for (GenId g = 0; g < 4; ++g) {
      const MovingSite<Ball> a = motion.moving_site(g, Ball(Rational(3), 150)),
                             b = motion.moving_site((g + 1) % 4, Ball(Rational(3), 150));
      for (const Ball& difference : {a.x - b.y, a.y + b.x, a.vx - b.vy, a.vy + b.vx}) {
        EXPECT_EQ(sign(difference), Sign::unknown);
      }
    }
  }
}

TEST(Carry, AReflectionTurnsLeftIntoRight) {
  const double t = meeting(0);
  Motion motion = after(ring(0), kLawful, t);
  note(motion, t);
  const auto kinds = [&](std::vector<GenId> to) {
    const auto found = carried(motion, {0, 1, 2, 3}, std::move(to));
    return found.size() == 1 ? (found[0].reflects ? 1 : 0) : -1;
  };
  EXPECT_EQ(kinds({0, 3, 2, 1}), 1);
  EXPECT_EQ(kinds({1, 0, 3, 2}), 1);
  EXPECT_EQ(kinds({2, 3, 0, 1}), 0);
  EXPECT_EQ(kinds({0, 2, 1, 3}), -1);
}

// Turns noted between two collisions, numbered from 1.
int noted(const std::vector<DiskSpec>& disks, const std::vector<Pair>& collisions, double t, int a,
          int b) {
  Motion motion = after(disks, collisions, t);
  note(motion, t);
  EXPECT_EQ(motion.right_angle(b, a), -motion.right_angle(a, b));
  return motion.right_angle(a, b);
}

TEST(Carry, NormalsAtRightAngles) {
  const double t = meeting(kSpin);
  // Disk 0 is hit by 1 and 3: from it, 3 is to the left of 1.
  EXPECT_EQ(noted(ring(kSpin), kLawful, t, 1, 2), 1);
  EXPECT_EQ(noted(ring(kSpin), kLawful, t, 1, 3), -1);
  EXPECT_EQ(noted(ring(kSpin), kLawful, t, 2, 4), 1);
  EXPECT_EQ(noted(ring(kSpin), kLawful, t, 1, 4), 0);  // they share no disk
}

TEST(Carry, NoRightAngleBesideATinyFault) {
  const double t = meeting(kSpin);
  for (const int what : {0, 1, 2, 3}) {
    std::vector<DiskSpec> disks = ring(kSpin);
    DiskSpec& d = disks[1];
    (what == 0 ? d.x : what == 1 ? d.vy : what == 2 ? d.radius : d.mass) += kTiny;
    // With disk 1 no angle is known to be right, the one opposite it is.
    EXPECT_EQ(noted(disks, kLawful, t, 1, 2), 0) << what;
    EXPECT_EQ(noted(disks, kLawful, t, 1, 3), 0) << what;
    Motion motion = after(disks, kLawful, t);
    note(motion, t);
    EXPECT_TRUE(carried(motion, {0}, {1}).empty()) << what;
    EXPECT_TRUE(carried(motion, {0, 1, 2, 3}, {1, 2, 3, 0}).empty()) << what;
    EXPECT_TRUE(carried(motion, {2}, {0}).empty()) << what;
  }
}

TEST(Carry, ANearlyRightAngleIsNone) {
  // Mirror images hit the disk on their axis at right angles. A quarter turn carries one onto the
  // other but for a fault; or not, as all three move along the axis: then it is no proof.
  const auto disks = [](const Rational& fault, const Rational& along) {
    return std::vector<DiskSpec>{disk(0, 0, 1, 0, along),
                                 disk(4, 4 + fault, Rational(9, 10), -1, along - 1),
                                 disk(-4, 4 + fault, Rational(9, 10), 1, along - 1)};
  };
  const std::vector<Pair> collisions{{0, 1}, {0, 2}};
  const double t = 4 - 1.9 / std::sqrt(2);
  EXPECT_EQ(noted(disks(0, 0), collisions, t, 1, 2), 1);
  EXPECT_EQ(noted(disks(kTiny, 0), collisions, t, 1, 2), 0);
  EXPECT_EQ(noted(disks(0, Rational(1, 8)), collisions, t, 1, 2), 0);
}

TEST(Carry, HalfATurnIsNoQuarterTurn) {
  // Two hit the disk between them: what the first does changes what the second does.
  const std::vector<DiskSpec> disks{disk(0, 0, 1, 0, 0), disk(4, 0, 1, -1, Rational(1, 4)),
                                    disk(-4, 0, 1, 1, Rational(-1, 4))};
  const double t = 2.2;
  EXPECT_EQ(noted(disks, {{0, 1}, {0, 2}}, t, 1, 2), 0);
  Motion motion = after(disks, {{0, 1}, {0, 2}}, t);
  note(motion, t);
  EXPECT_TRUE(carried(motion, {1}, {2}).empty());
}

}  // namespace
}  // namespace voroproof::testing
