// The generators of a witness in CGAL's numbers: their motion as polynomials, and the polynomials
// whose roots are the times of events. For evidence.cpp alone.
#pragma once

#include <CGAL/Gmpq.h>
#include <CGAL/Polynomial.h>
#include <CGAL/determinant.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "certify/certificate.h"

namespace voroproof::internal::cgal {

using CGAL::Gmpq;
using Polynomial = CGAL::Polynomial<Gmpq>;

inline Gmpq number(const Rational& q) { return Gmpq(q.get_str()); }

// A generator at one time; the radius is signed, negative for the container.
struct Circle {
  Gmpq x, y, r;
  bool container;
};

struct Mover {
  GenId id;
  Gmpq t0, x, y, vx, vy, r;

  Circle at(const Gmpq& t) const {
    return {x + vx * (t - t0), y + vy * (t - t0), r, id == container_id};
  }
};

// Nothing where a number is given by bounds only.
inline std::optional<Mover> mover(const EvidenceMotion& m) {
  for (const EvidenceNumber* n : {&m.x, &m.y, &m.vx, &m.vy, &m.radius}) {
    if (n->exact.empty()) return std::nullopt;
  }
  return Mover{m.id,
               number(m.t0),
               Gmpq(m.x.exact),
               Gmpq(m.y.exact),
               Gmpq(m.vx.exact),
               Gmpq(m.vy.exact),
               Gmpq(m.radius.exact)};
}

inline Polynomial coordinate(const Gmpq& x, const Gmpq& v, const Gmpq& t0) {
  return Polynomial(Gmpq(x - v * t0), v);
}

// The difference of two motions, in the centre's coordinates and in the signed radius.
struct Offset {
  Polynomial x, y;
  Gmpq r;

  Offset(const Mover& from, const Mover& to)
      : x(coordinate(to.x, to.vx, to.t0) - coordinate(from.x, from.vx, from.t0)),
        y(coordinate(to.y, to.vy, to.t0) - coordinate(from.y, from.vy, from.t0)),
        r(to.r - from.r) {}
  Polynomial power() const { return x * x + y * y - Polynomial(Gmpq(r * r)); }
};

// A^2 + B^2 - C^2, Eq. (1) of the paper, with the determinants of its Eq. (3).
inline Polynomial cotangency(const std::array<Mover, 4>& m) {
  std::array<Polynomial, 3> x, y, r, p;
  for (int i = 0; i < 3; ++i) {
    const Offset d(m[3], m[i]);
    x[i] = d.x;
    y[i] = d.y;
    r[i] = Polynomial(d.r);
    p[i] = d.power();
  }
  const auto rows = [](const auto& u, const auto& v, const auto& w) {
    return CGAL::determinant(u[0], v[0], w[0], u[1], v[1], w[1], u[2], v[2], w[2]);
  };
  const Polynomial a = rows(y, r, p), b = rows(x, r, p), c = rows(x, y, p);
  return a * a + b * b - c * c;
}

// The determinant with the rows x, y, x^2 + y^2, 1: the circle through four centres.
inline Polynomial cocircularity(const std::array<Mover, 4>& m) {
  std::array<Polynomial, 4> x, y, q;
  for (int i = 0; i < 4; ++i) {
    x[i] = coordinate(m[i].x, m[i].vx, m[i].t0);
    y[i] = coordinate(m[i].y, m[i].vy, m[i].t0);
    q[i] = x[i] * x[i] + y[i] * y[i];
  }
  const Polynomial one(Gmpq(1));
  return CGAL::determinant(x[0], y[0], q[0], one, x[1], y[1], q[1], one, x[2], y[2], q[2], one,
                           x[3], y[3], q[3], one);
}

// The square of the distance less that of the reach.
inline Polynomial contact(const Mover& i, const Mover& j) {
  const Offset d(i, j);
  const Gmpq reach = i.r + j.r;
  return d.x * d.x + d.y * d.y - Polynomial(Gmpq(reach * reach));
}

// Whether one is a positive multiple of the other.
inline bool same_up_to_scale(const Polynomial& f, const Polynomial& g) {
  if (f.degree() != g.degree() || CGAL::sign(f.lcoeff()) != CGAL::sign(g.lcoeff())) return false;
  return f * Polynomial(g.lcoeff()) == g * Polynomial(f.lcoeff());
}

}  // namespace voroproof::internal::cgal
