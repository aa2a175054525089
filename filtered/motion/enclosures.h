// Enclosures of numbers in double-doubles and in balls.
#pragma once

#include <cstdint>

#include "exact/ball.h"
#include "exact/compact_rational.h"
#include "exact/fixed_ball.h"
#include "exact/rational.h"
#include "filtered/numbers/dd_ball.h"

namespace voroproof::internal {

// A number as a double-double: the double next to it and what is left of it.
DdBall dd_of(const Rational& q);
DdBall dd_of(const CompactRational& q);
// A ball, and a fixed-point number times 2^unit, as a double-double.
DdBall dd_of(const Ball& b);
DdBall dd_of(const FixedView& a, std::int64_t unit);

// A number that few bits hold as it is, whatever the precision; else rounded to `bits`.
Ball dyadic_or_rounded(const Rational& q, Ball::Precision bits);

}  // namespace voroproof::internal
