// The flip polynomial in the Bernstein basis in numbers with error bounds of their own,
// double-doubles and balls: the scheme of filtered/double_roots.h, value by value.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "exact/ball.h"
#include "filtered/dd_ball.h"
#include "filtered/edge_predicates.h"

namespace voroproof {

struct MakeDd {
  DdBall operator()(const Rational& q) const {
    const double hi = voroproof::round_nearest(q);
    const Rational rest = q - to_rational(hi);
    const double lo = voroproof::round_nearest(rest);
    const Rational left = rest - to_rational(lo);
    return {hi, lo,
            sgn(left) == 0 ? 0.0 : std::fabs(lo) * 0x1p-52 + std::numeric_limits<double>::min()};
  }
  // A ball around the interval.
  DdBall hull(const Rational& lo, const Rational& hi) const {
    DdBall m = (*this)(Rational((lo + hi) / 2));
    m.rad = (m.rad + voroproof::round_up(Rational((hi - lo) / 2))) * (1 + 0x1p-50);
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

// The flip polynomial over [a, b], unscaled Bernstein coefficients.
template <class T, class Make>
Coefficients<T> form_in(const Motion& motion, const Quad& q, const Rational& a, const Rational& b,
                        bool cocircular, const Make& make) {
  const std::array<Site<T>, 4> s0 = sites(motion, q, make(a));
  const std::array<Site<T>, 4> s1 = sites(motion, q, make(b));
  const T two = make(2);
  const auto tangency2 = [&](int i, int j) {
    const T ax = s0[i].x - s0[j].x, ay = s0[i].y - s0[j].y;
    const T bx = s1[i].x - s1[j].x, by = s1[i].y - s1[j].y;
    const T dr = s0[i].r - s0[j].r;
    const T dr2 = dr * dr;
    return Coefficients<T>{ax * ax + ay * ay - dr2, two * (ax * bx + ay * by - dr2),
                           bx * bx + by * by - dr2};
  };
  Coefficients<T> f;
  if (cocircular) {
    const auto term = [&](int k, int i, int j) {
      const T x0i = s0[i].x - s0[3].x, y0i = s0[i].y - s0[3].y;
      const T x1i = s1[i].x - s1[3].x, y1i = s1[i].y - s1[3].y;
      const T x0j = s0[j].x - s0[3].x, y0j = s0[j].y - s0[3].y;
      const T x1j = s1[j].x - s1[3].x, y1j = s1[j].y - s1[3].y;
      return multiply(
          tangency2(k, 3),
          Coefficients<T>{x0i * y0j - y0i * x0j, (x0i * y1j - y0i * x1j) + (x1i * y0j - y1i * x0j),
                          x1i * y1j - y1i * x1j});
    };
    f = term(0, 1, 2);
    for (const auto& t : {term(1, 2, 0), term(2, 0, 1)}) {
      for (std::size_t k = 0; k < f.size(); ++k) f[k] = f[k] + t[k];
    }
  } else {
    const auto ta = multiply(tangency2(0, 1), tangency2(2, 3));
    const auto tb = multiply(tangency2(0, 2), tangency2(1, 3));
    const auto tc = multiply(tangency2(0, 3), tangency2(1, 2));
    const auto g = subtract(subtract(ta, tb), tc);
    auto bc = multiply(tb, tc);
    const T four = make(4);
    for (T& c : bc) c = c * four;
    f = subtract(multiply(g, g), bc);
  }
  const int degree = static_cast<int>(f.size()) - 1;
  long binomial = 1;
  for (int k = 0; k <= degree; ++k) {
    if (binomial != 1) f[k] = f[k] * make(Rational(1, binomial));
    binomial = binomial * (degree - k) / (k + 1);
  }
  return f;
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

template <class T>
int count_roots_in(const Coefficients<T>& c) {
  int variations = 0;
  Sign last = Sign::unknown;
  int uncertain = 0;
  for (std::size_t k = 0; k < c.size(); ++k) {
    const Sign s = sign(c[k]);
    if (s == Sign::unknown || s == Sign::zero) {
      if (k == 0 || k + 1 == c.size()) return -1;
      ++uncertain;
      continue;
    }
    if (last != Sign::unknown) {
      if (s != last) {
        if (uncertain > 1) return -1;
        ++variations;
      } else if (uncertain > 0) {
        return -1;
      }
    }
    last = s;
    uncertain = 0;
  }
  return variations <= 1 ? variations : -1;
}

}  // namespace voroproof
