// The two filters' numbers: no ball ever loses the true value, no sign is ever wrong.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "filtered/numbers/dd_ball.h"
#include "filtered/numbers/double_ball.h"
#include "filtered/numbers/next_double.h"
#include "tests/filtered/reference.h"

namespace voroproof::internal::testing {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLeast = std::numeric_limits<double>::denorm_min();

Reference center(const DoubleBall& b) { return Reference(b.mid); }
Reference center(const DdBall& b) { return Reference(b.hi, b.lo); }

// A ball without a meaning (after an overflow, a division by zero) says so by its sign.
bool finite(const DoubleBall& b) { return std::isfinite(b.mid) && std::isfinite(b.rad); }
bool finite(const DdBall& b) {
  return std::isfinite(b.hi) && std::isfinite(b.lo) && std::isfinite(b.rad);
}

template <class B>
std::string fault(const B& ball, const Reference& truth) {
  const Sign s = sign(ball);
  if (!finite(ball)) return s == Sign::unknown ? "" : "the sign of a ball without meaning";
  if (!truth.within(center(ball), ball.rad)) return "the ball has lost the value";
  if (!truth.may_have(s)) return "the sign is wrong";
  return "";
}

DoubleBall make(DoubleBall, double hi, double, double rad) { return {hi, rad}; }
DdBall make(DdBall, double hi, double lo, double rad) { return {hi, lo, rad}; }

// A number from an integer: 53 bits of significand with many short ones, exponents from a range.
struct Range {
  int low, high;
};

double number(std::uint64_t code, Range range) {
  code *= 0x9E3779B97F4A7C15u;
  const int exponent = range.low + static_cast<int>((code >> 8) % (range.high - range.low + 1));
  const int bits = code & 1 ? 53 : 1 + static_cast<int>((code >> 1) % 6);
  const double m = 1 + std::ldexp(static_cast<double>(code >> (64 - bits)), -bits);
  return std::ldexp(code & 128 ? -m : m, exponent);
}

template <class B>
struct Value {
  B ball;
  Reference truth;
};

// A ball of a radius that is zero or some part of its midpoint, and a number at its rim or inside.
template <class B>
Value<B> leaf(std::uint64_t code, Range range) {
  const double hi = number(code, range);
  const std::uint64_t kind = code * 0xD1342543DE82EF95u >> 32;
  double lo = 0;
  if (std::is_same_v<B, DdBall> && kind % 3 == 0) {
    lo = number(code + 77, {-2, -1}) * std::ldexp(std::fabs(hi), -53);
  }
  double rad = 0;
  if (kind / 3 % 2 == 0) rad = std::ldexp(std::fabs(hi), -static_cast<int>(kind / 6 % 110));
  const double part = 0.5 * (static_cast<int>(kind / 1000 % 5) - 2);
  return {make(B(), hi, lo, rad), Reference(hi, lo) + Reference(rad) * Reference(part)};
}

// Straight-line programs: leaves, then operations with any two values at hand.
template <class B>
void expect_contained(Range range) {
  const auto codes = *rc::gen::container<std::vector<std::uint64_t>>(
      4, rc::gen::inRange<std::uint64_t>(0, std::uint64_t{1} << 40));
  std::vector<Value<B>> values;
  for (const std::uint64_t code : codes) values.push_back(leaf<B>(code, range));
  // What cancels: the same number again, and a neighbour.
  values.push_back(values.front());
  const double near = std::nextafter(center(values[1].ball).rounded(), kInfinity);
  values.push_back({B(near), Reference(near)});
  const auto steps = *rc::gen::container<std::vector<int>>(40, rc::gen::inRange(0, 6 * 46 * 46));
  for (const int step : steps) {
    const Value<B> a = values[step / 6 % values.size()], b = values[step / 276 % values.size()];
    Value<B> out;
    switch (step % 6) {
      case 0:
        out = {a.ball + b.ball, a.truth + b.truth};
        break;
      case 1:
        out = {a.ball - b.ball, a.truth - b.truth};
        break;
      case 2:
        out = {a.ball * b.ball, a.truth * b.truth};
        break;
      case 3:
        out.ball = a.ball / b.ball;
        if (b.truth.may_have(Sign::zero)) {
          RC_ASSERT(!finite(out.ball));
          continue;
        }
        out.truth = a.truth / b.truth;
        break;
      case 4:
        out = {-a.ball, -a.truth};
        break;
      case 5:
        if (a.truth.may_have(Sign::negative)) continue;
        out = {sqrt(a.ball), sqrt(a.truth)};
        break;
    }
    RC_ASSERT(fault(out.ball, out.truth) == std::string());
    // Balls that say nothing are not worth a step.
    if (finite(out.ball)) values.push_back(out);
  }
}

constexpr Range kOrdinary{-8, 8}, kWide{-150, 150}, kHuge{900, 1023}, kSmall{-1074, -930},
    kAnything{-1074, 1023};

RC_GTEST_PROP(DoubleBallContains, OrdinaryNumbers, ()) { expect_contained<DoubleBall>(kOrdinary); }
RC_GTEST_PROP(DoubleBallContains, WideRange, ()) { expect_contained<DoubleBall>(kWide); }
RC_GTEST_PROP(DoubleBallContains, Overflow, ()) { expect_contained<DoubleBall>(kHuge); }
RC_GTEST_PROP(DoubleBallContains, Underflow, ()) { expect_contained<DoubleBall>(kSmall); }
RC_GTEST_PROP(DoubleBallContains, Anything, ()) { expect_contained<DoubleBall>(kAnything); }

RC_GTEST_PROP(DdBallContains, OrdinaryNumbers, ()) { expect_contained<DdBall>(kOrdinary); }
RC_GTEST_PROP(DdBallContains, WideRange, ()) { expect_contained<DdBall>(kWide); }
RC_GTEST_PROP(DdBallContains, Overflow, ()) { expect_contained<DdBall>(kHuge); }
RC_GTEST_PROP(DdBallContains, Underflow, ()) { expect_contained<DdBall>(kSmall); }
RC_GTEST_PROP(DdBallContains, Anything, ()) { expect_contained<DdBall>(kAnything); }

// A filter that never decides is right, too: of exact operands results are known to all but a
// few of the bits there are.
template <class B>
void expect_tight(int bits) {
  for (std::uint64_t code = 1; code < 2000; ++code) {
    const double x = number(code, kWide), y = number(code + 5000, kWide);
    for (const B& result :
         {B(x) * B(y), B(x) / B(y), B(x) + B(y), B(x) - B(y), sqrt(B(std::fabs(x)))}) {
      const double size = std::fabs(center(result).rounded());
      ASSERT_LE(result.rad, std::ldexp(size, -bits) + 1e-300) << x << " " << y;
    }
  }
}

TEST(DoubleBall, IsTight) { expect_tight<DoubleBall>(52); }
TEST(DdBall, IsTight) { expect_tight<DdBall>(99); }

TEST(DoubleBall, SignsAtTheRim) {
  EXPECT_EQ(sign(DoubleBall(0)), Sign::zero);
  EXPECT_EQ(sign(DoubleBall(1, 1)), Sign::unknown);  // contains zero
  EXPECT_EQ(sign(DoubleBall(-1, 1)), Sign::unknown);
  EXPECT_EQ(sign(DoubleBall(0, kLeast)), Sign::unknown);
  EXPECT_EQ(sign(DoubleBall(1, std::nextafter(1, 0))), Sign::positive);
  EXPECT_EQ(sign(DoubleBall(-kLeast)), Sign::negative);
  EXPECT_EQ(sign(DoubleBall(1) / DoubleBall(1, 1)), Sign::unknown);
  EXPECT_EQ(sign(DoubleBall(std::numeric_limits<double>::quiet_NaN())), Sign::unknown);
}

TEST(DdBall, SignsAtTheRim) {
  EXPECT_EQ(sign(DdBall(0)), Sign::zero);
  EXPECT_EQ(sign(DdBall(1, 0, 1)), Sign::unknown);
  EXPECT_EQ(sign(DdBall(-1, 0, 1)), Sign::unknown);
  EXPECT_EQ(sign(DdBall(1, -0x1p-60, 1 - 0x1p-49)), Sign::positive);
  // hi exceeds the radius, hi + lo does not.
  EXPECT_NE(sign(DdBall(1, -0x1p-54, std::nextafter(1, 0))), Sign::positive);
  EXPECT_EQ(sign(DdBall(-kLeast)), Sign::negative);
  EXPECT_EQ(sign(DdBall(1) / DdBall(1, 0, 1)), Sign::unknown);
}

// Where the leading parts cancel the others are all that is left, with all their bits.
TEST(DdBall, CancellationOfTheLeadingParts) {
  for (std::uint64_t code = 1; code < 2000; ++code) {
    const double hi = std::fabs(number(code, kOrdinary)), unit = hi * 0x1p-54;
    const double x = unit * number(code + 3000, {-20, -1});
    const double y = unit * number(code + 6000, {-20, -1});
    const DdBall difference = DdBall(hi, x) - DdBall(hi, y);
    ASSERT_EQ(fault(difference, Reference(hi, x) - Reference(hi, y)), "") << x << " " << y;
  }
}

TEST(NextDouble, IsTheNeighbour) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr double most = std::numeric_limits<double>::max();
  constexpr double least = std::numeric_limits<double>::denorm_min();
  for (const double x : {0.0, -0.0, 1.0, -1.0, 0.75, 0x1p-1022, -0x1p-1022, least, -least, most,
                         -most, inf, -inf, 1e300, -3e-310}) {
    EXPECT_EQ(next_above(x), std::nextafter(x, inf)) << x;
    EXPECT_EQ(next_below(x), std::nextafter(x, -inf)) << x;
  }
}

