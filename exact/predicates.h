// The predicates of the additively weighted (Apollonius) Voronoi diagram, written
// once for every number type T: rationals and towers (exact), balls and doubles
// with error bounds (filters), polynomials in time (to form the flip polynomial).
//
// Notation, throughout the project:
//   site i        centre (x_i, y_i), signed radius r_i: >= 0 for a disk, -R for the
//                 container of radius R seen from inside
//   p_ij          |c_i - c_j|^2 - (r_i - r_j)^2: positive for two disks neither of
//                 which lies in the other, negative between the container and a
//                 disk that reaches its inside
//   base i        the disk to which differences x, y, s (of radii) and p are taken
//   D_uv          u_j v_k - v_j u_k over the rows j and k
//   Gamma         p_ij p_ik p_jk, positive
//   epsilon       +1 if the container is j or k, else -1
//
// The tangent circle of a base i and two more sites, centre c_i + rho' n with |n| = 1
// and rho' = rho + r_i, obeys d_j.n + s_j = p_j / (2 rho') for both: linear in n and
// kappa = 1/(2 rho'), so n and kappa lie in Q(sqrt Gamma), and one sign of the root is
// the circle whose contact points i, j, k run counterclockwise. (Paper section 2, with
// Casey's theorem for Eq. (1); the same elimination as Emiris & Karavelas, "The
// predicates of the Apollonius diagram", Comput. Geom. 33, 2006.)
//
// Laws, each of them a property in tests/exact/predicates_laws_test.cpp. q and h are the numbers
// whose signs incircle (of a disk e) and circle_exists tell, q' and h' those of the triple
// (i, k, j), with the other sign of the root. N = D_xp^2 + D_yp^2.
//   L1   cotangency is one number for all 24 orders of its sites.
//   L2   cocircularity changes its sign where two of s1, s2, s3 change places, and where s0 and a
//        site of its radius do. So a cyclic rotation of s1, s2, s3 leaves it.
//   L3   cotangency = 4 (A^2 + B^2 - C^2), A and B the determinants of rows y, s, p and x, s, p.
//        For four equal radii that is -4 C^2.
//   L4   gamma = p_ij p_jk p_ki for every order of the triple.
//   L5   4 q q' = N cotangency, and h h' = N (D_xs^2 + D_ys^2 - D_xy^2).
//   L6   q / h = |z - c_e|^2 - (rho + r_e)^2 and N / (2h) = rho + r_i, z the centre of the circle:
//        one circle, whichever disk of the triple is the base.
//   L7   A reflection changes the sign of cocircularity and turns q, h into q', h'; cotangency and
//        gamma stay.
//   L8   Scaling by s > 0 multiplies tangencies by s^2, cocircularity by s^4, h by s^5, gamma by
//        s^6, q by s^7 and cotangency by s^8.
//   L9   Translations and rotations leave all these numbers.
//   L10  So does a constant that is added to all signed radii.
//   L11  Changing the signs of all radii leaves cotangency, cocircularity and gamma and turns q, h
//        into -q', -h': the other kind of tangent circle.
//   L12  Sites set around a circle, counterclockwise and with the container in any place or none,
//        have it as their tangent circle, and incircle tells on which side of it e lies.
//   L13  With the container in the triple both tangent circles exist: h and h' are positive.
#pragma once

#include <array>
#include <utility>

#include "exact/rational.h"

