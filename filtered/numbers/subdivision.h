// Polynomials in the Bernstein basis in numbers with error bounds of their own,
// double-doubles and balls: the scheme of filtered/numbers/double_roots.h, value by value.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "exact/ball.h"
#include "exact/predicates.h"
#include "filtered/numbers/dd_ball.h"
#include "filtered/numbers/form.h"
#include "filtered/numbers/sign_variations.h"

namespace voroproof::internal {

struct MakeDd {
  DdBall operator()(const Rational& q) const {
    const double hi = voroproof::internal::round_nearest(q);
    const Rational rest = q - to_rational(hi);
    const double lo = voroproof::internal::round_nearest(rest);
    const Rational left = rest - to_rational(lo);
    return {hi, lo,
            sgn(left) == 0 ? 0.0 : std::fabs(lo) * 0x1p-52 + std::numeric_limits<double>::min()};
  }
  // A ball around the interval.
  DdBall hull(const Rational& lo, const Rational& hi) const {
    DdBall m = (*this)(Rational((lo + hi) / 2));
    m.rad = (m.rad + voroproof::internal::round_up(Rational((hi - lo) / 2))) * (1 + 0x1p-50);
    return m;
  }
};

struct MakeBall {
  int bits;
  Ball operator()(const Rational& q) const { return Ball(q, bits); }
  Ball hull(const Rational& lo, const Rational& hi) const {
    Ball m(Rational((lo + hi) / 2), bits);
    const Rational half = (hi - lo) / 2;
    if (sgn(half) > 0) {
      // 2^e >= half, from the sizes of numerator and denominator.
      const long e = static_cast<long>(mpz_sizeinbase(half.get_num_mpz_t(), 2)) -
                     static_cast<long>(mpz_sizeinbase(half.get_den_mpz_t(), 2)) + 1;
      m.widen(Magnitude::power_of_two(e));
    }
    return m;
  }
};

template <class T>
using Coefficients = std::vector<T>;

// A form's coefficients without the binomials; `make` makes numbers.
template <class T, int degree, class Make>
Coefficients<T> unscaled(const Form<T, degree>& f, const Make& make) {
  constexpr std::array<int, degree + 1> scale = binomials<degree>();
  Coefficients<T> c(f.c.begin(), f.c.end());
  for (int k = 1; k < degree; ++k) c[k] = c[k] * make(Rational(1, scale[k]));
  return c;
}

template <class T>
void halve_in(const Coefficients<T>& c, const T& half, Coefficients<T>& left,
              Coefficients<T>& right) {
  Coefficients<T> w = c;
  const std::size_t degree = c.size() - 1;
  left.assign(1, w[0]);
  right.assign(c.size(), w[degree]);
  for (std::size_t level = 1; level <= degree; ++level) {
    for (std::size_t k = 0; k + level <= degree; ++k) w[k] = half * (w[k] + w[k + 1]);
    left.push_back(w[0]);
    right[degree - level] = w[degree - level];
  }
}

// The number of roots that roots_by_signs() gives for the signs of these coefficients.
template <class T>
int count_roots_in(const Coefficients<T>& c) {
  unsigned positive = 0, negative = 0;
  for (std::size_t k = 0; k < c.size(); ++k) {
    const Sign s = sign(c[k]);
    positive |= static_cast<unsigned>(s == Sign::positive) << k;
    negative |= static_cast<unsigned>(s == Sign::negative) << k;
  }
  return roots_by_signs(positive, negative, static_cast<int>(c.size()) - 1);
}

}  // namespace voroproof::internal
