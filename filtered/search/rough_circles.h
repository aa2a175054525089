// The two circles of a V-edge in plain doubles with one error bound.
//
// Derivation of the bounds. u = 2^-53.
//
// Coordinates and radii are within `error` of the truth (rough_site.h).
//
// Offsets to the base of a triple, in x, y and radius: within eta = 2 error + u R, for R a bound of
// |x| + |y| + |s| of all of them, computed and true. Let theta = eta / R + 4 u <= 2^-20. Then, each
// with its largest size and error; roundings, a few u of the size, are in the 4 u of theta,
// products of two errors in the excess of the constants:
//   p = x^2 + y^2 - s^2              R^2     3 R^2 theta      (inputs 2 R eta, roundings 3 u R^2)
//   D_xp = x_j p_k - p_j x_k         2 R^3   10 R^3 theta     (4 + 4, roundings 4 u: 9)
//   D_xs, D_xy                       2 R^2   6 R^2 theta      (4, roundings 4 u: 5)
//   D_xp D_xs + D_yp D_ys            8 R^5   72 R^5 theta     (64, roundings 16 u: 68)
//   D_xs^2 + D_ys^2 - D_xy^2         12 R^4  88 R^4 theta     (72, roundings 32 u: 80)
//   C = x D_yp - y D_xp + p D_xy     6 R^4   44 R^4 theta     (36, roundings 16 u: 40); so A and B
//   G = D_xp A + D_yp B              24 R^7  340 R^7 theta    (296, roundings 48 u: 308)
// Beside the container, whose offset is far longer than those of disks, these bounds are too
// coarse. By components, with a = |x| + |y| + |s| and P = |p| of an offset, computed:
//   p          e = (2 a + 3 eta) eta + 4 u a^2
//   D_xp, D_yp and D_sp together, their factors' errors in turn and 2 u of their products
//              E = a_j e_k + a_k e_j + 3 eta (P_j + P_k + e_j + e_k) + 3 u (a_j P_k + a_k P_j)
//   D_xs, D_ys, D_xy, each
//              d = (a_j + a_k + 2 eta) eta + 3 u a_j a_k
//   D_xp D_xs + D_yp D_ys, with M = |D_xp| + |D_yp| and m = |D_xs| + |D_ys|
//              M d + m E + E d + 3 u M m
//   D_xs^2 + D_ys^2 - D_xy^2, with m and |D_xy| in S
//              (2 S + 3 d) d + 4 u S^2
//   A and B together, a, P and e those of the opposite offset, with K = a (M + |D_sp|) + P m above
//   |A| + |B|; on no way more than three roundings
//              e_AB = a E + eta (M + 2 |D_sp| + 3 E) + 2 P d + e (m + 2 d) + 4 u K
//   G          M e_AB + K E + E e_AB + 3 u M (K + e_AB)
//   C          a E + eta (M + E) + P d + e (|D_xy| + d) + 4 u (a M + P |D_xy|)
// Computing the bounds is rounded as well: the excess of the constants is at least 1 in 20. R is
// kept where no power of it comes near the ends of the range of doubles.
#pragma once

#include <algorithm>

#include "exact/rounding.h"
#include "filtered/motion/motion_lanes.h"
#include "filtered/motion/rough_site.h"
#include "filtered/numbers/lanes.h"
#include "filtered/search/edge_predicates.h"

namespace voroproof::internal {

// The signs of circle_exists() and incircle() for the circles of the edge q = [l,r,s,e] over an
// interval of time, the start (l,s,r) and the end (r,e,l) side by side. A sign is unknown where the
// bound is too coarse.
class RoughCircles {
 public:
  RoughCircles(const Motion& motion, const Quad& q, double lo, double hi)
      : RoughCircles(q, sites(motion, q, lo, hi)) {}

  // Whether the bounds hold. Nothing else may be asked unless they do.
  bool usable() const { return r_ > 0x1p-100 && r_ < 0x1p100 && theta_ <= 0x1p-20; }

