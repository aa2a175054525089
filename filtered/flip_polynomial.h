// The flip polynomial of a quadruplet as a function of time: its values and slopes, in any number
// type that Motion gives sites in.
#pragma once

#include <array>

#include "exact/generators.h"
#include "exact/predicates.h"
#include "filtered/bernstein.h"
#include "filtered/edge_predicates.h"

namespace voroproof {

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

}  // namespace voroproof
