// Where a generator is at both ends of a window of time, and how precisely that is known: for
// doubles, or for several generators or windows side by side.
#pragma once

#include "exact/rounding.h"
#include "filtered/numbers/lanes.h"

namespace voroproof::internal {

// Error bound. A coordinate is x + v dt: dt, the product and the sum are rounded once each, which
// is below 2 u |x| + 4 u |v dt|, and the motion's own errors add ex + ev |dt|. The bound is rounded
// itself: what is made of it has to be multiplied by `bound_up`. It does not hold where a
// coordinate is infinite or not a number, and need not be infinite then.
template <class T>
struct WindowPlaces {
  T x0, y0, x1, y1;  // at a and at b
  T speed;           // most of a coordinate's speed
  T error;           // most error of each coordinate and of the radius

  // M: DoubleMotion, or MotionLanes.
  template <class M>
  [[gnu::always_inline]] WindowPlaces(const M& m, const T& a, const T& b) {
    const T ta = a - m.t, tb = b - m.t;
    x0 = m.x + m.vx * ta;
    y0 = m.y + m.vy * ta;
    x1 = m.x + m.vx * tb;
    y1 = m.y + m.vy * tb;
    const T v = abs(m.vx) + abs(m.vy);
    speed = v + m.ev;
    error = 2 * unit_roundoff * (abs(m.x) + abs(m.y)) + m.ex +
            (4 * unit_roundoff * v + m.ev) * (abs(ta) + abs(tb));
  }
};

}  // namespace voroproof::internal
