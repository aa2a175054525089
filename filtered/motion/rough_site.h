// Generators in plain doubles with one error bound each, at an instant or over an interval.
#pragma once

#include "exact/predicates.h"
#include "exact/rounding.h"
#include "filtered/motion/motion.h"
#include "filtered/numbers/lanes.h"

namespace voroproof::internal {

// One generator, or four side by side.
template <class T>
struct RoughSite {
  Site<T> at;
  T error;  // error of both coordinates and of the radius, each
};

// The site of the motion, a DoubleMotion or MotionLanes, within h of the time c. Positions are
// z = z0 + v (c - t) in each coordinate: the difference, the product and the sum are rounded once
// each, the state errs by ex + ev |c - t|, and within the interval the disk moves by at most
// (|v| + ev) h. Half of the 4 u pays for the rounding of the bound.
template <class M>
auto rough_site(const M& m, double c, double h) {
  using T = decltype(m.t + m.t);
  constexpr double u = unit_roundoff;
  const T dt = c - m.t;
  const Site<T> at{m.x + m.vx * dt, m.y + m.vy * dt, m.r};
  const T speed = abs(m.vx) + abs(m.vy);
  const T span = abs(dt) + h;
  const T size = abs(at.x) + abs(at.y) + speed * span;
  return RoughSite<T>{at, (m.ex + m.ev * span + speed * h + 4 * u * size) * (1 + 0x1p-40)};
}

}  // namespace voroproof::internal
