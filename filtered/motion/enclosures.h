// Enclosures of numbers in double-doubles and in balls.
#pragma once

#include "exact/ball.h"
#include "exact/compact_rational.h"
#include "exact/rational.h"
#include "filtered/numbers/dd_ball.h"

namespace voroproof::internal {

// A number as a double-double: the double next to it and what is left of it.
DdBall dd_of(const Rational& q);
DdBall dd_of(const CompactRational& q);
DdBall dd_of(const Ball& b);

// A number that few bits hold as it is, whatever the precision; else rounded to `bits`.
Ball dyadic_or_rounded(const Rational& q, Ball::Precision bits);

}  // namespace voroproof::internal
