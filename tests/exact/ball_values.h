// Balls as rational numbers, for tests.
#pragma once

#include <cstdint>

#include "exact/ball.h"
#include "exact/rational.h"

namespace voroproof {

inline Rational power_of_two(std::int64_t exponent) {
  Rational q = 1;
  if (exponent >= 0) {
    q <<= static_cast<unsigned long>(exponent);
  } else {
    q >>= static_cast<unsigned long>(-exponent);
  }
  return q;
}

inline Rational midpoint_of(const Ball& b) {
  Rational q;
  mpfr_get_q(q.get_mpq_t(), b.midpoint());
  return q;
}

// Above the radius, by less than a factor of two.
inline Rational radius_of(const Ball& b) {
  return b.is_exact() ? Rational(0) : power_of_two(b.radius().exponent() + 1);
}

}  // namespace voroproof
