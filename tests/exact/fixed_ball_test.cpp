// Fixed-point balls against rational arithmetic: every operation encloses its value, and tightly.
#include "exact/fixed_ball.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "tests/exact/ball_values.h"

namespace voroproof::internal {
namespace {

using testing::power_of_two;
using testing::radius_of;

// A ball and a number inside it.
struct Sample {
  Ball ball;
  FixedBall fixed;
  Rational value;
};

struct Format {
  Ball::Precision bits;
  int integer_limbs;
  std::int64_t radius_exponent;
};

constexpr std::int64_t kUnit = 7;  // of all numbers here

class Samples {
 public:
  explicit Samples(unsigned seed) : random_(seed) {}
  long below(long n) { return static_cast<long>(random_() % static_cast<unsigned long>(n)); }

  Format format() {
    constexpr Ball::Precision bits[] = {64, 128, 192, 448, 1024};
    const Ball::Precision b = bits[below(5)];
    return {b, 1 + static_cast<int>(below(2)), -below(b + 1)};
  }

  // Zero, short, long; mostly of one size, so that sums cancel; some without room to spare before
  // the point.
  Sample next(const Format& f, FixedArithmetic& with) {
    Sample s;
    const long kind = below(20);
    Integer n = kind == 0 ? 0 : 1;
    const long size = kind < 5 ? below(64) : below(static_cast<long>(f.bits) + 1);
    const bool ones = below(8) == 0;
    for (long k = 0; k < size; ++k) n = 2 * n + (ones ? 1 : below(2));
    const long exponent = kind < 15 ? 0 : kind == 19 ? 64L * f.integer_limbs - 4 : -below(f.bits);
    s.value = Rational(n) * power_of_two(exponent + kUnit - size);
    if (below(2) == 0) s.value = -s.value;
    s.ball = Ball(s.value, f.bits + 64);
    if (below(3) != 0) {
      const std::int64_t e = kUnit - below(2 * static_cast<long>(f.bits));
      s.ball.widen(Magnitude::power_of_two(e));
      s.value += power_of_two(e) * Rational(below(2001) - 1000, 1000);
    }
    with.set(s.fixed, s.ball, kUnit);
    s.value /= power_of_two(kUnit);
    return s;
  }

