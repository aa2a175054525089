// How near linear motions come to each other at least, in doubles with bounds of their errors.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "filtered/numbers/double_ball.h"

namespace voroproof::internal {

struct Ball2 {
  DoubleBall x, y;
};

inline DoubleBall ball_of(const Rational& q) {
  return DoubleBall::hull(round_down(q), round_up(q));
}

// A certain lower bound of the ball; no bound where an overflow made it NaN.
inline double low(const DoubleBall& d) {
  const double low = d.mid - d.rad * (1 + 0x1p-50) - std::fabs(d.mid) * 0x1p-50;
  return low == low ? low : -std::numeric_limits<double>::infinity();
}

// A certain lower bound of the distance of the origin from the segment from a to b: for any
// direction n that is at least min(n.a, n.b) / |n|. The bound is sharp for n towards the nearest
// point, of which n needs to be no more than a guess.
inline double least_distance(const Ball2& a, const Ball2& b) {
  const double u = b.x.mid - a.x.mid, v = b.y.mid - a.y.mid, length2 = u * u + v * v;
  const double part =
      length2 > 0 ? std::clamp(-(a.x.mid * u + a.y.mid * v) / length2, 0.0, 1.0) : 0;
  const DoubleBall x(a.x.mid + part * u), y(a.y.mid + part * v);
  const DoubleBall length = sqrt(x * x + y * y);
  const auto along = [&](const Ball2& p) { return low((x * p.x + y * p.y) / length); };
  const double least = std::min(along(a), along(b));
  return least > 0 ? least : 0;
}

}  // namespace voroproof::internal
