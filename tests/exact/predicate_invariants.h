// The numbers that the laws of the predicates are about: of four sites, and of a triple and the
// fourth.
#pragma once

#include <array>
#include <ostream>
#include <utility>

#include "exact/predicates.h"
#include "exact/rational.h"
#include "exact/tower.h"
#include "tests/exact/predicate_sites.h"

namespace voroproof::internal::testing {

// a + b sqrt(Gamma): laws of such numbers are laws of a and b, whatever Gamma is.
struct Rooted {
  Rooted(Rational plain, Rational with_root = 0) : a(std::move(plain)), b(std::move(with_root)) {}
  Rational a, b;
  bool operator==(const Rooted& o) const { return a == o.a && b == o.b; }
  Rooted conjugate() const { return {a, -b}; }
  Rooted operator-() const { return {-a, -b}; }
};
inline Rooted operator-(const Rooted& x, const Rooted& y) { return {x.a - y.a, x.b - y.b}; }
inline Rooted operator*(const Rational& c, const Rooted& x) { return {c * x.a, c * x.b}; }
inline Rooted product(const Rooted& x, const Rooted& y, const Rational& gamma) {
  return {x.a * y.a + x.b * y.b * gamma, x.a * y.b + x.b * y.a};
}
inline Sign sign_of(const Rooted& x, const Rational& gamma) {
  RadicalField field;
  return sign(Tower(x.a) + Tower(x.b) * field.sqrt(Tower(gamma)));
}
inline void showValue(const Rooted& x, std::ostream& out) { out << x.a << " + root " << x.b; }

// The numbers whose signs incircle, for a disk, and circle_exists tell.
inline Rooted q_of(const TangentTriple<Rational>& t, const Site<Rational>& e) {
  const InCircleParts<Rational> parts(t, e);
  const Rational c = parts.c();
  return {parts.g(), t.with_container ? Rational(-c) : c};
}
inline Rooted h_of(const TangentTriple<Rational>& t) {
  return {t.xp * t.xs + t.yp * t.ys, t.with_container ? Rational(-t.xy) : t.xy};
}
inline Rational n_of(const TangentTriple<Rational>& t) { return t.xp * t.xp + t.yp * t.yp; }

// What laws are about: of four sites, and of a triple and the fourth.
struct Invariants {
  Rational f, c, gamma, n;
  Rooted q, h;
  std::array<Rational, 6> p;
  Sign exists, in_circle;
};

// Of the triple 0, 1, 2 and the site 3; or of 0, 2, 1.
inline Invariants invariants(const Four& four, bool exchanged = false) {
  Order o = disk_leads({0, 1, 2}, four.wall);
  if (exchanged) std::swap(o[1], o[2]);
  const auto t = triple(four.at, o, four.wall);
  Invariants all{f_of(four.at), c_of(four.at), gamma(t), n_of(t), q_of(t, four.at[3]), h_of(t), {},
                 Sign::unknown, Sign::unknown};
  int k = 0;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < i; ++j) all.p[k++] = tangency(four.at[i], four.at[j]);
  }
  all.exists = circle_exists(t);
  all.in_circle = incircle(t, four.at[3], four.wall == 3, sign(all.f));
  return all;
}

inline Rational determinant(const std::array<std::array<Rational, 3>, 3>& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

// Differences x, y, s and p of three sites to the base at[0], in three columns of the four.
inline Rational columns(const Sites<Rational>& at, const Order& which) {
  std::array<std::array<Rational, 3>, 3> m;
  for (int k = 0; k < 3; ++k) {
    const Site<Rational>& s = at[k + 1];
    const Rational row[4] = {s.x - at[0].x, s.y - at[0].y, s.r - at[0].r, tangency(s, at[0])};
    for (int c = 0; c < 3; ++c) m[k][c] = row[which[c]];
  }
  return determinant(m);
}

}  // namespace voroproof::internal::testing
