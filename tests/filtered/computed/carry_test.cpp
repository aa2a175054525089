// Outcomes of collisions that share a disk: which are carried onto each other, and which are not.
#include "filtered/computed/carry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "library/maneuver_input.h"
#include "tests/support/compact_arithmetic.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {
namespace {

const Rational kTiny("1/1000000000000000000000000000000");

// Four disks of radius 1 around the origin, images of each other by quarter turns, that meet in a
// ring: the first is at (4, 0). `spin` is what its velocity has beside -1 along the radius.
std::vector<DiskInput> ring(const Rational& spin) {
  return {disk(4, 0, 1, -1, spin), disk(0, 4, 1, -spin, -1), disk(-4, 0, 1, 1, -spin),
          disk(0, -4, 1, spin, 1)};
}

// The time at which they meet: (4 - t)^2 + (spin t)^2 = 2.
double meeting(double spin) {
  const double a = 1 + spin * spin;
  return (4 - std::sqrt(16 - 14 * a)) / a;
}

constexpr double kSpin = 0.25;

struct Pair {
  GenId i, j;
};

// The motion after these collisions, near t.
ComputedMotion after(const std::vector<DiskInput>& disks, const std::vector<Pair>& collisions,
                     double t) {
  ComputedMotion motion(motion_input(scene_of(30, 10, disks)), {});
  for (const Pair& c : collisions) motion.collide(c.i, c.j, t);
  return motion;
}

// The order of the law for simultaneous collisions.
const std::vector<Pair> kLawful{{0, 1}, {0, 3}, {1, 2}, {2, 3}};

void note(ComputedMotion& motion, double t) { note_relations(motion, 0, t - 1e-9, t + 1e-9); }

std::vector<Isometry> carried(const ComputedMotion& motion, std::vector<GenId> from,
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
    ComputedMotion motion = after(ring(kSpin), order, t);
    // One after the other, the pasts differ, but not what came of them.
    EXPECT_TRUE(carried(motion, {0, 1, 2, 3}, {1, 2, 3, 0}).empty());
    note(motion, t);
    const auto found = carried(motion, {0, 1, 2, 3}, {1, 2, 3, 0});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_FALSE(found[0].reflects);
    EXPECT_TRUE(found[0]({1, 0}) == (Vector{0, 1}));
    EXPECT_TRUE(carried(motion, {0, 1, 2, 3}, {3, 2, 1, 0}).empty());
    EXPECT_TRUE(carried(motion, {0, 1}, {0, 3}).empty());
    // The numbers agree, to all the bits there are.
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
  ComputedMotion motion = after(ring(0), kLawful, t);
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
int noted(const std::vector<DiskInput>& disks, const std::vector<Pair>& collisions, double t, int a,
          int b) {
  ComputedMotion motion = after(disks, collisions, t);
  note(motion, t);
  EXPECT_EQ(motion.relations().right_angle(b, a), -motion.relations().right_angle(a, b));
  return motion.relations().right_angle(a, b);
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
    std::vector<DiskInput> disks = ring(kSpin);
    DiskInput& d = disks[1];
    (what == 0 ? d.x : what == 1 ? d.vy : what == 2 ? d.radius : d.mass) += kTiny;
    // With disk 1 no angle is known to be right, the one opposite it is.
    EXPECT_EQ(noted(disks, kLawful, t, 1, 2), 0) << what;
    EXPECT_EQ(noted(disks, kLawful, t, 1, 3), 0) << what;
    ComputedMotion motion = after(disks, kLawful, t);
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
    return std::vector<DiskInput>{disk(0, 0, 1, 0, along),
                                  disk(4, 4 + fault, Rational(9, 10), -1, along - 1),
                                  disk(-4, 4 + fault, Rational(9, 10), 1, along - 1)};
  };
  const std::vector<Pair> collisions{{0, 1}, {0, 2}};
  const double t = 4 - 1.9 / std::sqrt(2);
  EXPECT_EQ(noted(disks(0, 0), collisions, t, 1, 2), 1);
  EXPECT_EQ(noted(disks(kTiny, 0), collisions, t, 1, 2), 0);
  EXPECT_EQ(noted(disks(0, Rational(1, 8)), collisions, t, 1, 2), 0);
}

// A disk at rest in the origin, one that hits it, and the image of that by the rotation (a, b).
std::vector<DiskInput> turned(const Rational& a, const Rational& b) {
  const Rational spin(1, 4);
  return {disk(0, 0, 1, 0, 0), disk(4, 0, 1, -1, spin),
          disk(4 * a, 4 * b, 1, -a - b * spin, -b + a * spin)};
}

TEST(Carry, NearlyAQuarterTurnOrAHalf) {
  // Rotations by rational sines and cosines, as near as that to a right angle and to two.
  const Rational m = 1 / kTiny, d = m * m + 1;
  const Rational small = 2 * m / d, large = (m * m - 1) / d;
  const double t = (4 - std::sqrt(16 - 12 * 1.0625)) / 1.0625;
  const std::vector<Pair> two{{0, 1}, {0, 2}}, three{{0, 1}, {0, 2}, {0, 1}};
  EXPECT_EQ(noted(turned(0, 1), two, t, 1, 2), 1);
  EXPECT_EQ(noted(turned(0, -1), two, t, 1, 2), -1);
  for (const Rational& a : {small, Rational(-small)}) {
    EXPECT_EQ(noted(turned(a, large), two, t, 1, 2), 0);
  }
  const auto is_cradle = [&](const Rational& a, const Rational& b) {
    ComputedMotion motion = after(turned(a, b), three, t);
    note(motion, t);
    return motion.relations().cradle(1) != nullptr;
  };
  EXPECT_TRUE(is_cradle(-1, 0));
  EXPECT_FALSE(is_cradle(-large, small));
  EXPECT_FALSE(is_cradle(-large, -small));
}

// Disk 0 at rest in the origin, and two that hit it at once, images by a half turn.
std::vector<DiskInput> row() {
  return {disk(0, 0, 1, 0, 0), disk(4, 0, 1, -1, kSpin), disk(-4, 0, 1, 1, -kSpin)};
}

// The time at which they meet: (4 - t)^2 + (t / 4)^2 = 4.
double hit() { return (4 - std::sqrt(16 - 12 * (1 + kSpin * kSpin))) / (1 + kSpin * kSpin); }

const std::vector<Pair> kCradle{{0, 1}, {0, 2}, {0, 1}};

TEST(Carry, ACradle) {
  ComputedMotion motion = after(row(), kCradle, hit());
  EXPECT_TRUE(carried(motion, {1, 2}, {2, 1}).empty());
  EXPECT_FALSE(at_rest(motion, {0, motion.state_id(0)}));
  note(motion, hit());
  const auto found = carried(motion, {0, 1, 2}, {0, 2, 1});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_FALSE(found[0].reflects);
  EXPECT_TRUE(found[0]({1, 0}) == (Vector{-1, 0}));
  // The middle is as it was, at rest: any isometry that fixes it will do.
  EXPECT_TRUE(at_rest(motion, {0, motion.state_id(0)}));
  EXPECT_FALSE(at_rest(motion, {1, motion.state_id(1)}));
  EXPECT_EQ(carried(motion, {0}, {0}).size(), 2u);
  EXPECT_TRUE(carried(motion, {1}, {1}).size() == 1u);
  const MovingSite<Ball> at = motion.moving_site(0, Ball(Rational(3), 150));
  for (const Ball& x : {at.x, at.y, at.vx, at.vy}) EXPECT_EQ(sign(x), Sign::unknown);
}

TEST(Carry, ACradleThatMoves) {
  // The middle turns out as fast as it was, by whatever little that is.
  for (const Rational& v : {Rational(0), kTiny}) {
    std::vector<DiskInput> disks = row();
    for (DiskInput& d : disks) d.vx += v;
    ComputedMotion motion = after(disks, kCradle, hit());
    note(motion, hit());
    EXPECT_EQ(at_rest(motion, {0, motion.state_id(0)}), v == 0);
  }
}

TEST(Carry, ACradleThatIsNotOver) {
  ComputedMotion motion = after(row(), {{0, 1}, {0, 2}}, hit());
  note(motion, hit());
  EXPECT_EQ(motion.relations().cradle(1), nullptr);
  EXPECT_TRUE(carried(motion, {1}, {2}).empty());
}

TEST(Carry, NoCradleBesideATinyFault) {
  for (const int what : {0, 1, 2, 3, 4}) {
    std::vector<DiskInput> disks = row();
    if (what == 0) disks[1].x += kTiny;
    if (what == 1) disks[2].vy += kTiny;
    if (what == 2) disks[0].vx += kTiny;
    if (what == 3) disks[0].mass += kTiny;  // all orders of collisions end differently
    if (what == 4) disks[1].mass += kTiny;
    ComputedMotion motion = after(disks, kCradle, hit());
    note(motion, hit());
    EXPECT_EQ(motion.relations().cradle(1), nullptr) << what;
    EXPECT_FALSE(at_rest(motion, {0, motion.state_id(0)})) << what;
    EXPECT_TRUE(carried(motion, {1}, {2}).empty()) << what;
  }
  Scene soft = scene_of(30, 10, row());
  soft.restitution = 1 - kTiny;
  ComputedMotion motion(motion_input(soft), {});
  for (const Pair& c : kCradle) motion.collide(c.i, c.j, hit());
  note(motion, hit());
  EXPECT_EQ(motion.relations().cradle(1), nullptr);
}

TEST(Carry, TwoCradlesAtRightAngles) {
  // Four hit the disk in the centre, here images by quarter turns, and the law goes to and fro.
  std::vector<DiskInput> disks = row();
  disks.push_back(disk(0, 4, 1, -kSpin, -1));
  disks.push_back(disk(0, -4, 1, kSpin, 1));
  ComputedMotion motion = after(disks, {{0, 1}, {0, 3}, {0, 2}, {0, 1}, {0, 4}, {0, 3}}, hit());
  EXPECT_TRUE(carried(motion, {1, 3, 2, 4}, {3, 2, 4, 1}).empty());
  note(motion, hit());
  const auto found = carried(motion, {0, 1, 3, 2, 4}, {0, 3, 2, 4, 1});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0]({1, 0}) == (Vector{0, 1}));
  EXPECT_EQ(carried(motion, {0}, {0}).size(), 2u);
  EXPECT_TRUE(carried(motion, {1, 3}, {2, 3}).empty());
  for (const auto& [a, b] : {Pair{1, 3}, {3, 2}, {2, 4}, {4, 1}}) {
    const MovingSite<Ball> p = motion.moving_site(a, Ball(Rational(3), 150)),
                           q = motion.moving_site(b, Ball(Rational(3), 150));
    for (const Ball& difference : {p.x - q.y, p.y + q.x, p.vx - q.vy, p.vy + q.vx}) {
      EXPECT_EQ(sign(difference), Sign::unknown);
    }
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
