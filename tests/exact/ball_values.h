// Balls as rational numbers, for tests.
#pragma once

#include "exact/ball.h"
#include "exact/rational.h"
#include "tests/exact/powers.h"

namespace voroproof::internal::testing {

// Above the radius, by less than a factor of two.
inline Rational radius_of(const Ball& b) {
  return b.is_exact() ? Rational(0) : power_of_two(b.radius().exponent() + 1);
}

}  // namespace voroproof::internal::testing
