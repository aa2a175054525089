// One Newton step for the root of a flip polynomial, with a bound derived beforehand: cheaper than
// balls, which bound every operation.
#pragma once

#include "exact/generators.h"
#include "filtered/motion/motion.h"

namespace voroproof::internal {

// The one root in [lo, hi] of the flip polynomial of q's generators (exact/predicates.h), the
// cotangency f or, where they are `cocircular` as flip_polynomial_is_cocircularity() says, C, as a
// double-double with a bound of its error. The radius is infinite where the step cannot say: where
// the slope may vanish in [lo, hi], or numbers leave the range of binary64.
// Precondition: the polynomial has a root there; lo and hi are finite.
DdBall newton_step(const Motion& motion, const Quad& q, double lo, double hi, bool cocircular);

}  // namespace voroproof::internal