namespace voroproof::internal {

// One generator at one instant.
template <class T>
struct Site {
  T x, y, r;
};

// A generator and its linear motion: centre at the reference instant, velocity.
template <class T>
struct MovingSite {
  T x, y, vx, vy, r;
};

// x^2. Types that know a shorter way have an overload.
template <class X>
X squared(const X& x) {
  return x * x;
}
// The type of a square: that of a polynomial is another one, of twice the degree.
template <class X>
using Squared = decltype(squared(std::declval<const X&>()));

// The tangency p of two sites whose centres differ by (dx, dy) and whose radii by dr.
template <class X, class R>
[[gnu::always_inline]] inline Squared<X> tangency_of(const X& dx, const X& dy, const R& dr) {
  return squared(dx) + squared(dy) - squared(dr);
}

// The cotangency of four sites 0 to 3, 4 f of the paper's Eq. (1), from the products of their
// tangencies: a = p_01 p_23, b = p_02 p_13, c = p_03 p_12. (Casey's theorem: (a - b - c)^2 - 4 b c
// is symmetric in a, b and c, and in the sites.)
//
// This is the flip polynomial, and its only definition. A may be a value, a value with its slope, a
// polynomial, or four numbers side by side.
template <class A>
Squared<A> cotangency_of(const A& a, const A& b, const A& c) {
  const A g = a - b - c;
  const A twice = b + b;
  const A four_times = twice + twice;
  return squared(g) - four_times * c;
}

// x1 y2 - y1 x2.
template <class X>
Squared<X> determinant(const X& x1, const X& y1, const X& x2, const X& y2) {
  return x1 * y2 - y1 * x2;
}

// One of the three summands of the cocircularity: p is the tangency of a site with the base, (x1,
// y1) and (x2, y2) are the offsets of the two sites that follow it in cyclic order from the base.
template <class P, class X>
Squared<P> cocircularity_term(const P& p, const X& x1, const X& y1, const X& x2, const X& y2) {
  return p * determinant(x1, y1, x2, y2);
}

template <class T>
T tangency(const Site<T>& a, const Site<T>& b) {
  return tangency_of(T(a.x - b.x), T(a.y - b.y), T(a.r - b.r));
}

// Whether no tangency of a pair vanishes, sites given over an interval. Where one does
// the generators overlap (points: where they touch), Gamma changes its sign, and an
// in-circle function may change its own without a root of f. A search looks beyond the
// contacts of its generators, so that it has to know. False says nothing.
template <class T>
bool keeps_tangencies(const std::array<Site<T>, 4>& at) {
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < i; ++j) {
      if (!is_certain(sign(tangency(at[i], at[j])))) return false;
    }
  }
  return true;
}

// 4 f of the paper's Eq. (1), f = A^2 + B^2 - C^2: zero iff the four sites touch one common circle
// (inner or outer, or a line). Symmetric in the four sites; the container may be any of them.
template <class T>
T cotangency(const Site<T>& s0, const Site<T>& s1, const Site<T>& s2, const Site<T>& s3) {
  return cotangency_of(T(tangency(s0, s1) * tangency(s2, s3)),
                       T(tangency(s0, s2) * tangency(s1, s3)),
                       T(tangency(s0, s3) * tangency(s1, s2)));
}

// The determinant C of the paper's Eq. (3), rows x, y, p of s1, s2, s3 to the base
// s0. For four equal radii f = -C^2, so that C is the polynomial to isolate.
template <class T>
T cocircularity(const Site<T>& s0, const Site<T>& s1, const Site<T>& s2, const Site<T>& s3) {
  const T x1 = s1.x - s0.x, y1 = s1.y - s0.y;
  const T x2 = s2.x - s0.x, y2 = s2.y - s0.y;
  const T x3 = s3.x - s0.x, y3 = s3.y - s0.y;
  return cocircularity_term(tangency(s1, s0), x2, y2, x3, y3) +
         cocircularity_term(tangency(s2, s0), x3, y3, x1, y1) +
         cocircularity_term(tangency(s3, s0), x1, y1, x2, y2);
}

// A generator seen from a base disk. Infinity, the frame of a diagram of the plane, has the row
// (0, 0, 0, 1): the circles that touch it are lines. A wall n.x >= h, |n| = 1, has the row
// (-n, 1, 2 (n.c - h + r)), c and r the base's: that of a disk without end, divided by its
// diameter.
template <class T>
struct GeneratorRow {
  T x, y, s, p;
};
template <class T>
[[gnu::always_inline]] inline GeneratorRow<T> row(const Site<T>& base, const Site<T>& g) {
  const T x = g.x - base.x, y = g.y - base.y, s = g.r - base.r;
  return {x, y, s, x * x + y * y - s * s};
}

// The terms of a triple (base, j, k) in every predicate about its tangent circle. Precondition: the
// base is a disk; `with_container` says whether j or k is the container.
template <class T>
struct TangentTriple {
  Site<T> base;
  T xp, yp, sp, xs, ys, xy;  // D_xp, D_yp, ...
  T pj, pk;
  bool with_container;

