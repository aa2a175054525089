// Whether the flip polynomial of a quadruplet (the paper's Eqs. 1 and 2) has a root at all, be it a
// collapse of its edge or not.
#pragma once

#include "exact/generators.h"
#include "filtered/motion/motion.h"

namespace voroproof::internal {

// A root in (start, end): certain if it says no; and if it says yes, but for a root of even order,
// which the precision of the motion does not tell from a near miss. A polynomial that is not told
// from zero throughout has none.
bool flip_polynomial_has_root(const Motion& motion, const Quad& q, double start, double end);

}  // namespace voroproof::internal
