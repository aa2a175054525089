// The simplest rational between two.
#pragma once

#include "exact/rational.h"

namespace voroproof::internal {

// The rational of least denominator in [lo, hi], 0 < lo < hi: by continued fractions.
Rational simplest_between(const Rational& lo, const Rational& hi);

}  // namespace voroproof::internal
