// Balls of limbs against rational arithmetic: every operation encloses its value, and tightly.
#include "exact/limb_ball.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace voroproof {
namespace {

Rational power_of_two(std::int64_t exponent) {
  Rational q = 1;
  if (exponent >= 0) {
    q <<= static_cast<unsigned long>(exponent);
  } else {
    q >>= static_cast<unsigned long>(-exponent);
  }
  return q;
}

Rational midpoint_of(const Ball& b) {
  Rational q;
  mpfr_get_q(q.get_mpq_t(), b.midpoint());
  return q;
}

// Above the radius, by less than a factor of two.
Rational radius_of(const Ball& b) {
  return b.is_exact() ? Rational(0) : power_of_two(b.radius().exponent() + 1);
}

// A ball and a number inside it.
struct Sample {
  Ball ball;
  LimbBall limbs;
  Rational value;
};

class Samples {
 public:
  explicit Samples(unsigned seed) : random_(seed) {}
  long below(long n) { return static_cast<long>(random_() % static_cast<unsigned long>(n)); }

  // Zero, short, long; mostly of one size, so that sums cancel.
  Sample next(Ball::Precision bits) {
    Sample s;
    const long kind = below(20);
    Integer n = kind == 0 ? 0 : 1;
    const long size = kind < 5 ? below(64) : below(static_cast<long>(bits) + 1);
    const bool ones = below(8) == 0;
    for (long k = 0; k < size; ++k) n = 2 * n + (ones ? 1 : below(2));
    s.value = Rational(n) * power_of_two((kind < 15 ? 0 : below(600) - 300) - size);
    if (below(2) == 0) s.value = -s.value;
    s.ball = Ball(s.value, bits);
    if (below(3) != 0) {
      const std::int64_t e = -below(2 * static_cast<long>(bits));
      s.ball.widen(Magnitude::power_of_two(e));
      s.value += power_of_two(e) * Rational(below(2001) - 1000, 1000);
    }
    s.limbs.set(s.ball);
    return s;
  }

