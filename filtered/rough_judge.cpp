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
// Before the templates that are used with lanes: it says that they may be.
#include "filtered/lanes.h"

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

// The triples of both ends of the edge in two lanes, start and end, and the generators opposite.
struct RoughEnds {
  TangentTriple<Lanes> triples;
  Site<Lanes> opposite;
  double r, theta;

  // `start` and `end`: where base, j, k and the opposite are among the four sites.
  RoughEnds(const std::array<RoughSite, 4>& sites, const std::array<int, 4>& start,
            const std::array<int, 4>& end)
      : triples(pick(sites, start[0], end[0]), pick(sites, start[1], end[1]),
                pick(sites, start[2], end[2]), false),
        opposite(pick(sites, start[3], end[3])) {
    double error = 0;
    for (const RoughSite& s : sites) error = std::max(error, s.error);
    Lanes largest{};
    for (int k = 1; k < 4; ++k) {
      const Site<Lanes> s = pick(sites, start[k], end[k]);
      const Lanes size =
          abs(s.x - triples.base.x) + abs(s.y - triples.base.y) + abs(s.r - triples.base.r);
      largest = 0.5 * (largest + size + abs(largest - size));
    }
    r = (std::max(largest[0], largest[1]) + 6 * error) * (1 + 0x1p-40);
    theta = (2 * error + u * r) / r + 4 * u;
  }

  bool usable() const { return r > 0x1p-100 && r < 0x1p100 && theta <= 0x1p-20; }

 private:
  static Site<Lanes> pick(const std::array<RoughSite, 4>& sites, int start, int end) {
    const Site<double>&a = sites[start].at, &b = sites[end].at;
    return {Lanes{a.x, b.x, 0, 0}, Lanes{a.y, b.y, 0, 0}, Lanes{a.r, b.r, 0, 0}};
  }
};

}  // namespace

Verdict judge_roughly(const Motion& motion, const Quad& q, double lo, double hi, Sign f) {
  const double c = 0.5 * (lo + hi);
  const double h = std::max(hi - c, c - lo) * (1 + 0x1p-50);
  const std::array<RoughSite, 4> sites{
      rough_site(motion.doubles(q.l), c, h), rough_site(motion.doubles(q.r), c, h),
      rough_site(motion.doubles(q.s), c, h), rough_site(motion.doubles(q.e), c, h)};
  // The triples (l,s,r) and (r,e,l), a disk first: as tangent_triple().
  using Places = std::array<int, 4>;
  const RoughEnds ends(sites, q.l == container_id ? Places{2, 1, 0, 3} : Places{0, 2, 1, 3},
                       q.r == container_id ? Places{3, 0, 1, 2} : Places{1, 3, 0, 2});
  if (!ends.usable()) return Verdict::unknown;
  const bool edge_of_container = q.l == container_id || q.r == container_id;
  const bool with_container[2] = {edge_of_container || q.s == container_id,
                                  edge_of_container || q.e == container_id};
  const TangentTriple<Lanes>& t = ends.triples;
  const double r2 = ends.r * ends.r, r4 = r2 * r2, theta = ends.theta;

  // As circle_exists().
  const Lanes direct = t.xp * t.xs + t.yp * t.ys;
  const Lanes conjugate = t.xs * t.xs + t.ys * t.ys - t.xy * t.xy;
  for (int k = 0; k < 2; ++k) {
    const Sign a = sign_beyond(direct[k], 72 * r4 * ends.r * theta);
    const Sign xy = sign_beyond(t.xy[k], 6 * r2 * theta);
    const Sign b = with_container[k] ? -xy : xy;
    const Sign exists = a == b && a != Sign::unknown
                            ? a
                            : sign_with_root(a, b, sign_beyond(conjugate[k], 88 * r4 * theta));
    if (exists == Sign::negative) return Verdict::stays;
    if (exists != Sign::positive) return Verdict::unknown;
  }

  // As incircle().
  const InCircleParts<Lanes> parts(t, ends.opposite);
  const Lanes part = f == Sign::positive ? parts.g() : parts.c();
  const double bound = (f == Sign::positive ? 340 * r2 * ends.r : 44.0) * r4 * theta;
  bool known = true;
  for (int k = 0; k < 2; ++k) {
    Sign outside = sign_beyond(part[k], bound);
    if (f != Sign::positive && with_container[k]) outside = -outside;
    if ((k == 0 ? q.e : q.s) == container_id) outside = -outside;
    if (outside == Sign::positive) return Verdict::stays;
    known = known && outside == Sign::negative;
  }
  return known ? Verdict::collapses : Verdict::unknown;
}

}  // namespace voroproof
