// Numbers as answers: two doubles with the true value between them.
#pragma once

#include "exact/ball.h"
#include "exact/rational.h"

namespace voroproof::internal {

struct Enclosure {
  double lo = 0, hi = 0;  // lo <= value <= hi
};

inline Enclosure enclosure(const Ball& ball) {
  Enclosure e;
  ball.to_interval(e.lo, e.hi);
  // The sums make 0 of -0.
  return {e.lo + 0.0, e.hi + 0.0};
}

// The doubles around a number.
inline Enclosure enclosure(const Rational& q) { return {round_down(q), round_up(q)}; }

}  // namespace voroproof::internal