TEST(DoubleBall, HullContainsBothEnds) {
  for (std::uint64_t code = 1; code < 5000; ++code) {
    for (const Range range : {kOrdinary, kAnything}) {
      const double x = number(code, range), y = number(code + 9000, range);
      const double lo = std::fmin(x, y), hi = std::fmax(x, y);
      const DoubleBall hull = DoubleBall::hull(lo, hi);
      if (!finite(hull)) continue;
      ASSERT_TRUE(Reference(lo).within(center(hull), hull.rad)) << lo << " " << hi;
      ASSERT_TRUE(Reference(hi).within(center(hull), hull.rad)) << lo << " " << hi;
    }
  }
}

// The radius of the quotient of tiny balls is itself a quotient of tiny numbers, whose
// numerator underflowed to zero.
TEST(DoubleBall, QuotientOfTinyBallsContainsTheQuotient) {
  const double a = 0x1p-1060, b = 0x1p-1000, rad = 0x1p-1020;
  const DoubleBall quotient = DoubleBall(a) / DoubleBall(b, rad);
  EXPECT_EQ(fault(quotient, Reference(a) / Reference(b, rad)), "");
  EXPECT_EQ(fault(quotient, Reference(a) / Reference(b, -rad)), "");
}

}  // namespace
}  // namespace voroproof::internal::testing
