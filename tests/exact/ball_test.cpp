// Balls as double-doubles: for all precisions, exponents and patterns of bits.
#include "exact/ball.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/exact/powers.h"

namespace voroproof::internal {
namespace {

using testing::power_of_two;

// A number of `bits` bits, the first of them 1, the others in runs of zeros and ones: of the length
// of a limb, of the parts into which the conversion cuts it, and less.
Integer in_runs(int bits, std::mt19937_64& random) {
  constexpr int lengths[] = {1, 1, 2, 10, 11, 12, 52, 53, 54, 63, 64, 65, 128};
  Integer n = 1;
  int size = 1;
  while (size < bits) {
    const int length = std::min(bits - size, lengths[random() % std::size(lengths)]);
    const unsigned kind = random() % 3;
    for (int k = 0; k < length; ++k) n = 2 * n + (kind == 2 ? random() % 2 : kind);
    size += length;
  }
  return n;
}

struct Parts {
  double hi = 0, lo = 0, err = 0;
  explicit Parts(const Ball& b) { b.to_double_double(hi, lo, err); }
};

TEST(BallAsDoubleDouble, IsWithinItsBound) {
  std::mt19937_64 random(1);
  int inexact = 0;
  for (int k = 0; k < 60000; ++k) {
    const int bits = 60 + static_cast<int>(random() % 400);
    // The precision of the ball may be above that of the number: zeros follow.
    const int precision = random() % 2 ? bits : bits + static_cast<int>(random() % 200);
    const long exponent = static_cast<long>(random() % 1900) - 950 - bits;
    Rational value = Rational(in_runs(bits, random)) * power_of_two(exponent);
    if (random() % 2) value = -value;
    const Ball ball(value, precision);
    ASSERT_TRUE(ball.is_exact());
    const Parts p(ball);
    const Rational off = abs(Rational(value - to_rational(p.hi) - to_rational(p.lo)));
    ASSERT_LE(off, to_rational(p.err)) << value << " at " << precision;
    // Normalized: hi is a nearest double.
    ASSERT_LE(2 * to_rational(std::fabs(p.lo)),
              to_rational(std::nextafter(std::fabs(p.hi), INFINITY) - std::fabs(p.hi)));
    // Tight, where lo is a normal number.
    if (std::fabs(p.hi) > 1e-200) {
      ASSERT_LE(p.err, 0x1p-102 * std::fabs(p.hi));
    }
    inexact += sgn(off) != 0;
  }
  EXPECT_GT(inexact, 20000);
}

TEST(BallAsDoubleDouble, SubnormalsOverflowAndZero) {
  for (const long e : {-1200L, -1090L, -1075L, -1060L, -1000L, -810L, -799L, 890L, 905L, 1023L}) {
    for (const int sign : {1, -1}) {
      const Rational value =
          sign * (power_of_two(e) + power_of_two(e - 60) + power_of_two(e - 150));
      const Parts p(Ball(value, 200));
      ASSERT_TRUE(std::isfinite(p.hi));
      EXPECT_LE(abs(Rational(value - to_rational(p.hi) - to_rational(p.lo))), to_rational(p.err))
          << e;
    }
  }
  const Parts huge(Ball(power_of_two(1100), 200));
  EXPECT_EQ(huge.err, INFINITY);
  const Parts zero(Ball(Rational(0), 200));
  EXPECT_EQ(zero.hi, 0);
  EXPECT_EQ(zero.lo, 0);
  EXPECT_EQ(zero.err, 0);
}

// What is exact as two doubles stays so, at any precision.
TEST(BallAsDoubleDouble, NumbersOfTwoDoublesAreExact) {
  for (const int precision : {110, 128, 129, 192, 256, 1000}) {
    const Rational values[] = {3, power_of_two(-70) + 1, 1 - power_of_two(-100),
                               -power_of_two(53) - power_of_two(-3)};
    for (const Rational& value : values) {
      const Parts p(Ball(value, precision));
      EXPECT_EQ(to_rational(p.hi) + to_rational(p.lo), value);
      EXPECT_EQ(p.err, 0) << value << " at " << precision;
    }
  }
}

TEST(BallAsDoubleDouble, TheRadiusIsInTheBound) {
  Ball ball(Rational(1, 3), 300);
  const double before = Parts(ball).err;
  ball.widen(Magnitude::power_of_two(-50));
  EXPECT_GE(Parts(ball).err, before + 0x1p-50);
  EXPECT_LE(Parts(ball).err, 1.01 * 0x1p-50);
}

}  // namespace
}  // namespace voroproof::internal