  struct Signs {
    Sign start, end;
  };
  Signs exist() const {
    const Lanes direct = t_.xp * t_.xs + t_.yp * t_.ys;
    const Lanes conjugate = t_.xs * t_.xs + t_.ys * t_.ys - t_.xy * t_.xy;
    const auto exists = [&](int k, double direct_bound, double xy_bound, double conjugate_bound) {
      const Sign a = beyond(direct[k], direct_bound);
      const Sign xy = beyond(t_.xy[k], xy_bound);
      const Sign b = with_container_[k] ? -xy : xy;
      return a == b && a != Sign::unknown
                 ? a
                 : sign_with_root(a, b, beyond(conjugate[k], conjugate_bound));
    };
    const auto coarsely = [&](int k) {
      return exists(k, 72 * r4_ * r_ * theta_, 6 * r2_ * theta_, 88 * r4_ * theta_);
    };
    const Signs coarse{coarsely(0), coarsely(1)};
    if (coarse.start != Sign::unknown && coarse.end != Sign::unknown) return coarse;
    const Fine f = fine();
    const Lanes all = f.small + abs(t_.xy);
    const Lanes direct_bound =
        f.large * f.d + f.small * f.e + f.e * f.d + 3 * u * f.large * f.small;
    const Lanes conjugate_bound = (2 * all + 3 * f.d) * f.d + 4 * u * all * all;
    const auto finely = [&](int k) {
      return exists(k, direct_bound[k] * up, f.d[k] * up, conjugate_bound[k] * up);
    };
    return {coarse.start != Sign::unknown ? coarse.start : finely(0),
            coarse.end != Sign::unknown ? coarse.end : finely(1)};
  }
  // Where e lies to the start circle and s to the end circle, given that they exist. `f`: the sign
  // of the cotangency, not zero.
  Signs in_circle(Sign f) const {
    const InCircleParts<Lanes> parts(t_, opposite_);
    const Lanes part = f == Sign::positive ? parts.g() : parts.c();
    const double coarse_bound = (f == Sign::positive ? 340 * r2_ * r_ : 44.0) * r4_ * theta_;
    const auto outside = [&](int k, double bound) {
      const Sign s = beyond(part[k], bound);
      const bool turned = f != Sign::positive && with_container_[k];
      return turned != other_is_container_[k] ? -s : s;
    };
    const Signs coarse{outside(0, coarse_bound), outside(1, coarse_bound)};
    if (coarse.start != Sign::unknown && coarse.end != Sign::unknown) return coarse;
    const Lanes bound = f == Sign::positive ? g_bound(fine()) : c_bound(fine());
    return {coarse.start != Sign::unknown ? coarse.start : outside(0, bound[0] * up),
            coarse.end != Sign::unknown ? coarse.end : outside(1, bound[1] * up)};
  }

 private:
  using Sites = RoughSite<Lanes>;  // on the lanes: l, r, s and e

  static Sites sites(const Motion& motion, const Quad& q, double lo, double hi) {
    const double c = 0.5 * (lo + hi);
    const double h = std::max(hi - c, c - lo) * (1 + 0x1p-50);
    return rough_site(MotionLanes(motion.doubles(q.l), motion.doubles(q.r), motion.doubles(q.s),
                                  motion.doubles(q.e)),
                      c, h);
  }

  // The parts of the two circles: those of the start on the first lane, those of the end on the
  // second; the other two lanes say nothing. The triples are (l,s,r) and (r,e,l), turned so that a
  // disk is first, as tangent_triple() does.
  struct Roles {
    Site<Lanes> base, j, k, opposite;

    Roles(const Quad& q, const Site<Lanes>& at) {
      const LaneMask turned{q.l == container_id ? -1 : 0, q.r == container_id ? -1 : 0, 0, 0};
      const auto set = [&](Lanes Site<Lanes>::*of) {
        const Lanes& first = at.*of;
        const Lanes second = __builtin_shufflevector(first, first, 2, 3, 0, 1);
        const Lanes third = __builtin_shufflevector(first, first, 1, 0, 3, 2);
        base.*of = turned ? second : first;
        j.*of = turned ? third : second;
        k.*of = turned ? first : third;
        opposite.*of = __builtin_shufflevector(first, first, 3, 2, 1, 0);
      };
      set(&Site<Lanes>::x);
      set(&Site<Lanes>::y);
      set(&Site<Lanes>::r);
    }
  };
  static Sign beyond(double x, double bound) {
    return x > bound ? Sign::positive : x < -bound ? Sign::negative : Sign::unknown;
  }

