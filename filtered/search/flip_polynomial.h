// The flip polynomial of a quadruplet as a function of time: its values, its slopes and its
// coefficients over a window, in any number type that Motion gives sites in.
#pragma once

#include <array>

#include "exact/generators.h"
#include "exact/predicates.h"
#include "filtered/numbers/subdivision.h"
#include "filtered/search/bernstein.h"
#include "filtered/search/edge_predicates.h"

namespace voroproof::internal {

// The sign of f just after a root of the flip polynomial phi, whose sign there is s:
// phi is f itself, or C where f = -C^2.
inline Sign cotangency_sign(Sign s, bool cocircular) { return cocircular ? Sign::negative : s; }

// The flip polynomial and its derivative in time, at moving sites.
template <class T>
struct ValueAndSlope {
  T value, slope;
};

template <class T>
ValueAndSlope<T> cotangency_and_slope(const std::array<MovingSite<T>, 4>& s) {
  struct Pair {
    T p, d;
  };
  const auto pair = [&](int i, int j) {
    const T dx = s[i].x - s[j].x, dy = s[i].y - s[j].y, dr = s[i].r - s[j].r;
    const T h = dx * (s[i].vx - s[j].vx) + dy * (s[i].vy - s[j].vy);
    return Pair{dx * dx + dy * dy - dr * dr, h + h};
  };
  const auto product = [](const Pair& a, const Pair& b) {
    return Pair{a.p * b.p, a.p * b.d + a.d * b.p};
  };
  const Pair a = product(pair(0, 1), pair(2, 3));
  const Pair b = product(pair(0, 2), pair(1, 3));
  const Pair c = product(pair(0, 3), pair(1, 2));
  const T g = a.p - b.p - c.p;
  const T gd = a.d - b.d - c.d;
  const T bc = b.p * c.p;
  const T bcd = b.p * c.d + b.d * c.p;
  const T bc2 = bc + bc, bcd2 = bcd + bcd, ggd = g * gd;
  return {g * g - (bc2 + bc2), ggd + ggd - (bcd2 + bcd2)};
}

template <class T>
ValueAndSlope<T> cocircularity_and_slope(const std::array<MovingSite<T>, 4>& s) {
  struct Row {
    T x, y, vx, vy, p, d;
  };
  const auto row = [&](int i) {
    const T x = s[i].x - s[3].x, y = s[i].y - s[3].y;
    const T vx = s[i].vx - s[3].vx, vy = s[i].vy - s[3].vy;
    const T h = x * vx + y * vy;
    return Row{x, y, vx, vy, x * x + y * y, h + h};
  };
  const std::array<Row, 3> r{row(0), row(1), row(2)};
  const auto term = [&](int k, int i, int j) {
    const T cross = r[i].x * r[j].y - r[i].y * r[j].x;
    const T slope = (r[i].vx * r[j].y - r[i].vy * r[j].x) + (r[i].x * r[j].vy - r[i].y * r[j].vx);
    return ValueAndSlope<T>{r[k].p * cross, r[k].p * slope + r[k].d * cross};
  };
  const auto a = term(0, 1, 2), b = term(1, 2, 0), c = term(2, 0, 1);
  return {a.value + b.value + c.value, a.slope + b.slope + c.slope};
}

template <class T>
ValueAndSlope<T> flip_value_and_slope(const Motion& m, const Quad& q, const T& t, bool cocircular) {
  const std::array<MovingSite<T>, 4> s{m.moving_site(q.l, t), m.moving_site(q.r, t),
                                       m.moving_site(q.s, t), m.moving_site(q.e, t)};
  return cocircular ? cocircularity_and_slope(s) : cotangency_and_slope(s);
}

template <class T>
T flip_value(const Motion& m, const Quad& q, const T& t, bool cocircular) {
  const auto s = sites(m, q, t);
  // The base is the last site, as in cocircularity_and_slope: another base may turn the sign.
  return cocircular ? cocircularity(s[3], s[0], s[1], s[2]) : cotangency(s[0], s[1], s[2], s[3]);
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

}  // namespace voroproof::internal
