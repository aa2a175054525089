// The form in which collapses are searched for, against the flip polynomial over the rationals: its
// bounds hold, and what C tells for nearly equal radii is true.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "filtered/computed/computed_motion.h"
#include "filtered/search/bernstein.h"
#include "tests/filtered/search/flip_polynomials.h"
#include "tests/support/compact_arithmetic.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
namespace {

// Of C for nearly equal radii: the coefficients are those of C itself, which no radius enters, and
// where a value of it is beyond the bound f is negative. Both happen: values that tell and that do
// not, f of either sign.
TEST(Bernstein, OfNearlyEqualRadiiCTellsWhereFIsNegative) {
  Random random(9);
  int one_sign = 0, told = 0, hidden = 0, positive = 0;
  for (int k = 0; k < 300 && !HasFatalFailure(); ++k) {
    Family family;
    family.equal_radii = true;
    MotionInput in = random_input(family, random);
    const Quad q = random_quad(random, false);
    const double a = uniform(random, 0, 30), b = a + std::ldexp(40.0, -static_cast<int>(k % 12));
    const auto truth = true_coefficients(in, q, to_rational(a), to_rational(b), true);
    const double difference = std::ldexp(1.0, -14 - static_cast<int>(random() % 40));
    for (DiskInput& d : in.disks) d.radius = Rational(5 + uniform(random, 0, difference));
    const ComputedMotion motion(in, {});
    BernsteinForm form{};
    const bool free = form_for_collapse(motion, q, a, b, form);
    if (form.spread == 0) continue;
    ASSERT_EQ(form.degree, 4);
    one_sign += free;
    for (std::size_t c = 0; !free && c < truth.size(); ++c) {
      ASSERT_LE(abs(to_rational(form.c[c]) - truth[c]), to_rational(form.err));
    }
    // The value at a part x of the window, without rounding.
    const auto value = [&](const Rational& x) {
      std::vector<Rational> w(form.c.begin(), form.c.begin() + 5);
      for (int last = 4; last > 0; --last) {
        for (int c = 0; c < last; ++c) w[c] = (1 - x) * w[c] + x * w[c + 1];
      }
      return w[0];
    };
    const auto check = [&](const Rational& x) {
      const Rational t = to_rational(a) + x * (to_rational(b) - to_rational(a));
      std::array<Site<Rational>, 4> at;
      const GenId ids[4] = {q.l, q.r, q.s, q.e};
      for (int g = 0; g < 4; ++g) {
        const DiskInput& d = in.disks[ids[g]];
        at[g] = {d.x + t * d.vx, d.y + t * d.vy, d.radius.value()};
      }
      const int f = sgn(cotangency(at[0], at[1], at[2], at[3]));
      positive += f > 0;
      const bool tells = free || abs(value(x)) > to_rational(form.err);
      ++(tells ? told : hidden);
      ASSERT_TRUE(!tells || f < 0) << "at " << round_nearest(t);
    };
    for (int part = 0; part <= 8; ++part) ASSERT_NO_FATAL_FAILURE(check(Rational(part, 8)));
    if (free || value(0) * value(1) > 0) continue;
    // Towards a root of C, where f is positive.
    Rational left = 0, right = 1;
    for (int halving = 0; halving < 60; ++halving) {
      const Rational middle = (left + right) / 2;
      ASSERT_NO_FATAL_FAILURE(check(middle));
      (value(left) * value(middle) > 0 ? left : right) = middle;
    }
  }
  EXPECT_GT(one_sign, 50);
  EXPECT_GT(told, 1000);
  EXPECT_GT(hidden, 100);
  EXPECT_GT(positive, 100);
}

// The bounds that grow with the coefficient hold for each, and where generators go far the first is
// far below the one for all.
TEST(Bernstein, GrowingBounds) {
  Random random(10);
  int finite = 0, finer = 0;
  for (int k = 0; k < 400 && !HasFatalFailure(); ++k) {
    Family family;
    family.extent = 20;
    family.away = k % 5 == 0 ? 1e5 : 0;
    family.common_speed = k % 2 == 0;
    family.unit = k % 3 == 0 ? 3 : 1;
    const MotionInput in = random_input(family, random);
    const Quad q = random_quad(random, k % 4 == 0);
    const double a = uniform(random, 0, 30), b = a + std::ldexp(500.0, -static_cast<int>(k % 10));
    const ComputedMotion motion(in, {});
    BernsteinForm form{};
    if (form_for_collapse(motion, q, a, b, form) || form.degree != 8) continue;
    if (!(form.bound.first < form.err)) continue;
    ++finite;
    finer += form.bound.first < 1e-6 * form.err;
    const auto truth = true_coefficients(in, q, to_rational(a), to_rational(b), false);
    Rational bound = to_rational(form.bound.first);
    for (int c = 0; c <= 8; ++c) {
      ASSERT_LE(abs(to_rational(form.c[c]) - truth[c]), bound) << "coefficient " << c;
      bound *= to_rational(form.bound.growth);
    }
  }
  EXPECT_GT(finite, 50);
  EXPECT_GT(finer, 20);
}

// Where coefficients overflow no bound may be finite, the growing one neither: over windows as long
// as the generators are far apart, of lengths from 2^112 to 2^132.
TEST(Bernstein, NoBoundIsFiniteWhereCoefficientsOverflow) {
  Random random(11);
  int overflowed = 0, finite = 0;
  for (int k = 0; k < 4000 && !HasFatalFailure(); ++k) {
    Family family;
    family.extent = 20;
    family.common_speed = false;
    MotionInput in = random_input(family, random);
    const Rational scale(Integer(1) << (112 + k % 21));
    in.container_x *= scale;
    in.container_y *= scale;
    in.container_radius *= scale;
    for (DiskInput& d : in.disks) {
      d = {d.x * scale, d.y * scale, d.radius * scale, d.vx * scale, d.vy * scale, 1};
    }
    const ComputedMotion motion(in, {});
    BernsteinForm form{};
    if (form_for_collapse(motion, {0, 1, 2, 3}, 0, 200, form) || form.degree != 8) continue;
    const bool all =
        std::all_of(form.c.begin(), form.c.end(), [](double c) { return std::isfinite(c); });
    overflowed += !all;
    finite += std::isfinite(form.bound.first);
    ASSERT_TRUE(all || !std::isfinite(form.bound.first));
  }
  EXPECT_GT(overflowed, 50);
  EXPECT_GT(finite, 50);
}

}  // namespace
}  // namespace voroproof::internal::testing
