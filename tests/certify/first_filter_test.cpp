// What the certifier believes of doubles, against rationals.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "certify/path.h"
#include "certify/rootless.h"
#include "filtered/computed/computed_motion.h"
#include "tests/support/compact_arithmetic.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
namespace {

MotionInput random_input(double extent, double largest_radius, const Rational& unit,
                         Random& random) {
  MotionInput in;
  in.container_radius = Rational(2 * extent) / unit;
  in.horizon = 100;
  const auto any = [&](double size) -> Rational {
    return Rational(uniform(random, -size, size)) / unit;
  };
  for (int k = 0; k < 4; ++k) {
    in.disks.push_back({any(extent), any(extent),
                        Rational(Rational(uniform(random, 0, largest_radius)) / unit), any(3),
                        any(3), 1});
  }
  return in;
}

int cotangency_sign(const MotionInput& in, const Quad& q, double t) {
  const auto site = [&](GenId g) -> Site<Rational> {
    if (g == container_id) {
      return {in.container_x, in.container_y, Rational(-in.container_radius)};
    }
    const DiskInput& d = in.disks[g];
    const Rational s = to_rational(t);
    return {d.x + d.vx * s, d.y + d.vy * s, d.radius};
  };
  return sgn(cotangency(site(q.l), site(q.r), site(q.s), site(q.e)));
}

// A root of the polynomial between two doubles that are neighbours, or nothing.
std::optional<std::array<double, 2>> some_root(const MotionInput& in, const Quad& q,
                                               Random& random) {
  constexpr double step = 2;
  double lo = uniform(random, 0, step);
  const int before = cotangency_sign(in, q, lo);
  while (lo < 100 && cotangency_sign(in, q, lo + step) == before) lo += step;
  if (lo >= 100) return std::nullopt;
  double hi = lo + step;
  while (std::nextafter(lo, hi) < hi) {
    const double middle = 0.5 * (lo + hi);
    if (!(lo < middle && middle < hi)) break;
    (cotangency_sign(in, q, middle) == before ? lo : hi) = middle;
  }
  return std::array{lo, hi};
}

// Intervals that end next to a root, before and beyond it, at every distance down to neighbours.
TEST(RootlessBatch, NoRootIsLost) {
  Random random(3);
  int proved = 0, made = 0, with_root = 0;
  for (const auto& [extent, radius, unit] :
       {std::tuple{100.0, 60.0, 1}, {100.0, 10.0, 1}, {100.0, 60.0, 3}, {1000.0, 900.0, 1}}) {
    for (int k = 0; k < 40; ++k) {
      const MotionInput in = random_input(extent, radius, unit, random);
      const ComputedMotion motion(in, {});
      Quad q{0, 1, 2, 3};
      if (k % 3 == 0) q.s = container_id;
      const auto root = some_root(in, q, random);
      if (!root) continue;
      RootlessBatch batch(motion);
      std::vector<std::array<double, 2>> spans;
      for (int n = 0; n < 40; ++n) {
        const double distance = std::ldexp(uniform(random, 1, 2), -n);
        const double length = std::ldexp(uniform(random, 1, 2), -static_cast<int>(random() % 20));
        spans.push_back({(*root)[0] - distance - length, (*root)[0] - distance});
        spans.push_back({(*root)[1] + distance, (*root)[1] + distance + length});
        spans.push_back({(*root)[0] - length, (*root)[1] + distance});
      }
      for (const auto& [a, b] : spans) batch.add(q, a, b);
      batch.prove();
      for (std::size_t n = 0; n < spans.size(); ++n) {
        const auto [a, b] = spans[n];
        ++made;
        const int sign = cotangency_sign(in, q, a);
        const bool around = n % 3 == 2;
        with_root += around;
        if (!batch.rootless(n)) continue;
        ++proved;
        ASSERT_FALSE(around) << "[" << a << ", " << b << "]";
        for (int part = 0; part <= 8; ++part) {
          const double t = part == 8 ? b : a + (b - a) * 0.125 * part;
          ASSERT_EQ(cotangency_sign(in, q, t), sign) << t << " in [" << a << ", " << b << "]";
        }
      }
    }
  }
  EXPECT_GT(with_root, 1000);
  EXPECT_GT(proved, made / 4);
  EXPECT_LT(proved, made - with_root);
}

// Eight disks, of which the first four are to be those of a V-edge that flips and the others those
// beyond the edges beside it; or the container in place of the fourth.
struct EightDisks {
  MotionInput in;
  Quad q{0, 1, 2, 3};
  std::array<GenId, 4> outer{4, 5, 6, 7};

