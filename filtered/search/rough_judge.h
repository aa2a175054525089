// Judging a root in plain doubles with one error bound: cheaper than balls, and nearly always
// enough.
#pragma once

#include "filtered/motion/motion.h"
#include "filtered/search/edge_predicates.h"

namespace voroproof::internal {

// Judges q at the root of its flip polynomial in [lo, hi], beyond which the cotangency of the four
// has the sign `f`, not zero: judge() over the whole interval. unknown where the bound is too
// coarse.
Judgement judge_roughly(const Motion& motion, const Quad& q, double lo, double hi, Sign f);

// Judges q at a root of C in [lo, hi], whose sign beyond it is `after`, for four disks of equal
// radii: C is the in-circle function of both circles, and an orientation tells whether one exists.
// For radii that differ, by at most `spread`, where f is negative at lo and at hi, C has different
// signs there:
// - stays: no collapse in [lo, hi];
// - collapses: both in-circle functions are positive at lo and negative at hi, their zeros between
//   are the same ones, and the edge collapses where they fall.
Judgement judge_cocircular(const Motion& motion, const Quad& q, double lo, double hi, double spread,
                           Sign after);

}  // namespace voroproof::internal
