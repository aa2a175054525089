// Four generators on lines: when the edge between them collapses (docs/kernel.md, sections 5, 6).
//
// A generator has a signed radius, -R for the container. The tangency |c_i - c_j|^2 - (r_i - r_j)^2
// is positive for two disks neither of which holds the other, and negative for a disk and the
// container. An edge [l,r,s,e] has two in-circle functions, of e in the circle (l,s,r) and of s in
// the circle (l,r,e): q = G - eps sqrt(Gamma) C, positive while the fourth stays outside. q times
// its conjugate is N f with N > 0 where Gamma > 0, so that signs of G, C and f give that of q.
#pragma once

#include <set>

#include "certify/kernel/files.h"

namespace voroproof_kernel {

// A generator on a line from `start` on: its centre is ((x, y) + (vx, vy) t) / scale, its signed
// radius r / scale.
struct Leg {
  Rat start;
  Vec from, velocity;
  Rat radius;
  std::size_t claim;  // that begins it
  Int x, y, vx, vy, r, scale;

  Leg(const Rat& start, const Vec& from, const Vec& velocity, const Rat& radius,
      std::size_t claim = 0);
  Vec at(const Rat& t) const { return plus(from, t - start, velocity); }
};

// A centre and a signed radius: Int at a time, Form over an interval.
template <class T>
struct Site {
  T x, y, r;
  Site operator-(const Site& o) const { return {x - o.x, y - o.y, r - o.r}; }
};
// The tangency from the difference of two sites.
template <class T>
T tangency(const Site<T>& d) {
  return d.x * d.x + d.y * d.y - d.r * d.r;
}
using Sites = std::array<Site<Int>, 4>;
// Four generators at some times, all on one scale.
std::vector<Sites> sites(const std::array<const Leg*, 4>& legs, const std::vector<Rat>& times);

// The circle that touches i, a disk, j and k counterclockwise: D_uv = u_j v_k - v_j u_k of the
// differences to i. (Clockwise: the other sign of the root.)
template <class T>
struct Circle {
  Site<T> base;
  T xp, yp, sp, xs, ys, xy;

  Circle(const Site<T>& i, const Site<T>& j, const Site<T>& k);
  T g(const Site<T>& e) const;
  T c(const Site<T>& e) const;
  T gamma() const { return xp * xp + yp * yp - sp * sp; }
};

// The sign of u + v sqrt(gamma), gamma >= 0.
int sign_with_root(const Int& u, const Int& v, const Int& gamma);

// An edge and the motion of l, r, s, e.
struct Four {
  Quad quad{};
  std::array<const Leg*, 4> legs{};

  // The polynomial over [a, b] whose roots are the instants at which the four may touch one circle.
  Form polynomial(const Rat& a, const Rat& b) const;
  // Signs at t, for the vertex [l,s,r] or [l,r,e]: of its in-circle function, and of what is
  // positive iff its circle exists (0 where two of the three touch).
  int incircle(const Rat& t, bool start) const;
  int exists(const Rat& t, bool start) const;
  // Whether all tangencies have their right signs in [a, b].
  bool apart(const Rat& a, const Rat& b) const;
};

// A time lo = hi, or the only root, one of odd order, of the polynomial of four in (lo, hi).
struct Instant {
  Rat lo, hi;
  Four four{};
  bool multiple = false;  // the root need not be simple

  bool is_point() const { return lo == hi; }
  Form form(const Rat& a, const Rat& b) const;
  void split(const Rat& t);  // finds on which side of t it is
};
Instant at(const Rat& t);
// The sign of x - y, narrowing both. Ends always: equal roots are roots of a common divisor.
int compare(Instant& x, Instant& y);
int compare(Instant& x, const Rat& t);

// The edge collapses at an instant: its first in-circle function is negative from there to `after`.
struct Collapse {
  Instant at;
  Rat after;
};

// Notes of a search: proofs made anew after tangencies of the wrong sign, and the pairs of these
// tangencies.
struct Notes {
  std::int64_t fresh_proofs = 0;
  std::set<int> touched;
};

// The first collapse just after a or in (a, b): proves that there is none, or finds it. `fresh`: it
// begins with a fresh proof.
std::optional<Collapse> first_collapse(const Four&, const Rat& a, const Rat& b, Notes&,
                                       bool fresh = false);
// The collapse if the polynomial has one root between a and shortly after t, and that close to t.
std::optional<Collapse> collapse_near(const Four&, const Rat& a, const Rat& t);

// Whether both vertices' circles, which touch all four at the instant t, are one circle. (Two
// circles may touch the same four; then the edge leads from the one to the other and stays.)
bool one_circle(const Four&, Instant& t);

}  // namespace voroproof_kernel
