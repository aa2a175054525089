// The numbers and circles that the oracles take and return. Nothing here, and nothing else in
// this folder, uses the project's own arithmetic or geometry: the oracles exist to disagree
// with it.
#pragma once

#include <gmpxx.h>

#include <array>
#include <boost/multiprecision/mpfr.hpp>
#include <string>

namespace voroproof::oracle {

// 100 decimal digits.
using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<100>>;

// A disk or the container: centre and radius, in the scene's unit of length.
struct Circle {
  Real x, y, radius;
};

// A circle with exact rational coordinates.
struct ExactCircle {
  mpq_class x, y, radius;
};

// q rounded to the nearest value of the floating type Float.
template <class Float>
Float rounded(const mpq_class& q) {
  Float value;
  mpfr_set_q(value.backend().data(), q.get_mpq_t(), MPFR_RNDN);
  return value;
}

inline Circle rounded(const ExactCircle& c) {
  return {rounded<Real>(c.x), rounded<Real>(c.y), rounded<Real>(c.radius)};
}

// A Voronoi vertex [i,j,k]: its generators in counterclockwise order of their contact points,
// the smallest id first. -1 is the container.
using Triple = std::array<int, 3>;

// An oriented Voronoi edge [l,r,s,e] from vertex [l,s,r] to vertex [l,r,e].
using Quadruple = std::array<int, 4>;

// The rotation of t that starts with its smallest id.
inline Triple smallest_first(const Triple& t) {
  if (t[1] < t[0] && t[1] < t[2]) return {t[1], t[2], t[0]};
  if (t[2] < t[0] && t[2] < t[1]) return {t[2], t[0], t[1]};
  return t;
}

// The smaller of the two names of an edge.
inline Quadruple canonical(const Quadruple& q) {
  const Quadruple backwards{q[1], q[0], q[3], q[2]};
  return backwards < q ? backwards : q;
}

inline Triple start_vertex(const Quadruple& q) { return smallest_first({q[0], q[2], q[1]}); }
inline Triple end_vertex(const Quadruple& q) { return smallest_first({q[0], q[1], q[3]}); }

// "[1,2,3]", for messages.
template <class Ids>
std::string text(const Ids& ids) {
  std::string result;
  for (int id : ids) {
    result += result.empty() ? '[' : ',';
    result += std::to_string(id);
  }
  result += ']';
  return result;
}

}  // namespace voroproof::oracle
