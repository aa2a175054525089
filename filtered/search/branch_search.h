// Where the flip polynomial f has roots close together or double ones, the in-circle functions tell
// them apart: f is q times its conjugate up to a positive factor (exact/predicates.h), and a pair
// of roots is mostly one of each. Where the radii are nearly equal, all roots of f come in such
// pairs.
#pragma once

#include <optional>

#include "exact/ball.h"
#include "filtered/motion/motion.h"
#include "filtered/search/collapse.h"
#include "filtered/search/edge_predicates.h"

namespace voroproof::internal {

// The first collapse of q in [start, end] by its in-circle functions, in doubles with error bounds:
// `root`, an isolated one of f; or `none` up to the time up to which there is none, which may be
// `start`.
Collapse search_branches(const Motion& motion, const Quad& q, double start, double end);

// The zero of the in-circle function of q's start between lo, where it is positive, and hi, where
// it is negative, isolated from other roots of f; nullopt where that cannot be seen.
// Preconditions: the edge collapses wherever that function falls in [lo, hi], and no tangency of
// the four vanishes there.
std::optional<Collapse> isolate_on_branch(const Motion& motion, const Quad& q, double lo,
                                          double hi);

// The one root of f in [lo, hi] where an in-circle function of q vanishes there, by the interval
// Newton method for that function; the radius is infinite where that cannot say.
DdBall refine_branch(const Motion& motion, const Quad& q, double lo, double hi);

// The in-circle function of e in the start circle of q, up to a positive factor that depends on
// time.
template <class T>
T start_incircle(const Quad& q, const std::array<Site<T>, 4>& at) {
  return incircle_value(EdgeTriples<T>::of(q, at).start, at[3], q.e == container_id);
}

}  // namespace voroproof::internal