 private:
  std::mt19937_64 random_;
};

// Of what is to be read in the units of the numbers.
Ball get(FixedArithmetic& with, const FixedBall& b, Ball::Precision bits) {
  return with.view(b).ball(0, bits);
}

bool is_unknown(const Ball& b) { return !b.is_finite(); }

// What a format can tell apart: the last place, or the least radius.
Rational last_place(const Format& f) {
  return power_of_two(std::max<std::int64_t>(-f.bits, f.radius_exponent - 800));
}

TEST(FixedBall, HoldsWhatItWasGiven) {
  Samples samples(1);
  FixedArithmetic with;
  for (int k = 0; k < 3000; ++k) {
    const Format f = samples.format();
    with.set_format(f.bits, f.integer_limbs, f.radius_exponent);
    const Sample s = samples.next(f, with);
    const Ball back = with.view(s.fixed).ball(kUnit, f.bits + 128);
    const Rational off = abs(Rational(back.midpoint() - s.ball.midpoint()));
    EXPECT_LE(off, last_place(f) * power_of_two(kUnit));
    EXPECT_LE(off + radius_of(s.ball) / 2, radius_of(back));
    EXPECT_LE(radius_of(back), 2 * radius_of(s.ball) + 4 * last_place(f) * power_of_two(kUnit));
    if (with.sign(s.fixed) != Sign::unknown) {
      EXPECT_EQ(with.sign(s.fixed), s.ball.sign());
    }
    // Shorter than it is: enclosed.
    const Ball cut = get(with, s.fixed, 64);
    EXPECT_LE(abs(Rational(cut.midpoint() * power_of_two(kUnit) - back.midpoint())),
              radius_of(cut) * power_of_two(kUnit));
    const double x = std::ldexp(static_cast<double>(samples.below(1L << 60)) - (1L << 59),
                                static_cast<int>(samples.below(80)) - 90);
    FixedBall b;
    with.set(b, x, 5);
    const Ball held = with.view(b).ball(5, f.bits + 128);
    EXPECT_LE(abs(Rational(held.midpoint() - to_rational(x))), radius_of(held));
    EXPECT_TRUE(held.is_exact() || f.bits < 192);
  }
}

// Numbers stored in one format and read in another, or as double-doubles: enclosed, and exact where
// nothing is cut off.
TEST(FixedBall, KeepsItsValueBetweenFormats) {
  Samples samples(4);
  FixedArithmetic with;
  int cut = 0, short_ones = 0, unknown = 0;
  for (int k = 0; k < 5000; ++k) {
    const Format f = samples.format(), g = samples.format();
    with.set_format(f.bits, f.integer_limbs, f.radius_exponent);
    const std::array<Sample, 4> s{samples.next(f, with), samples.next(f, with),
                                  samples.next(f, with), samples.next(f, with)};
    FixedRow row;
    with.store(row, {&s[0].fixed, &s[1].fixed, &s[2].fixed, &s[3].fixed});
    std::array<Ball, 4> held;
    for (int j = 0; j < 4; ++j) {
      held[j] = get(with, s[j].fixed, f.bits + 128);
      const Ball stored = row.view(j).ball(0, f.bits + 128);
      ASSERT_EQ(is_unknown(stored), is_unknown(held[j]));
      if (is_unknown(stored)) continue;
      EXPECT_EQ(stored.midpoint(), held[j].midpoint());
      EXPECT_EQ(radius_of(stored), radius_of(held[j]));
    }
    with.set_format(g.bits, g.integer_limbs, g.radius_exponent);
    for (int j = 0; j < 4; ++j) {
      if (is_unknown(held[j])) continue;
      FixedBall other;
      with.set(other, row.view(j));
      const Ball back = get(with, other, 1024 + 128);
      const Rational off = abs(Rational(back.midpoint() - held[j].midpoint()));
      if (is_unknown(back)) {
        ++unknown;
        EXPECT_GE(2 * (abs(held[j].midpoint()) + 1), power_of_two(64L * g.integer_limbs - 1));
      } else {
        EXPECT_LE(off + radius_of(held[j]) / 2, radius_of(back));
        EXPECT_LE(off, last_place(g));
        EXPECT_LE(radius_of(back), 2 * radius_of(held[j]) + 4 * last_place(g));
        if (off != 0) ++cut;
        if (g.bits >= f.bits && held[j].is_exact()) {
          EXPECT_TRUE(back.is_exact());
          EXPECT_EQ(off, 0);
        }
      }
      double hi = 0, lo = 0, err = 0;
      row.view(j).to_double_double(kUnit, hi, lo, err);
      const Rational value = held[j].midpoint() * power_of_two(kUnit);
      const Rational radius = radius_of(held[j]) * power_of_two(kUnit);
      const Rational error = abs(Rational(value - to_rational(hi) - to_rational(lo)));
      EXPECT_LE(error + radius / 2, to_rational(err));
      EXPECT_LE(to_rational(err), radius * Rational(1025, 1024) + abs(value) * power_of_two(-100) +
                                      power_of_two(-1000));
      if (err == 0) ++short_ones;
    }
  }
  EXPECT_GT(cut, 2000);
  EXPECT_GT(short_ones, 500);
  EXPECT_GT(unknown, 100);
}

// `value` lies in the ball. Where the operands are exact the radius is that of a few places.
void expect_enclosure(FixedArithmetic& with, const FixedBall& out, const Rational& value,
                      const Format& f, bool exact_operands) {
  const Ball b = get(with, out, f.bits + 64 * f.integer_limbs);
  if (is_unknown(b)) {
    // There is no room for it before the point, or there was none for a ball's midpoint.
    ASSERT_TRUE(!exact_operands || abs(value) * 4 >= power_of_two(64L * f.integer_limbs - 1));
    return;
  }
  ASSERT_LE(abs(Rational(value - b.midpoint())), radius_of(b));
  if (exact_operands) {
    ASSERT_LE(radius_of(b), 8 * last_place(f));
  }
}

TEST(FixedBall, OperationsEncloseTheirValues) {
  Samples samples(2);
  FixedArithmetic with;
  for (int k = 0; k < 20000; ++k) {
    const Format f = samples.format();
    with.set_format(f.bits, f.integer_limbs, f.radius_exponent);
    const Sample a = samples.next(f, with), b = samples.next(f, with);
    const bool exact =
        get(with, a.fixed, 1024 + 128).is_exact() && get(with, b.fixed, 1024 + 128).is_exact();
    FixedBall out;
    with.add(out, a.fixed, b.fixed);
    expect_enclosure(with, out, a.value + b.value, f, exact);
    with.sub(out, a.fixed, b.fixed);
    expect_enclosure(with, out, a.value - b.value, f, exact);
    const Rational product = a.value * b.value;
    with.mul(out, a.fixed, b.fixed);
    expect_enclosure(with, out, product, f, exact);
    with.sqr(out, a.fixed);
    expect_enclosure(with, out, a.value * a.value, f, exact);
    with.add_product(out, b.fixed, a.fixed, b.fixed);
    expect_enclosure(with, out, b.value + product, f, exact);
    with.sub_product(out, a.fixed, a.fixed, b.fixed);
    expect_enclosure(with, out, a.value - product, f, exact);
    with.sum_of_products(out, a.fixed, b.fixed, b.fixed, b.fixed);
    expect_enclosure(with, out, product + b.value * b.value, f, exact);
    with.difference_of_products(out, a.fixed, a.fixed, b.fixed, a.fixed);
    expect_enclosure(with, out, a.value * a.value - product, f, exact);
    // In place.
    out = a.fixed;
    with.sub(out, out, b.fixed);
    expect_enclosure(with, out, a.value - b.value, f, exact);
    out = b.fixed;
    with.mul(out, a.fixed, out);
    expect_enclosure(with, out, product, f, exact);
    with.negate(out);
    expect_enclosure(with, out, -product, f, exact);
    out = a.fixed;
    with.add_product(out, out, out, b.fixed);
    expect_enclosure(with, out, a.value + product, f, exact);
    out = b.fixed;
    with.difference_of_products(out, a.fixed, out, out, out);
    expect_enclosure(with, out, product - b.value * b.value, f, exact);
  }
}

TEST(FixedBall, QuotientsAndRootsEncloseTheirValues) {
  Samples samples(3);
  FixedArithmetic with;
  int quotients = 0, roots = 0;
  for (int k = 0; k < 10000; ++k) {
    const Format f = samples.format();
    with.set_format(f.bits, f.integer_limbs, f.radius_exponent);
    const Sample a = samples.next(f, with), b = samples.next(f, with);
    const Ball held_a = get(with, a.fixed, f.bits + 128);
    FixedBall out;
    with.div(out, a.fixed, b.fixed);
    const Sign sign_b = with.sign(b.fixed);
    const Ball quotient = get(with, out, f.bits + 128);
    if (sign_b == Sign::unknown || sign_b == Sign::zero) {
      EXPECT_TRUE(is_unknown(quotient));
    } else if (!is_unknown(quotient)) {
      ++quotients;
      ASSERT_LE(abs(Rational(a.value / b.value - quotient.midpoint())), radius_of(quotient));
      if (held_a.is_exact() && get(with, b.fixed, f.bits + 128).is_exact()) {
        EXPECT_LE(radius_of(quotient), 4 * last_place(f));
      }
    }
    with.sqrt(out, a.fixed);
    const Sign sign_a = with.sign(a.fixed);
    if (sign_a == Sign::zero) {
      EXPECT_EQ(with.sign(out), Sign::zero);
    } else if (sign_a != Sign::positive) {
      EXPECT_TRUE(is_unknown(get(with, out, 64)));
    } else {
      ++roots;
      const Ball root = get(with, out, f.bits + 128);
      const Rational low = root.midpoint() - radius_of(root);
      const Rational high = root.midpoint() + radius_of(root);
      EXPECT_TRUE(sgn(low) <= 0 || low * low <= a.value);
      EXPECT_GE(high * high, a.value);
      if (held_a.is_exact()) {
        EXPECT_LE(radius_of(root), 4 * last_place(f));
      }
    }
  }
  EXPECT_GT(quotients, 4000);
  EXPECT_GT(roots, 2000);
}

// Squares have exact roots, exact quotients are exact.
TEST(FixedBall, ExactResultsHaveNoRadius) {
  FixedArithmetic with;
  with.set_format(512, 1, -400);
  for (const double x : {3.0, 0.1, -1e9, 1e-30}) {
    FixedBall a, square, out;
    with.set(a, x, 0);
    with.sqr(square, a);
    with.sqrt(out, square);
    EXPECT_TRUE(get(with, out, 512).is_exact());
    EXPECT_EQ(get(with, out, 512).midpoint(), to_rational(std::fabs(x)));
    with.div(out, square, a);
    EXPECT_TRUE(get(with, out, 512).is_exact());
    EXPECT_EQ(get(with, out, 512).midpoint(), to_rational(x));
    with.sub(out, a, a);
    EXPECT_EQ(with.sign(out), Sign::zero);
    with.negate(a);
    EXPECT_EQ(with.sign(a), x > 0 ? Sign::negative : Sign::positive);
  }
}

TEST(FixedBall, WhatIsNotFiniteIsUnknown) {
  FixedArithmetic with;
  with.set_format(256, 1, -200);
  Ball wide(1.0, 64);
  wide.widen(Magnitude::infinite());
  for (const Ball& b : {Ball(INFINITY, 64), Ball(std::nan(""), 64), wide}) {
    FixedBall a;
    with.set(a, b, 0);
    EXPECT_EQ(with.sign(a), Sign::unknown);
    EXPECT_TRUE(is_unknown(get(with, a, 256)));
  }
}

// Radii that are far below and far above the unit that was chosen for them keep their meaning.
TEST(FixedBall, RadiiOfAnySizeAreBounds) {
  FixedArithmetic with;
  for (const std::int64_t unit : {-4096, -2000, -10}) {
    with.set_format(4096, 1, unit);
    for (const std::int64_t e : {-6000, -4000, -3000, -40}) {
      Ball one(1.0, 64);
      one.widen(Magnitude::power_of_two(e));
      FixedBall a;
      with.set(a, one, 0);
      for (int k = 0; k < 20; ++k) with.sqr(a, a);
      const Ball b = get(with, a, 4096);
      EXPECT_FALSE(b.is_exact());
      EXPECT_GE(b.radius().exponent(), e + 20);
      if (e < unit + 900 && e > unit - 700) {
        EXPECT_LE(b.radius().exponent(), e + 22);
      }
    }
  }
}

}  // namespace
}  // namespace voroproof::internal
