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
// Computing the bounds is rounded as well: the excess of the constants is at least 1 in 20. R is
// kept where no power of it comes near the ends of the range of doubles.
#include "filtered/rough_judge.h"

#include <algorithm>
#include <cmath>

#include "filtered/rough_site.h"

namespace voroproof {

namespace {

constexpr double u = 0x1p-53;

Sign sign_beyond(double x, double bound) {
  return x > bound ? Sign::positive : x < -bound ? Sign::negative : Sign::unknown;
}

// The four generators at the middle of the interval.
struct Rough {
  std::array<Site<double>, 4> at;
  double error = 0;

  Rough(const Motion& motion, const Quad& q, double lo, double hi) {
    const double c = 0.5 * (lo + hi);
    const double h = std::max(hi - c, c - lo) * (1 + 0x1p-50);
    const GenId ids[4] = {q.l, q.r, q.s, q.e};
    for (int k = 0; k < 4; ++k) {
      const RoughSite site = rough_site(motion.doubles(ids[k]), c, h);
      at[k] = site.at;
      error = std::max(error, site.error);
    }
  }
};

// One end of the edge: its tangent circle and the generator opposite.
struct RoughEnd {
  TangentTriple<double> triple;
  const Site<double>& opposite;
  bool opposite_is_container;
  double r2 = 0, theta = 1;  // R^2

  RoughEnd(const TangentTriple<double>& t, const Site<double>& e, bool e_is_container,
           const Rough& rough)
      : triple(t), opposite(e), opposite_is_container(e_is_container) {
    double r = 0;
    for (const Site<double>& s : rough.at) {
      r = std::max(
          r, std::fabs(s.x - t.base.x) + std::fabs(s.y - t.base.y) + std::fabs(s.r - t.base.r));
    }
    r = (r + 6 * rough.error) * (1 + 0x1p-40);
    if (!(r > 0x1p-100 && r < 0x1p100)) return;
    r2 = r * r;
    theta = (2 * rough.error + u * r) / r + 4 * u;
  }

  bool usable() const { return theta <= 0x1p-20; }
  double radius() const { return std::sqrt(r2) * (1 + 0x1p-50); }

  // As circle_exists() and incircle().
  Sign exists() const {
    const TangentTriple<double>& t = triple;
    const Sign a = sign_beyond(t.xp * t.xs + t.yp * t.ys, 72 * r2 * r2 * radius() * theta);
    const Sign xy = sign_beyond(t.xy, 6 * r2 * theta);
    const Sign b = t.with_container ? -xy : xy;
    if (a == b && a != Sign::unknown) return a;
    return sign_with_root(
        a, b, sign_beyond(t.xs * t.xs + t.ys * t.ys - t.xy * t.xy, 88 * r2 * r2 * theta));
  }
  Sign outside(Sign f) const {
    const InCircleParts<double> parts(triple, opposite);
    Sign sign = Sign::unknown;
    if (f == Sign::positive) {
      sign = sign_beyond(parts.g(), 340 * r2 * r2 * r2 * radius() * theta);
    } else {
      sign = sign_beyond(parts.c(), 44 * r2 * r2 * theta);
      if (triple.with_container) sign = -sign;
    }
    return opposite_is_container ? -sign : sign;
  }
};

}  // namespace

Verdict judge_roughly(const Motion& motion, const Quad& q, double lo, double hi, Sign f) {
  const Rough rough(motion, q, lo, hi);
  const auto triples = EdgeTriples<double>::of(q, rough.at);
  const RoughEnd start(triples.start, rough.at[3], q.e == container_id, rough);
  const RoughEnd end(triples.end, rough.at[2], q.s == container_id, rough);
  if (!start.usable() || !end.usable()) return Verdict::unknown;
  const Sign start_exists = start.exists();
  if (start_exists == Sign::negative) return Verdict::stays;
  const Sign end_exists = end.exists();
  if (end_exists == Sign::negative) return Verdict::stays;
  if (start_exists != Sign::positive || end_exists != Sign::positive) return Verdict::unknown;
  const Sign a = start.outside(f);
  if (a == Sign::positive) return Verdict::stays;
  const Sign b = end.outside(f);
  if (b == Sign::positive) return Verdict::stays;
  return a == Sign::negative && b == Sign::negative ? Verdict::collapses : Verdict::unknown;
}

}  // namespace voroproof
