// A generator in plain doubles with one error bound, at an instant or over an interval.
#pragma once

#include <cmath>

#include "exact/predicates.h"
#include "exact/rounding.h"
#include "filtered/motion/motion.h"

namespace voroproof::internal {

struct RoughSite {
  Site<double> at;
  double error;  // of both coordinates and of the radius, each
};

// The site of the motion within h of the time c. Positions are z = z0 + v (c - t) in each
// coordinate: the difference, the product and the sum are rounded once each, the state errs by ex +
// ev |c - t|, and within the interval the disk moves by at most (|v| + ev) h. Half of the 4 u pays
// for the rounding of the bound.
inline RoughSite rough_site(const DoubleMotion& m, double c, double h) {
  constexpr double u = unit_roundoff;
  const double dt = c - m.t;
  const Site<double> at{m.x + m.vx * dt, m.y + m.vy * dt, m.r};
  const double speed = std::fabs(m.vx) + std::fabs(m.vy);
  const double span = std::fabs(dt) + h;
  const double size = std::fabs(at.x) + std::fabs(at.y) + speed * span;
  return {at, (m.ex + m.ev * span + speed * h + 4 * u * size) * (1 + 0x1p-40)};
}

}  // namespace voroproof::internal