 private:
  std::mt19937_64 random_;
};

Ball get(const LimbBall& b, Ball::Precision bits) {
  Ball out;
  b.get(out, bits);
  return out;
}

constexpr Ball::Precision kBits[] = {64, 128, 192, 448, 1024};

TEST(LimbBall, HoldsWhatItWasGiven) {
  Samples samples(1);
  for (int k = 0; k < 3000; ++k) {
    const Ball::Precision bits = kBits[samples.below(5)];
    const Sample s = samples.next(bits);
    const Ball back = get(s.limbs, bits);
    EXPECT_EQ(midpoint_of(back), midpoint_of(s.ball));
    EXPECT_EQ(radius_of(back), radius_of(s.ball));
    EXPECT_EQ(s.limbs.sign(), s.ball.sign());
    const double x = std::ldexp(static_cast<double>(samples.below(1L << 60)) - (1L << 59),
                                static_cast<int>(samples.below(1800)) - 900);
    LimbBall b;
    b.set(x);
    EXPECT_EQ(midpoint_of(get(b, 128)), to_rational(x));
    EXPECT_TRUE(get(b, 128).is_exact());
    // Shorter than it is: enclosed.
    const Ball cut = get(s.limbs, 64);
    EXPECT_LE(abs(Rational(midpoint_of(cut) - midpoint_of(s.ball))), radius_of(cut));
  }
}

// `value` lies in the ball. Where the operands are exact the radius is at most that of `bits` bits,
// of the largest number involved.
void expect_enclosure(const LimbBall& out, const Rational& value, Ball::Precision bits,
                      bool exact_operands, const Rational& size) {
  const Ball b = get(out, bits + 192);
  ASSERT_LE(abs(Rational(value - midpoint_of(b))), radius_of(b));
  if (exact_operands) {
    ASSERT_LE(radius_of(b), size * power_of_two(3 - bits));
  }
}

TEST(LimbBall, OperationsEncloseTheirValues) {
  Samples samples(2);
  LimbArithmetic with;
  for (int k = 0; k < 20000; ++k) {
    const Ball::Precision bits = kBits[samples.below(5)];
    with.set_precision(bits);
    // Operands may be longer than results.
    const Sample a = samples.next(samples.below(4) == 0 ? bits + 64 : bits), b = samples.next(bits);
    const bool exact = a.ball.is_exact() && b.ball.is_exact();
    const Rational sum_size = std::max<Rational>(abs(a.value), abs(b.value));
    LimbBall out;
    with.add(out, a.limbs, b.limbs);
    expect_enclosure(out, a.value + b.value, bits, exact, sum_size);
    with.sub(out, a.limbs, b.limbs);
    expect_enclosure(out, a.value - b.value, bits, exact, sum_size);
    const Rational product = a.value * b.value;
    with.mul(out, a.limbs, b.limbs);
    expect_enclosure(out, product, bits, exact, abs(product));
    with.sqr(out, a.limbs);
    expect_enclosure(out, a.value * a.value, bits, exact, a.value * a.value);
    // In place.
    out = a.limbs;
    with.sub(out, out, b.limbs);
    expect_enclosure(out, a.value - b.value, bits, exact, sum_size);
    out = b.limbs;
    with.mul(out, a.limbs, out);
    expect_enclosure(out, product, bits, exact, abs(product));
  }
}

TEST(LimbBall, QuotientsAndRootsEncloseTheirValues) {
  Samples samples(3);
  LimbArithmetic with;
  int quotients = 0, roots = 0;
  for (int k = 0; k < 10000; ++k) {
    const Ball::Precision bits = kBits[samples.below(5)];
    with.set_precision(bits);
    const Sample a = samples.next(bits), b = samples.next(bits);
    LimbBall out;
    with.div(out, a.limbs, b.limbs);
    if (b.ball.sign() == Sign::unknown || b.ball.sign() == Sign::zero) {
      EXPECT_EQ(out.sign(), Sign::unknown);
      EXPECT_GT(out.radius().exponent(), 1 << 20);
    } else {
      ++quotients;
      const Rational quotient = a.value / b.value;
      expect_enclosure(out, quotient, bits, a.ball.is_exact() && b.ball.is_exact(), abs(quotient));
    }
    with.sqrt(out, a.limbs);
    if (a.ball.sign() == Sign::zero) {
      EXPECT_EQ(out.sign(), Sign::zero);
    } else if (a.ball.sign() != Sign::positive) {
      EXPECT_EQ(out.sign(), Sign::unknown);
      EXPECT_GT(out.radius().exponent(), 1 << 20);
    } else {
      ++roots;
      const Ball root = get(out, bits + 192);
      const Rational low = midpoint_of(root) - radius_of(root);
      const Rational high = midpoint_of(root) + radius_of(root);
      EXPECT_TRUE(sgn(low) <= 0 || low * low <= a.value);
      EXPECT_GE(high * high, a.value);
      if (a.ball.is_exact()) {
        EXPECT_LE(radius_of(root), high * power_of_two(3 - bits));
      }
    }
  }
  EXPECT_GT(quotients, 5000);
  EXPECT_GT(roots, 2000);
}

// Squares have exact roots, exact quotients are exact.
TEST(LimbBall, ExactResultsHaveNoRadius) {
  LimbArithmetic with;
  with.set_precision(256);
  for (const double x : {3.0, 0.1, 1e200, 1e-200, 5e-324}) {
    LimbBall a, square, out;
    a.set(x);
    with.sqr(square, a);
    with.sqrt(out, square);
    EXPECT_TRUE(out.radius().is_zero());
    EXPECT_EQ(midpoint_of(get(out, 128)), to_rational(x));
    with.div(out, square, a);
    EXPECT_TRUE(out.radius().is_zero());
    EXPECT_EQ(midpoint_of(get(out, 128)), to_rational(x));
    with.sub(out, a, a);
    EXPECT_EQ(out.sign(), Sign::zero);
    a.negate();
    EXPECT_EQ(a.sign(), Sign::negative);
  }
}

}  // namespace
}  // namespace voroproof
