#pragma once

#include <cstdint>

#include "exact/rational.h"

namespace voroproof::internal::testing {

inline Rational power_of_two(std::int64_t exponent) {
  Rational q = 1;
  if (exponent >= 0) {
    q <<= static_cast<unsigned long>(exponent);
  } else {
    q >>= static_cast<unsigned long>(-exponent);
  }
  return q;
}

}  // namespace voroproof::internal::testing
