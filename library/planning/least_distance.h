// How near linear motions come to each other at least, in doubles with bounds of their errors.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/vector3.h"
#include "filtered/numbers/double_ball.h"

namespace voroproof::internal {

using Ball3 = Vector3<DoubleBall>;

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
inline double least_distance(const Ball3& a, const Ball3& b) {
  double along2 = 0, length2 = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double u = b[k].mid - a[k].mid;
    along2 -= a[k].mid * u;
    length2 += u * u;
  }
  const double part = length2 > 0 ? std::clamp(along2 / length2, 0.0, 1.0) : 0;
  Ball3 n;
  for (std::size_t k = 0; k < 3; ++k) n[k] = DoubleBall(a[k].mid + part * (b[k].mid - a[k].mid));
  const DoubleBall length = sqrt(dot(n, n));
  const double least = std::min(low(dot(n, a) / length), low(dot(n, b) / length));
  return least > 0 ? least : 0;
}

}  // namespace voroproof::internal
