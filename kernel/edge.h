// The geometry of four moving generators: when an edge of the diagram collapses, if it does.
//
// A generator has a signed radius, -R for the container. p_ij = |c_i - c_j|^2 - (r_i - r_j)^2 is
// positive for two disks neither of which holds the other, and negative for a disk and the
// container. An edge [l,r,s,e] has two in-circle functions, of e in the circle (l,s,r) and of s in
// the circle (l,r,e): q = G - eps sqrt(Gamma) C, positive while the fourth stays outside. q times
// its conjugate is N f with N > 0 where Gamma > 0, so that signs of G, C and f give that of q.
#pragma once

#include <array>
#include <optional>
#include <set>

#include "kernel/files.h"
#include "kernel/roots.h"

namespace voroproof_kernel {

// A generator on a line: from `start` on its centre is ((x, y) + (vx, vy) t) / (odd 2^shift), its
// signed radius r / (odd 2^shift).
struct Leg {
  Rat start, radius;
  Vec from, velocity;
  Int x, y, vx, vy, r, odd;
  unsigned shift = 0;

  Leg(const Rat& start, const Vec& from, const Vec& velocity, const Rat& signed_radius);
  Vec at(const Rat& t) const;
};

template <class T>
struct Site {
  T x, y, r;
};

// The circle that touches sites i, j, k in counterclockwise order; i is a disk.
template <class T>
struct Circle {
  Site<T> base;
  T xp, yp, sp, xs, ys, xy;  // D_uv = u_j v_k - v_j u_k of the differences to the base

  Circle(const Site<T>& i, const Site<T>& j, const Site<T>& k);
  T g(const Site<T>& e) const;
  T c(const Site<T>& e) const;
};

// The edge collapses at an instant: its first in-circle function is negative from there to `after`.
struct Collapse {
  Instant at;
  Rat after;
};

constexpr int kTouching = -2;

// Four generators and their quadruplet, at work on one life after another.
class Edge4 {
 public:
  // Ids and motion of l, r, s, e in this order.
  void set(const Quad& quad, const std::array<const Leg*, 4>& legs);

  // The first collapse just after a or in (a, b): proves that there is none, or finds it. `fresh`:
  // proves, too, that both circles exist somewhere before.
  std::optional<Collapse> first_collapse(const Rat& a, const Rat& b, bool fresh = false);
  // The collapse if it is the only root of the polynomial after a and lies close to t.
  std::optional<Collapse> collapse_near(const Rat& a, const Rat& t);
  // The polynomial whose roots are the instants at which the four may touch one circle.
  Form roots_over(const Rat& a, const Rat& b);
  // Whether the form made last is not that of f or C, which vanish identically.
  bool always() const { return always_; }

  // At an instant at which both vertices' circles touch all four: whether they are one circle. (Two
  // circles may touch the same four; then the edge leads from the one to the other and stays.)
  bool one_circle(Instant& t);

  // The sign of an in-circle function at t: of the vertex [l,s,r] or of [l,r,e].
  int incircle_at(const Rat& t, bool start);
  // Of what is positive iff the circle exists at t; kTouching where two of the three touch.
  int existence_at(const Rat& t, bool start);
  // The sites of four generators at t, as whole numbers on one scale.
  const Site<Int>* sites(const std::array<const Leg*, 4>& legs, const Rat& t);

  std::int64_t fresh_proofs = 0;
  std::set<int> touched;  // generators of pairs whose tangency vanished or had the wrong sign

 private:
  void place(const Rat& a, const Rat& b);
  void tangencies();
  enum class Separated { yes, touching, no };
  Separated separated();
  const Form& form();
  int incircle(bool start, int f_sign);
  int legal(int f_sign);
  void sites_at(const Int& above, unsigned depth);
  std::optional<Collapse> between_contacts(const Rat& a, const Rat& b);
  int exists(bool start) const;

  Quad quad_{};
  std::array<const Leg*, 4> legs_{};
  int wall_ = -1;                        // which of the four is the container
  bool equal_ = false, always_ = false;  // four equal radii; f vanishes identically
  Int x_[4][2], y_[4][2], r_[4];         // at both ends of the interval, on one scale
  Int p_[6][3];                          // tangencies of lr, ls, le, rs, re, se
  Site<Int> at_[4];                      // at one instant
  Form form_, terms_[4];
};

// The sign of u + v sqrt(gamma), gamma >= 0.
int sign_with_root(const Int& u, const Int& v, const Int& gamma);

}  // namespace voroproof_kernel