  TangentTriple(const Site<T>& i, const Site<T>& j, const Site<T>& k, bool container)
      : TangentTriple(i, row(i, j), row(i, k), container) {}
  TangentTriple(const Site<T>& i, const GeneratorRow<T>& j, const GeneratorRow<T>& k,
                bool container)
      : base(i),
        xp(j.x * k.p - j.p * k.x),
        yp(j.y * k.p - j.p * k.y),
        sp(j.s * k.p - j.p * k.s),
        xs(j.x * k.s - j.s * k.x),
        ys(j.y * k.s - j.s * k.y),
        xy(j.x * k.y - j.y * k.x),
        pj(j.p),
        pk(k.p),
        with_container(container) {}
};

// Gamma = N - D_sp^2, N = D_xp^2 + D_yp^2: the product of the three tangencies.
template <class T>
T gamma(const TangentTriple<T>& t) {
  return t.xp * t.xp + t.yp * t.yp - t.sp * t.sp;
}

// Sign of u + sqrt(gamma) v for gamma >= 0, when the sign of u^2 - gamma v^2 is
// known to be that of `discriminant`. unknown in, unknown out, where the answer
// depends on it.
inline Sign sign_with_root(Sign u, Sign v, Sign discriminant) {
  if (u == v && u != Sign::unknown) return u;
  switch (discriminant) {
    case Sign::positive:
      return u;
    case Sign::negative:
      return v;
    case Sign::zero:
      if (u == Sign::unknown || v == Sign::unknown) return Sign::unknown;
      return u == Sign::zero ? v : v == Sign::zero ? u : Sign::zero;
    case Sign::unknown:
      break;
  }
  return Sign::unknown;
}

// G and C of the in-circle function below.
template <class T>
struct InCircleParts {
  InCircleParts(const TangentTriple<T>& triple, const Site<T>& e)
      : InCircleParts(triple, row(triple.base, e)) {}
  InCircleParts(const TangentTriple<T>& triple, const GeneratorRow<T>& e) : t(triple), e(e) {}
  T g() const {
    const T a = e.x * t.sp - e.s * t.xp + e.p * t.xs;
    const T b = e.y * t.sp - e.s * t.yp + e.p * t.ys;
    return t.xp * a + t.yp * b;
  }
  T c() const { return e.x * t.yp - e.y * t.xp + e.p * t.xy; }

 private:
  const TangentTriple<T>& t;
  GeneratorRow<T> e;
};

// Where site e lies to the counterclockwise tangent circle of the triple: positive
// outside (the vertex is legal as far as e is concerned), zero touching, negative in
// conflict. `f` is the sign of the cotangency of the four. Precondition: the circle
// exists.
// The quantity is q = G - epsilon sqrt(Gamma) C, and q times its conjugate is
// (D_xp^2 + D_yp^2) f: so no root is taken.
template <class T>
Sign incircle(const TangentTriple<T>& t, const GeneratorRow<T>& e, bool e_is_container, Sign f) {
  const InCircleParts<T> parts(t, e);
  Sign g = Sign::unknown;
  Sign c = Sign::unknown;
  if (f != Sign::negative) g = sign(parts.g());
  if (f != Sign::positive) {
    c = sign(parts.c());
    if (t.with_container) c = -c;
  }
  const Sign q = sign_with_root(g, c, f);
  return e_is_container ? -q : q;
}
template <class T>
Sign incircle(const TangentTriple<T>& t, const Site<T>& e, bool e_is_container, Sign f) {
  return incircle(t, row(t.base, e), e_is_container, f);
}

// The quantity whose sign incircle() gives, up to a positive factor; takes one root.
template <class T>
T incircle_value(const TangentTriple<T>& t, const Site<T>& e, bool e_is_container) {
  const InCircleParts<T> parts(t, e);
  const T root = sqrt(gamma(t));
  const T term = root * parts.c();
  const T q = t.with_container ? T(parts.g() - term) : T(parts.g() + term);
  return e_is_container ? T(-q) : q;
}

