// Balls as rational numbers, for tests.
#pragma once

#include "exact/ball.h"
#include "exact/rational.h"
#include "tests/exact/powers.h"

namespace voroproof::internal::testing {

inline Rational midpoint_of(const Ball& b) {
  Rational q;
  mpfr_get_q(q.get_mpq_t(), b.midpoint());
  return q;
}

// Above the radius, by less than a factor of two.
inline Rational radius_of(const Ball& b) {
  return b.is_exact() ? Rational(0) : power_of_two(b.radius().exponent() + 1);
}

}  // namespace voroproof::internal::testing
