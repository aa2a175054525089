// When two generators meet, in plain doubles: where a test ends, and not what it tests.
#pragma once

#include <cmath>
#include <optional>

#include "filtered/motion/motion.h"

namespace voroproof::internal::testing {

// The time from `now` on at which i < j first touch, as they move now; `now` if they overlap. The
// container is touched from inside.
inline std::optional<double> rough_contact(const Motion& motion, GenId i, GenId j, double now) {
  const DoubleMotion &a = motion.doubles(i), &b = motion.doubles(j);
  const double x = b.x + b.vx * (now - b.t) - a.x - a.vx * (now - a.t),
               y = b.y + b.vy * (now - b.t) - a.y - a.vy * (now - a.t);
  const double vx = b.vx - a.vx, vy = b.vy - a.vy, reach = a.r + b.r;
  // |d + v s|^2 = reach^2
  const double square = vx * vx + vy * vy, half = x * vx + y * vy,
               rest = x * x + y * y - reach * reach;
  const double discriminant = half * half - square * rest;
  const bool in_container = i == container_id;
  if (!(square > 0) || !(discriminant > 0) || (!in_container && !(half < 0))) return std::nullopt;
  const double root = std::sqrt(discriminant);
  return now + std::fmax(0, ((in_container ? root : -root) - half) / square);
}

}  // namespace voroproof::internal::testing