  EightDisks(double largest_radius, const Rational& unit, bool container, Random& random)
      : in(random_input(100, largest_radius, unit, random)) {
    const MotionInput more = random_input(100, 20, 1, random);
    in.disks.insert(in.disks.end(), more.disks.begin(), more.disks.end());
    if (container) q.e = container_id;
  }
};

// The edges around a flip, and short intervals: what is proved of them is so.
TEST(RootlessBatch, AroundAFlip) {
  Random random(5);
  int proved = 0, proved_after = 0, same = 0, same_after = 0;
  for (int k = 0; k < 300; ++k) {
    const auto [in, q, outer] =
        EightDisks(k % 2 == 0 ? 40 : 5, k % 3 == 0 ? 3 : 1, k % 4 == 0, random);
    const ComputedMotion motion(in, {});
    std::array<double, 4> from{};
    const double b = uniform(random, 1, 20);
    for (double& a : from)
      a = b - std::ldexp(uniform(random, 0, 1), static_cast<int>(random() % 8));
    const std::array<std::array<GenId, 2>, 4> ring{
        {{q.r, q.e}, {q.e, q.l}, {q.l, q.s}, {q.s, q.r}}};
    const std::array<GenId, 4> before{q.l, q.r, q.r, q.l}, after{q.s, q.s, q.e, q.e};
    RootlessBatch around(motion), alone(motion);
    // Brackets of flips are shorter than most of these.
    const double since = b - std::ldexp(1, -static_cast<int>(10 + random() % 24));
    around.prove_around(q, outer, from, since, b);
    for (int n = 0; n < 4; ++n) {
      alone.add({ring[n][0], ring[n][1], outer[n], before[n]}, from[n], b);
    }
    alone.prove();
    for (int n = 0; n < 4; ++n) {
      proved += around.rootless(n);
      same += around.rootless(n) == alone.rootless(n) && around.one_root(n) == alone.one_root(n);
    }
    alone.clear();
    for (int n = 0; n < 4; ++n) alone.add({ring[n][0], ring[n][1], outer[n], after[n]}, since, b);
    alone.prove_instant();
    for (int n = 0; n < 4; ++n) {
      same_after += around.rootless_flipped(n) == alone.rootless(n);
      if (!around.rootless_flipped(n)) continue;
      ++proved_after;
      const Quad now{ring[n][0], ring[n][1], outer[n], after[n]};
      const int sign = cotangency_sign(in, now, b);
      ASSERT_NE(sign, 0);
      for (int part = 0; part < 8; ++part) {
        ASSERT_EQ(cotangency_sign(in, now, since + (b - since) * 0.125 * part), sign);
      }
    }
  }
  // In another order of the four the bound is another one, which tells over long intervals; after
  // the flip it is one for twice the interval, and for where the four have been since `from`.
  EXPECT_GE(same, 1190);
  EXPECT_GE(same_after, 1150);
  EXPECT_GT(proved, 600);
  EXPECT_GT(proved_after, 600);
}

// An edge beside a flip whose own root, after the flip, is in the short interval.
TEST(RootlessBatch, NoRootIsLostBesideAFlip) {
  Random random(11);
  int with_root = 0;
  for (int k = 0; k < 60; ++k) {
    const auto [in, q, outer] = EightDisks(40, 1, k % 4 == 0, random);
    const ComputedMotion motion(in, {});
    const std::array<Quad, 4> flipped{Quad{q.r, q.e, outer[0], q.s},
                                      {q.e, q.l, outer[1], q.s},
                                      {q.l, q.s, outer[2], q.e},
                                      {q.s, q.r, outer[3], q.e}};
    for (int n = 0; n < 4; ++n) {
      const auto root = some_root(in, flipped[n], random);
      if (!root) continue;
      ++with_root;
      for (int bits = 0; bits < 40; bits += 3) {
        const double wide = std::ldexp(uniform(random, 0.5, 1), -bits);
        const double since = (*root)[0] - wide, b = (*root)[1] + wide;
        RootlessBatch batch(motion);
        batch.prove_around(q, outer, {since - 1, since, since - wide, since - 4}, since, b);
        ASSERT_FALSE(batch.rootless_flipped(n)) << "[" << since << ", " << b << "]";
      }
    }
  }
  EXPECT_GT(with_root, 100);
}

TEST(MostRoots, ByDescartesRule) {
  EXPECT_EQ(most_roots(0b111111111, 0), 0);
  EXPECT_EQ(most_roots(0, 0b111111111), 0);
  EXPECT_EQ(most_roots(0b000011111, 0b111100000), 1);
  EXPECT_EQ(most_roots(0b000011111, 0b111110000), 1);  // one may be both, where the sign changes
  EXPECT_EQ(most_roots(0b111111111, 0b000000001), 1);  // or at an end
  EXPECT_EQ(most_roots(0b111111111, 0b100000000), 1);
  EXPECT_EQ(most_roots(0b111111111, 0b000000010), 2);
  EXPECT_EQ(most_roots(0b111111111, 0b000000011), 2);
  EXPECT_EQ(most_roots(0b000011111, 0b111111000), 2);
  EXPECT_EQ(most_roots(0b000011111, 0b111100001), 2);
  EXPECT_EQ(most_roots(0b111111111, 0b111111111), 2);
}

// A sum as long as a disk's path, with every kind of number.
TEST(DyadicSum, IsExact) {
  Random random(4);
  for (int k = 0; k < 200; ++k) {
    double t = 0;
    DyadicSum sum(uniform(random, -100, 100));
    Rational truth = sum.exact();
    for (int step = 0; step < 60; ++step) {
      const double next =
          t + std::ldexp(uniform(random, 0, 1), static_cast<int>(random() % 40) - 35);
      const double v =
          step % 7 == 0 ? 0
                        : std::ldexp(uniform(random, -1, 1), static_cast<int>(random() % 30) - 20);
      ASSERT_TRUE(sum.add_way(v, next, t));
      truth += to_rational(v) * (to_rational(next) - to_rational(t));
      t = next;
      ASSERT_EQ(sum.exact(), truth);
      const DdBall near = sum.near();
      ASSERT_LE(abs(Rational(to_rational(near.hi) + to_rational(near.lo) - truth)),
                to_rational(near.rad));
      ASSERT_LE(std::fabs(near.lo), 0x1p-53 * std::fabs(near.hi));
    }
  }
  // What doubles cannot hold is not taken.
  EXPECT_FALSE(DyadicSum(1).add_way(1e-200, 1e-200, 0));
  EXPECT_FALSE(DyadicSum(1).add_way(1e200, 1e200, 0));
  EXPECT_FALSE(DyadicSum(1).add_way(5e-324, 1, 0));
}

TEST(DyadicSum, StaysAsItIsWhereItWouldBeTooLong) {
  DyadicSum sum(1);
  for (const double part : {0x1p-60, 0x1p-120, 0x1p-180}) ASSERT_TRUE(sum.add_way(part, 1, 0));
  const Rational truth = sum.exact();
  EXPECT_FALSE(sum.add_way(0x1p-240, 1, 0));
  EXPECT_EQ(sum.exact(), truth);
  ASSERT_TRUE(sum.add_way(-0x1p-180, 1, 0));
  EXPECT_TRUE(sum.add_way(0x1p-240, 1, 0));
}

TEST(Path, TurnsFromDoublesToRationals) {
  Path path(1, 2, Velocity(Vec2{0.5, -0.25}));
  path.turn(3.0, Velocity(Vec2{0.1, 0.2}));
  ASSERT_TRUE(path.near(4));
  EXPECT_EQ(path.at(3), (ExactVec2{Rational(5, 2), Rational(5, 4)}));
  const Rational third(10, 3);
  const ExactVec2 there = path.at(third);
  path.turn(third, Velocity(ExactVec2{Rational(1, 7), Rational(0)}));
  EXPECT_FALSE(path.near(4));
  EXPECT_FALSE(path.start());
  EXPECT_EQ(path.since(), third);
  EXPECT_EQ(path.at(third), there);
  EXPECT_EQ(path.at(third + 7), (ExactVec2{there[0] + 1, there[1]}));
  path.turn(5.0, Velocity(Vec2{1, 1}));
  EXPECT_FALSE(path.near(6));
  EXPECT_EQ(path.at(6), (ExactVec2{there[0] + Rational(5, 21) + 1, there[1] + 1}));
}

// Where doubles hold one coordinate and not the other, both go on from where they were.
TEST(Path, TurnsToRationalsWithBothCoordinates) {
  for (const bool first : {false, true}) {
    const double small = 1e-200;
    const Vec2 v = first ? Vec2{small, 0.5} : Vec2{0.5, small};
    Path path(1, 2, Velocity(v));
    path.turn(small, Velocity(Vec2{1, 1}));
    EXPECT_FALSE(path.start());
    const Rational t = to_rational(small);
    EXPECT_EQ(path.at(t), (ExactVec2{1 + to_rational(v[0]) * t, 2 + to_rational(v[1]) * t}));
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
