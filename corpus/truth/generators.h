// The generators of a line, and their numbers in every type that a proof needs.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "exact/ball.h"
#include "exact/polynomial.h"
#include "exact/predicates.h"
#include "exact/rational.h"

namespace voroproof::truth {

using internal::Ball;
using internal::Polynomial;
using internal::Rational;
using internal::Sign;

// As README.md has them. A wall has its unit vector as x, y and its offset as r.
struct Generator {
  char kind = 'd';
  double x = 0, y = 0, r = 0;
  double vx = 0, vy = 0, vr = 0;
};
using Generators = std::vector<Generator>;

template <class T>
struct Numbers {
  char kind;
  T x, y, r, one;
};

// At rest, held at `bits`.
Numbers<Ball> in_balls(const Generator& g, int bits);
Numbers<Rational> at(const Generator& g, const Rational& t);
// In balls of `bits` at the exact time t.
Numbers<Ball> at(const Generator& g, const Rational& t, int bits);
// As functions of time.
Numbers<Polynomial<Rational>> in_time(const Generator& g);

// `d 0x1p+0 0x0p+0 0x1p-1`, with the rates where it moves.
std::string text(double x);
std::string text_at_rest(const Generator& g);
std::string text_in_motion(const Generator& g);

// The place of a disk or a container with its signed radius.
template <class T>
internal::Site<T> site(const Numbers<T>& g) {
  if (g.kind == 'c') return {g.x, g.y, T(-g.r)};
  return {g.x, g.y, g.r};
}

// A generator seen from a disk, its tangency positive.
template <class T>
internal::GeneratorRow<T> row_of(const Numbers<T>& disk, const Numbers<T>& g) {
  if (g.kind == 'w') {
    const T half = g.x * disk.x + g.y * disk.y - g.r + disk.r;
    return {T(-g.x), T(-g.y), g.one, T(half + half)};
  }
  const internal::GeneratorRow<T> r = internal::row(site(disk), site(g));
  if (g.kind == 'c') return {T(-r.x), T(-r.y), T(-r.s), T(-r.p)};
  return r;
}

// The tangency of two generators, positive where neither lies in the other.
template <class T>
T tangency(const Numbers<T>& a, const Numbers<T>& b) {
  if (a.kind == 'w' && b.kind == 'w') {
    const T x = a.x - b.x, y = a.y - b.y;
    return x * x + y * y;
  }
  return a.kind == 'd' ? row_of(a, b).p : row_of(b, a).p;
}

template <class T>
T cotangency(const std::array<Numbers<T>, 4>& g) {
  const auto p = [&](int i, int j) { return tangency(g[i], g[j]); };
  return internal::cotangency_of(T(p(0, 1) * p(2, 3)), T(p(0, 2) * p(1, 3)), T(p(0, 3) * p(1, 2)));
}

// The circle of three generators, of which the first must be a disk.
template <class T>
internal::TangentTriple<T> circle(const Numbers<T>& a, const Numbers<T>& b, const Numbers<T>& c) {
  return {site(a), row_of(a, b), row_of(a, c), false};
}

// The three in an order of the same circle that begins with a disk.
template <class G>
std::array<G, 3> disk_first(const G& a, const G& b, const G& c) {
  if (a.kind == 'd') return {a, b, c};
  if (b.kind == 'd') return {b, c, a};
  return {c, a, b};
}

// The sign of the gap between the circle of the first three, which exists, and the fourth.
Sign gap_sign(const std::array<Numbers<Rational>, 4>& g);
Sign gap_sign(const std::array<Numbers<Ball>, 4>& g);
Sign exists_sign(const std::array<Numbers<Rational>, 3>& g);
Sign exists_sign(const std::array<Numbers<Ball>, 3>& g);

// Whether no two of them overlap at rest; touching is apart.
bool are_apart(const std::vector<Numbers<Rational>>& g);

}  // namespace voroproof::truth
