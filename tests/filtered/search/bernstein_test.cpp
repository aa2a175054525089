// The flip polynomial in doubles against the one formed over the rationals.
#include "filtered/search/bernstein.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <utility>

#include "filtered/computed/computed_motion.h"
#include "tests/filtered/search/flip_polynomials.h"
#include "tests/support/compact_arithmetic.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
namespace {

struct Tally {
  int one_sign = 0, formed = 0;
  int sharp = 0;  // the bound is less than 1e-9 of the largest coefficient
};

void expect_enclosed(const MotionInput& in, const Quad& q, double a, double b, Tally& tally) {
  const ComputedMotion motion(in, {});
  bool equal =
      q.l != container_id && q.r != container_id && q.s != container_id && q.e != container_id;
  for (const GenId g : {q.r, q.s, q.e}) {
    equal = equal && in.disks[g].radius == in.disks[q.l].radius;
  }
  ASSERT_EQ(flip_polynomial_is_cocircularity(motion, q), equal);
  const auto truth = true_coefficients(in, q, to_rational(a), to_rational(b), equal);
  BernsteinForm form{};
  if (form_flip_polynomial<true>(motion, q, a, b, form)) {
    ++tally.one_sign;
    for (const Rational& c : truth) {
      ASSERT_NE(sgn(c), 0);
      ASSERT_EQ(sgn(c), sgn(truth[0])) << "a root is lost in [" << a << ", " << b << "]";
    }
    return;
  }
  ++tally.formed;
  ASSERT_EQ(form.degree, equal ? 4 : 8);
  double largest = 0;
  for (int k = 0; k <= form.degree; ++k) {
    ASSERT_LE(abs(to_rational(form.c[k]) - truth[k]), to_rational(form.err))
        << "coefficient " << k << " over [" << a << ", " << b << "]";
    largest = std::fmax(largest, std::fabs(form.c[k]));
  }
  tally.sharp += form.err < 1e-9 * largest;
}

// Windows at any distance from the states' reference time 0, down to neighbouring doubles.
Tally expect_enclosed(const Family& family, bool with_container, int tries, std::uint64_t seed) {
  Random random(seed);
  Tally tally;
  for (int k = 0; k < tries && !::testing::Test::HasFatalFailure(); ++k) {
    const MotionInput in = random_input(family, random);
    const Quad q = random_quad(random, with_container);
    const double a = uniform(random, 0, k % 3 == 0 ? 500 : 30);
    const double width = std::ldexp(40.0, k % 2 == 0 ? 0 : -static_cast<int>(random() % 45));
    const double b = std::fmax(a + width, std::nextafter(a, 1000));
    expect_enclosed(in, q, a, b, tally);
  }
  return tally;
}

TEST(Bernstein, ContainsTheTrueCoefficients) {
  for (const bool with_container : {false, true}) {
    for (const Rational& unit : {Rational(1), Rational(3)}) {
      Family family;
      family.unit = unit;
      const Tally t = expect_enclosed(family, with_container, 300, 1);
      // Both answers occur.
      EXPECT_GT(t.one_sign, 50);
      EXPECT_GT(t.formed, 20);
    }
  }
}

TEST(Bernstein, DegreeFourForEqualRadii) {
  for (const Rational& unit : {Rational(1), Rational(3)}) {
    Family family;
    family.equal_radii = true;
    family.unit = unit;
    Tally t = expect_enclosed(family, false, 300, 2);
    EXPECT_GT(t.one_sign, 50);
    EXPECT_GT(t.formed, 20);
    // With the container the radii are not equal.
    t = expect_enclosed(family, true, 100, 3);
    EXPECT_GT(t.formed, 5);
  }
}

TEST(Bernstein, ManyMagnitudes) {
  for (const auto& [extent, speed] :
       {std::pair(1e-6, 1e-3), std::pair(1e6, 1e-6), std::pair(1e3, 1e5), std::pair(100.0, 0.0)}) {
    for (const bool equal : {false, true}) {
      Family family;
      family.extent = extent;
      family.speed = speed;
      family.common_speed = false;
      family.equal_radii = equal;
      expect_enclosed(family, false, 100, 4);
    }
  }
}

// Far from the origin the centres are known less well than the generators' offsets from each other
// can be computed.
TEST(Bernstein, FarFromTheOrigin) {
  for (const double away : {1e3, 1e6}) {
    for (const bool equal : {false, true}) {
      Family family;
      family.away = away;
      family.equal_radii = equal;
      family.unit = 3;
      const Tally t = expect_enclosed(family, false, 100, 11);
      EXPECT_GT(t.formed, 5);
    }
  }
}

// The bound must be small, not only right: over an ordinary window, at an ordinary time.
TEST(Bernstein, TheBoundIsSmall) {
  Random random(5);
  for (const bool equal : {false, true}) {
    Family family;
    family.equal_radii = equal;
    Tally tally;
    for (int k = 0; k < 200; ++k) {
      expect_enclosed(random_input(family, random), random_quad(random, false), 10, 40, tally);
    }
    EXPECT_GT(tally.formed, 50);
    EXPECT_GT(tally.sharp, 0.9 * tally.formed);
  }
}

// Without certificates the same coefficients and no bound.
TEST(Bernstein, UncertifiedForm) {
  Random random(6);
  int formed = 0;
  for (int k = 0; k < 100; ++k) {
    const ComputedMotion motion(random_input({}, random), {});
    const Quad q = random_quad(random, k % 2 == 0);
    BernsteinForm certified{}, plain{};
    if (form_flip_polynomial<true>(motion, q, 5, 25, certified)) continue;
    if (form_flip_polynomial<false>(motion, q, 5, 25, plain)) continue;
    ++formed;
    EXPECT_EQ(plain.err, 0);
    EXPECT_EQ(plain.c, certified.c);
  }
  EXPECT_GT(formed, 20);
}

// Cotangent at the start of the window: the first true coefficient is zero, its rounded value
// hardly ever. Without an error bound the other coefficients' sign would often be that of all.
TEST(Bernstein, ARootAtTheEndIsNotLost) {
  Random random(8);
  for (const bool equal : {false, true}) {
    Tally tally;
    for (int k = 0; k < 400 && !HasFatalFailure(); ++k) {
      Family family;
      family.equal_radii = equal;
      MotionInput in = random_input(family, random);
      for (DiskInput& d : in.disks) {
        // At a rational point of the circle that touches all from inside.
        const Rational m = uniform(random, -2, 2), n = 1 + m * m, reach = 50 + d.radius;
        d.x = Rational(reach * (1 - m * m) / n);
        d.y = Rational(reach * 2 * m / n);
      }
      expect_enclosed(in, {0, 1, 2, 3}, 0, 1e-3, tally);
    }
    EXPECT_EQ(tally.one_sign, 0);
  }
}

// Radii that no double tells apart are equal only if their values are, whichever of the four
// the odd one is and whether or not it is the one that a double holds.
TEST(Bernstein, RadiiOfOneDoubleAreNotEqualForThat) {
  Random random(7);
  const Rational hair(Integer(1), Integer(1) << 100);
  for (const Rational& common : {Rational(1), Rational(1, 3)}) {
    Family family;
    family.equal_radii = true;
    MotionInput in = random_input(family, random);
    const Quad q{0, 1, 2, 3};
    for (DiskInput& d : in.disks) d.radius = common;
    const auto degree = [&] {
      BernsteinForm form{};
      form_flip_polynomial<true>(ComputedMotion(in, {}), q, 0, 1, form);
      return form.degree;
    };
    EXPECT_TRUE(flip_polynomial_is_cocircularity(ComputedMotion(in, {}), q));
    EXPECT_EQ(degree(), 4);
    for (int odd = 0; odd < 4; ++odd) {
      in.disks[odd].radius = Rational(common + hair);
      EXPECT_FALSE(flip_polynomial_is_cocircularity(ComputedMotion(in, {}), q)) << odd;
      EXPECT_EQ(degree(), 8) << odd;
      in.disks[odd].radius = common;
    }
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
