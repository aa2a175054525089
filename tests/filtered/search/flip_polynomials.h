// Flip polynomials formed over the rationals, of random disks.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "exact/polynomial.h"
#include "exact/predicates.h"
#include "filtered/motion/motion.h"
#include "tests/support/compact_arithmetic.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {

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

inline MotionInput random_input(const Family& family, Random& random) {
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

inline Quad random_quad(Random& random, bool with_container) {
  std::array<GenId, 5> ids{0, 1, 2, 3, 4};
  std::shuffle(ids.begin(), ids.end(), random);
  if (with_container) ids[random() % 4] = container_id;
  return {ids[0], ids[1], ids[2], ids[3]};
}

// The generator over the window [a, b], a polynomial in the window's parameter.
inline Site<RationalPolynomial> path(const MotionInput& in, GenId g, const Rational& a,
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
inline std::vector<Rational> bernstein(const RationalPolynomial& f, int degree) {
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

inline std::vector<Rational> true_coefficients(const MotionInput& in, const Quad& q,
                                               const Rational& a, const Rational& b,
                                               bool equal_radii) {
  const auto s = [&](GenId g) { return path(in, g, a, b); };
  // The base of the cocircularity is the last site, as everywhere in filtered/.
  return equal_radii ? bernstein(cocircularity(s(q.e), s(q.l), s(q.r), s(q.s)), 4)
                     : bernstein(cotangency(s(q.l), s(q.r), s(q.s), s(q.e)), 8);
}

}  // namespace voroproof::internal::testing
