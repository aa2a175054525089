// Polynomials in the Bernstein basis in numbers with error bounds of their own,
// double-doubles and balls: the scheme of filtered/numbers/double_roots.h, value by value.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "exact/ball.h"
#include "exact/predicates.h"
#include "filtered/numbers/dd_ball.h"
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

// Product of two polynomials in the scaled Bernstein basis.
template <class T>
Coefficients<T> multiply(const Coefficients<T>& p, const Coefficients<T>& q) {
  std::vector<std::optional<T>> r(p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) {
      T term = p[i] * q[j];
      auto& slot = r[i + j];
      slot = slot ? *slot + term : term;
    }
  }
  Coefficients<T> out;
  out.reserve(r.size());
  for (auto& slot : r) out.push_back(std::move(*slot));
  return out;
}

template <class T>
Coefficients<T> subtract(Coefficients<T> p, const Coefficients<T>& q) {
  for (std::size_t k = 0; k < p.size(); ++k) p[k] = p[k] - q[k];
  return p;
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

// As roots_by_signs().
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
