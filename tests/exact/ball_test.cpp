// Balls: what they must not lose between the forms they are held in, as double-doubles (for all
// precisions, exponents and patterns of bits) and as binary64, and where they know nothing.
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

// A ball and a number inside it.
struct Sample {
  Ball ball;
  Rational value;
};

Sample sample(std::mt19937_64& random) {
  const int bits = 2 + static_cast<int>(random() % 300);
  Sample s;
  s.value = Rational(in_runs(1 + static_cast<int>(random() % bits), random)) *
            power_of_two(static_cast<long>(random() % 40) - 20 - bits);
  if (random() % 2) s.value = -s.value;
  s.ball = Ball(s.value, 64 + bits);
  if (random() % 3) {
    const std::int64_t e = -static_cast<std::int64_t>(random() % 200);
    s.ball.widen(Magnitude::power_of_two(e));
    s.value += power_of_two(e) * Rational(static_cast<long>(random() % 2001) - 1000, 1000);
  }
  return s;
}

bool contains(const Ball& b, const Rational& x) {
  if (!b.is_finite()) return true;
  const auto [lo, hi] = b.rational_interval();
  return lo <= x && x <= hi;
}

TEST(Ball, OperationsContainTheirValues) {
  std::mt19937_64 random(2);
  int unknown = 0, divided = 0;
  for (int k = 0; k < 20000; ++k) {
    const Sample a = sample(random), b = sample(random);
    ASSERT_TRUE(contains(a.ball + b.ball, a.value + b.value));
    ASSERT_TRUE(contains(a.ball - b.ball, a.value - b.value));
    ASSERT_TRUE(contains(a.ball * b.ball, a.value * b.value));
    ASSERT_TRUE(contains(-a.ball, -a.value));
    ASSERT_TRUE(contains(sqrt(a.ball * a.ball), abs(a.value)));
    ASSERT_TRUE(contains(a.ball.at_precision(20), a.value));
    if (sgn(b.value) != 0) {
      ASSERT_TRUE(contains(a.ball / b.ball, a.value / b.value));
    }
    const Sign sign = a.ball.sign();
    ASSERT_TRUE(sign == Sign::unknown || sign == sign_of(sgn(a.value)));
    unknown += sign == Sign::unknown;
    divided += (a.ball / b.ball).is_finite();
    double low = 0, high = 0, nearest = 0;
    a.ball.to_interval(low, high);
    ASSERT_LE(to_rational(low), a.value);
    ASSERT_GE(to_rational(high), a.value);
    if (a.ball.round_to_double(nearest)) {
      ASSERT_EQ(nearest, round_nearest(a.value));
    }
  }
  EXPECT_GT(unknown, 1000);
  EXPECT_GT(divided, 10000);
}

TEST(Ball, ZeroHasNoSign) {
  Ball zero(Rational(0), 100);
  zero.widen(Magnitude::power_of_two(-1200));
  double nearest = 1;
  EXPECT_TRUE(zero.round_to_double(nearest));
  EXPECT_EQ(nearest, 0);
  EXPECT_FALSE(std::signbit(nearest));
}

// A predicate is not to be decided from a quotient or a root that need not exist.
TEST(Ball, KnowsNothingOfWhatDoesNotExist) {
  Ball near_zero(Rational(1, 1000), 100);
  near_zero.widen(Magnitude::power_of_two(-9));
  Ball negative(Rational(-1, 3), 100);
  for (const Ball& none : {Ball(1.0, 64) / near_zero, Ball(1.0, 64) / Ball(64),
                           sqrt(Ball(-1.0, 64)), sqrt(negative)}) {
    EXPECT_FALSE(none.is_finite());
    EXPECT_EQ(none.sign(), Sign::unknown);
    EXPECT_EQ((none - none).sign(), Sign::unknown);
    EXPECT_EQ((none * Ball(64)).sign(), Sign::unknown);
    double lo = 0, hi = 0, nearest = 0, rest = 0, err = 0;
    none.to_interval(lo, hi);
    EXPECT_EQ(lo, -INFINITY);
    EXPECT_EQ(hi, INFINITY);
    EXPECT_FALSE(none.round_to_double(nearest));
    none.to_double_double(nearest, rest, err);
    EXPECT_EQ(err, INFINITY);
  }
  negative.widen(Magnitude::power_of_two(-1));
  EXPECT_TRUE(contains(sqrt(negative), Rational(2, 5)));  // of 0.16, and -1/3 + 1/2 > 0.16
  EXPECT_TRUE(sqrt(negative).is_finite());
}

}  // namespace
}  // namespace voroproof::internal
