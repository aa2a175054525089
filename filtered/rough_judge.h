// Judging a root in plain doubles with one error bound: cheaper than balls, and nearly always
// enough.
#pragma once

#include "filtered/edge_predicates.h"
#include "filtered/motion.h"

namespace voroproof {

// What becomes of q at the root of its flip polynomial in [lo, hi], beyond which the cotangency of
// the four has the sign `f`, not zero: judge() over the whole interval. unknown where the bound is
// too coarse.
Verdict judge_roughly(const Motion& motion, const Quad& q, double lo, double hi, Sign f);

}  // namespace voroproof