// positive iff the counterclockwise tangent circle of the triple exists:
// h = D_xp D_xs + D_yp D_ys - epsilon sqrt(Gamma) D_xy > 0; its product with its
// conjugate is (D_xp^2 + D_yp^2)(D_xs^2 + D_ys^2 - D_xy^2).
template <class T>
Sign circle_exists(const TangentTriple<T>& t) {
  const Sign u = sign(T(t.xp * t.xs + t.yp * t.ys));
  const Sign v = t.with_container ? -sign(t.xy) : sign(t.xy);
  if (u == v && u != Sign::unknown) return u;
  return sign_with_root(u, v, sign(T(t.xs * t.xs + t.ys * t.ys - t.xy * t.xy)));
}

// The square root of a number type that has one of its own.
struct OwnRoot {
  template <class T>
  T operator()(const T& x) const {
    return sqrt(x);
  }
};

// The direction n from the base's centre to the centre of the counterclockwise
// tangent circle, times the positive factor N = D_xp^2 + D_yp^2. `square_root`
// takes the root of a nonnegative T. Precondition: the circle exists.
template <class T, class Root = OwnRoot>
std::array<T, 2> circle_direction(const TangentTriple<T>& t, Root&& square_root = {}) {
  const T root = square_root(gamma(t));
  if (t.with_container) {
    return {t.yp * root - t.sp * t.xp, -(t.xp * root) - t.sp * t.yp};
  }
  return {-(t.yp * root) - t.sp * t.xp, t.xp * root - t.sp * t.yp};
}

// Centre and radius of the counterclockwise tangent circle, in that order x, y, rho.
template <class T, class Root = OwnRoot>
std::array<T, 3> tangent_circle(const TangentTriple<T>& t, Root&& square_root = {}) {
  const T n2 = t.xp * t.xp + t.yp * t.yp;
  const T root = square_root(T(n2 - t.sp * t.sp));
  const std::array<T, 2> n = circle_direction(t, square_root);
  const T u = t.xp * t.xs + t.yp * t.ys;
  const T kappa = t.with_container ? T(u - root * t.xy) : T(u + root * t.xy);
  // centre = base + n/N * N/(2 kappa), kappa and n both carrying the factor N.
  const T k2 = kappa + kappa;
  return {t.base.x + n[0] / k2, t.base.y + n[1] / k2, n2 / k2 - t.base.r};
}

// Where the counterclockwise tangent circle of the triple touches its sites and others: the unit
// vector from its centre to the contact. No division by kappa: the circle may be a line.
template <class T>
class ContactDirections {
 public:
  explicit ContactDirections(const TangentTriple<T>& t)
      : base_(t.base), n2_(t.xp * t.xp + t.yp * t.yp), n_(circle_direction(t)), k2_(n2_) {
    const T root = sqrt(T(n2_ - t.sp * t.sp));
    const T u = t.xp * t.xs + t.yp * t.ys;
    const T kappa = t.with_container ? T(u - root * t.xy) : T(u + root * t.xy);
    k2_ = kappa + kappa;
  }
  // The contact with a site that the circle touches.
  std::array<T, 2> of(const Site<T>& s) const {
    const T reach = n2_ + (s.r - base_.r) * k2_;
    return {((s.x - base_.x) * k2_ - n_[0]) / reach, ((s.y - base_.y) * k2_ - n_[1]) / reach};
  }

 private:
  Site<T> base_;
  T n2_;
  std::array<T, 2> n_;
  T k2_;
};

// The contact of two moving sites: with d their offset and w their relative
// velocity, a s^2 + 2 b s + c = |d + w s|^2 - reach^2 vanishes at contact. The reach
// is r_i + r_j, for a disk in the container R - r_i: |r_i + r_j| with signed radii.
template <class T>
struct Contact {
  T a, b, c;
  Contact(const MovingSite<T>& i, const MovingSite<T>& j)
      : Contact(j.x - i.x, j.y - i.y, j.vx - i.vx, j.vy - i.vy, i.r + j.r) {}

 private:
  Contact(const T& dx, const T& dy, const T& wx, const T& wy, const T& reach)
      : a(wx * wx + wy * wy), b(dx * wx + dy * wy), c(dx * dx + dy * dy - reach * reach) {}
};

}  // namespace voroproof::internal
