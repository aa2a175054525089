// A fraction by its numerator and denominator, for tests.
#pragma once

#include "exact/rational.h"

namespace voroproof::internal::testing {

inline Rational fraction(long n, long d) {
  Rational q(n, d);
  q.canonicalize();
  return q;
}

}  // namespace voroproof::internal::testing