  // The bounds by components.
  static constexpr double u = unit_roundoff, up = 1 + 0x1p-40;
  struct Fine {
    Lanes e, d;          // E and d
    Lanes large, small;  // M and m
  };
  Lanes tangency_error(const Lanes& a) const { return (2 * a + 3 * eta_) * eta_ + 4 * u * a * a; }
  Fine fine() const {
    const Lanes pj = abs(t_.pj), pk = abs(t_.pk);
    const Lanes ej = tangency_error(aj_), ek = tangency_error(ak_);
    return {aj_ * ek + ak_ * ej + 3 * eta_ * (pj + pk + ej + ek) + 3 * u * (aj_ * pk + ak_ * pj),
            (aj_ + ak_ + 2 * eta_) * eta_ + 3 * u * aj_ * ak_, abs(t_.xp) + abs(t_.yp),
            abs(t_.xs) + abs(t_.ys)};
  }
  Lanes opposite_tangency() const {
    const Lanes x = opposite_.x - t_.base.x, y = opposite_.y - t_.base.y;
    const Lanes s = opposite_.r - t_.base.r;
    return abs(x * x + y * y - s * s);
  }
  Lanes g_bound(const Fine& f) const {
    const Lanes p = opposite_tangency(), e = tangency_error(ao_), sp = abs(t_.sp);
    const Lanes k = ao_ * (f.large + sp) + p * f.small;
    const Lanes ab = ao_ * f.e + eta_ * (f.large + 2 * sp + 3 * f.e) + 2 * p * f.d +
                     e * (f.small + 2 * f.d) + 4 * u * k;
    return f.large * ab + k * f.e + f.e * ab + 3 * u * f.large * (k + ab);
  }
  Lanes c_bound(const Fine& f) const {
    const Lanes p = opposite_tangency(), e = tangency_error(ao_), xy = abs(t_.xy);
    return ao_ * f.e + eta_ * (f.large + f.e) + p * f.d + e * (xy + f.d) +
           4 * u * (ao_ * f.large + p * xy);
  }

  RoughCircles(const Quad& q, const Sites& sites)
      : RoughCircles(q, Roles(q, sites.at), sites.error) {}
  RoughCircles(const Quad& q, const Roles& of, const Lanes& errors)
      : t_(of.base, of.j, of.k, false),
        opposite_(of.opposite),
        other_is_container_{q.e == container_id, q.s == container_id} {
    const bool edge_of_container = q.l == container_id || q.r == container_id;
    with_container_[0] = edge_of_container || q.s == container_id;
    with_container_[1] = edge_of_container || q.e == container_id;
    const double error = std::max({errors[0], errors[1], errors[2], errors[3]});
    const auto size_of = [&](const Site<Lanes>& s) -> Lanes {
      return abs(s.x - t_.base.x) + abs(s.y - t_.base.y) + abs(s.r - t_.base.r);
    };
    aj_ = size_of(of.j);
    ak_ = size_of(of.k);
    ao_ = size_of(of.opposite);
    const Lanes largest = larger(larger(aj_, ak_), ao_);
    r_ = (std::max(largest[0], largest[1]) + 6 * error) * (1 + 0x1p-40);
    eta_ = 2 * error + u * r_;
    theta_ = eta_ / r_ + 4 * u;
    r2_ = r_ * r_;
    r4_ = r2_ * r2_;
  }

  TangentTriple<Lanes> t_;
  Site<Lanes> opposite_;
  bool with_container_[2], other_is_container_[2];
  Lanes aj_, ak_, ao_;  // |x| + |y| + |s| of the offsets
  double r_, eta_, theta_, r2_, r4_;
};

}  // namespace voroproof::internal
