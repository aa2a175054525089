// The flip polynomial in doubles against the one formed over the rationals.
#include "filtered/search/bernstein.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "exact/polynomial.h"
#include "tests/support/compact_arithmetic.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
namespace {

using RationalPolynomial = Polynomial<Rational>;

// How the four (and more) disks of a motion are made; they may overlap, which means nothing to
// the polynomial.
struct Family {
  double extent = 100;       // of the centres
  double away = 0;           // how far they are from the origin together
  double speed = 3;          // one common speed, or the largest
  bool common_speed = true;  // the velocities lie on a circle: the degree falls
  bool equal_radii = false;
  Rational unit = 1;  // everything is divided by it: 3 makes numbers that no double holds
};

MotionInput random_input(const Family& family, Random& random) {
  MotionInput in;
  in.container_x = 1 / family.unit;
  in.container_y = -2 / family.unit;
  in.container_radius = Rational(2 * family.extent) / family.unit;
  in.horizon = 100;
  for (int k = 0; k < 5; ++k) {
    const double angle = uniform(random, 0, 2 * std::numbers::pi);
    const double speed = family.common_speed ? family.speed : uniform(random, 0, family.speed);
    const double extent = family.extent;
    const auto in_units = [&](double x) -> Rational { return Rational(x) / family.unit; };
    in.disks.push_back({in_units(family.away + uniform(random, -extent, extent)),
                        in_units(family.away + uniform(random, -extent, extent)),
                        in_units(family.equal_radii ? 5 : uniform(random, 0, 10)),
                        in_units(speed * std::cos(angle)), in_units(speed * std::sin(angle)), 1});
  }
  return in;
}

Quad random_quad(Random& random, bool with_container) {
  std::array<GenId, 5> ids{0, 1, 2, 3, 4};
  std::shuffle(ids.begin(), ids.end(), random);
  if (with_container) ids[random() % 4] = container_id;
  return {ids[0], ids[1], ids[2], ids[3]};
}

// The generator over the window [a, b], a polynomial in the window's parameter.
Site<RationalPolynomial> path(const MotionInput& in, GenId g, const Rational& a,
                              const Rational& b) {
  if (g == container_id) {
    return {{in.container_x}, {in.container_y}, {Rational(-in.container_radius)}};
  }
  const DiskInput& d = in.disks[g];
  const Rational width = b - a;
  return {RationalPolynomial{d.x + a * d.vx, width * d.vx},
          RationalPolynomial{d.y + a * d.vy, width * d.vy}, RationalPolynomial{d.radius.value()}};
}

// The Bernstein coefficients of the given degree.
std::vector<Rational> bernstein(const RationalPolynomial& f, int degree) {
  const auto binomial = [](int n, int k) {
    Integer result;
    mpz_bin_uiui(result.get_mpz_t(), static_cast<unsigned long>(n), static_cast<unsigned long>(k));
    return Rational(result);
  };
  EXPECT_LE(f.degree(), degree);
  std::vector<Rational> c;
  for (int k = 0; k <= degree; ++k) {
    Rational sum = 0;
    for (int i = 0; i <= std::min(k, f.degree()); ++i) {
      sum += binomial(k, i) / binomial(degree, i) * f[i];
    }
    c.push_back(sum);
  }
  return c;
}

std::vector<Rational> true_coefficients(const MotionInput& in, const Quad& q, const Rational& a,
                                        const Rational& b, bool equal_radii) {
  const auto s = [&](GenId g) { return path(in, g, a, b); };
  // The base of the cocircularity is the last site, as everywhere in filtered/.
  return equal_radii ? bernstein(cocircularity(s(q.e), s(q.l), s(q.r), s(q.s)), 4)
                     : bernstein(cotangency(s(q.l), s(q.r), s(q.s), s(q.e)), 8);
}

struct Tally {
  int one_sign = 0, formed = 0;
  int sharp = 0;  // the bound is less than 1e-9 of the largest coefficient
};

void expect_enclosed(const MotionInput& in, const Quad& q, double a, double b, Tally& tally) {
  const Motion motion(in, {});
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
    const Motion motion(random_input({}, random), {});
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
    const Motion motion(in, {});
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
    const Motion motion(in, {});
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
    const Motion motion(in, {});
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
      form_flip_polynomial<true>(Motion(in, {}), q, 0, 1, form);
      return form.degree;
    };
    EXPECT_TRUE(flip_polynomial_is_cocircularity(Motion(in, {}), q));
    EXPECT_EQ(degree(), 4);
    for (int odd = 0; odd < 4; ++odd) {
      in.disks[odd].radius = Rational(common + hair);
      EXPECT_FALSE(flip_polynomial_is_cocircularity(Motion(in, {}), q)) << odd;
      EXPECT_EQ(degree(), 8) << odd;
      in.disks[odd].radius = common;
    }
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
