#include "filtered/search/rough_judge.h"

#include <algorithm>
#include <cmath>

#include "exact/rounding.h"
#include "filtered/motion/rough_site.h"
#include "filtered/search/rough_circles.h"

namespace voroproof::internal {

namespace {

struct Orientation {
  double doubled_area;
  double size;  // the sum of the absolute coordinates of both offsets
};

Orientation orientation(const Site<double>& a, const Site<double>& b, const Site<double>& c) {
  const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  return {bx * cy - by * cx, (std::fabs(bx) + std::fabs(by)) + (std::fabs(cx) + std::fabs(cy))};
}

// Whether three disks, whose radii differ by at most `spread`, have a counterclockwise tangent
// circle, which then is the only one. With h of circle_exists(), d and d' the offsets to the first
// disk and dr, dr' those of the radii: h has the sign of d x d', and its conjugate the other one,
// where |dr d' - dr' d| <= spread (|d| + |d'|) < |d x d'|. No tangency vanishes there, because
// |d x d'| is at most the product of any two sides of the triangle, so that each exceeds `spread`;
// nor that of the two beyond a common side, each of whose heights on it does.
// Offsets err by eta each, in x and in y, the area by (size + 2 eta) eta and 3u of its products,
// whose sum is at most size^2 / 4.
Sign counterclockwise(const RoughSite<double>& a, const RoughSite<double>& b,
                      const RoughSite<double>& c, double spread) {
  constexpr double u = unit_roundoff;
  const auto [area, size] = orientation(a.at, b.at, c.at);
  const double eta = 2 * std::max({a.error, b.error, c.error}) + u * size;
  const double bound =
      ((size + 2 * eta) * eta + u * (size * size) + spread * (size + 4 * eta)) * (1 + 0x1p-40) +
      1e-290;
  return area > bound ? Sign::positive : area < -bound ? Sign::negative : Sign::unknown;
}

}  // namespace

// The proof for radii that differ: at lo and at hi, f = 0 holds for no radii between the given ones
// and one common radius, so that C keeps its sign, which is that of both in-circle functions where
// f is negative. A zero of one of these functions is one of the other, because a circle that
// touches all four touches each three of them counterclockwise: no other exists.
Judgement judge_cocircular(const Motion& motion, const Quad& q, double lo, double hi, double spread,
                           Sign after) {
  if (spread == 0 && after == Sign::positive) return Judgement::stays;
  const double c = 0.5 * (lo + hi);
  const double h = std::max(hi - c, c - lo) * (1 + 0x1p-50);
  const RoughSite<double> l = rough_site(motion.doubles(q.l), c, h);
  const RoughSite<double> r = rough_site(motion.doubles(q.r), c, h);
  const Sign start = counterclockwise(l, rough_site(motion.doubles(q.s), c, h), r, spread);
  if (start == Sign::negative) return Judgement::stays;
  const Sign end = counterclockwise(r, rough_site(motion.doubles(q.e), c, h), l, spread);
  if (end == Sign::negative) return Judgement::stays;
  return start == Sign::positive && end == Sign::positive && after == Sign::negative
             ? Judgement::collapses
             : Judgement::unknown;
}

Judgement judge_roughly(const Motion& motion, const Quad& q, double lo, double hi, Sign f) {
  const RoughCircles circles(motion, q, lo, hi);
  if (!circles.usable()) return Judgement::unknown;
  const auto [start, end] = circles.exist();
  for (const Sign exists : {start, end}) {
    if (exists == Sign::negative) return Judgement::stays;
    if (exists != Sign::positive) return Judgement::unknown;
  }
  const auto [e, s] = circles.in_circle(f);
  if (e == Sign::positive || s == Sign::positive) return Judgement::stays;
  return e == Sign::negative && s == Sign::negative ? Judgement::collapses : Judgement::unknown;
}

}  // namespace voroproof::internal
