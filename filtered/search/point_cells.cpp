#include "filtered/search/point_cells.h"

#include <algorithm>
#include <string>

namespace voroproof::internal {

namespace {

// Whether the two certainly differ in velocity at the instant t.
template <class T>
bool differ(const Motion& motion, GenId i, GenId j, const T& t) {
  const MovingSite<T> a = motion.moving_site(i, t), b = motion.moving_site(j, t);
  const auto nonzero = [](Sign s) { return s == Sign::negative || s == Sign::positive; };
  return nonzero(sign(T(a.vx - b.vx))) || nonzero(sign(T(a.vy - b.vy)));
}

}  // namespace

PointCells::PointCells(const Motion& motion, const ContactSearch& contacts)
    : motion_(motion), contacts_(contacts) {
  const auto& disks = motion.input().disks;
  any_ = std::any_of(disks.begin(), disks.end(),
                     [](const DiskInput& d) { return sgn(d.radius) == 0; });
}

bool PointCells::is_point(GenId g) const {
  return g != container_id && sgn(motion_.input().disks[g].radius) == 0;
}

// A line meets a circle at single times: whoever has another velocity leaves.
bool PointCells::certainly_leaves(GenId point, GenId other, const Moment& now) const {
  return differ(motion_, point, other, DoubleBall::hull(now.lo, now.hi)) ||
         differ(motion_, point, other, now.dd) ||
         differ(motion_, point, other, Ball(now.lo, motion_.goal_bits() + 32));
}

void PointCells::require_area(GenId point, const std::vector<GenId>& neighbours,
                              const Moment& now) const {
  int touched = 0;
  for (const GenId other : neighbours) {
    const auto [i, j] = std::minmax(point, other);
    if (contacts_.certainly_apart(i, j, now) || contacts_.apart_by_balls(i, j, now)) continue;
    if (++touched > 1) {
      throw Undecided("the point " + std::to_string(point) +
                          " may touch two generators at one instant: its cell has no area then",
                      i, j);
    }
    if (!certainly_leaves(point, other, now)) {
      throw Undecided("the point " + std::to_string(point) +
                          " may rest on another generator: its cell has no area then",
                      i, j);
    }
  }
}

}  // namespace voroproof::internal
