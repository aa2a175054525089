// Numbers as answers: two doubles with the true value between them.
#pragma once

#include <algorithm>

#include "exact/ball.h"

namespace voroproof {

struct Enclosure {
  double lo = 0, hi = 0;  // lo <= value <= hi
};

inline Enclosure enclosure(const Ball& ball) {
  Enclosure e;
  ball.to_interval(e.lo, e.hi);
  // Not -0.
  return {e.lo + 0.0, e.hi + 0.0};
}

// Of half the value.
inline Enclosure halved(const Enclosure& e) { return {0.5 * e.lo, 0.5 * e.hi}; }

}  // namespace voroproof
