// Proofs about one V-edge over an interval of time, in doubles with error bounds.
//
// An edge [l,r,s,e] that exists just after a certainly collapses at no time of (a, b] if over each
// part of a subdivision of [a, b] one of these holds:
//   - its flip polynomial has no root in the part (its Bernstein coefficients have one sign; those
//     of C, beyond what the radii can do to it, for nearly equal radii);
//   - the radii are equal and C, then the in-circle function of both circles, has one root in the
//     part at most and is positive at its end;
//   - one of its two in-circle functions is positive throughout the part: a collapse makes both
//     negative just after it (paper, section 4.3);
//   - one of its circles exists at no time of the part;
//   - its flip polynomial has one root in the part at most, no tangency of two of the four vanishes
//     in it, and at its end one of the in-circle functions is positive. (Then Gamma is positive in
//     the part, so that the in-circle functions are continuous, and they vanish only where the flip
//     polynomial does: one that is negative after a collapse is so at the end.)
// That is another argument than the engine's, which isolates roots one by one and reads a verdict
// off each. Both answers below are proofs when true and say nothing when false.
#pragma once

#include <optional>

#include "filtered/motion/motion.h"
#include "filtered/search/collapse.h"

namespace voroproof::internal {

// Whether q, legal just after a, provably does not collapse in (a, b], under the present motion of
// its generators.
bool proved_free(const Motion& motion, const Quad& q, double a, double b);

// Whether proved_free() holds, given that the flip polynomial has at most one root in [a, b] and
// that the four are separated throughout (RootlessBatch::one_root). `f`: the sign of their
// cotangency at b, or unknown.
bool proved_free_of_one(const Motion& motion, const Quad& q, double b, Sign f);

// Whether q provably has exactly one root of its flip polynomial in [a, b], not at an end, and
// collapses there.
bool proved_collapse(const Motion& motion, const Quad& q, double a, double b);

// Whether proved_collapse() holds and q, legal just after `from`, provably does not collapse in
// (from, a].
bool proved_first_collapse(const Motion& motion, const Quad& q, double from, double a, double b);

// Proves what proved_collapse() proves, by one step of the interval Newton method in
// double-doubles, where the error bound of doubles is too wide: a step that maps [a, b] into its
// inside proves one simple root there (R. Krawczyk, Computing 4, 1969; R. Moore, Methods and
// Applications of Interval Analysis, 1979). Gives the root's enclosure.
std::optional<DdBall> newton_collapse(const Motion& motion, const CollapseSearch& search,
                                      const Quad& q, double a, double b);

// Whether the root of q in [lo, hi] is provably no flip of an edge of a diagram: before or after it
// a generator lies in another or a circle does not exist, q is illegal before it, or legal after
// it.
bool proved_no_flip(const Motion& motion, const Quad& q, const Rational& lo, const Rational& hi);

// Whether q is provably illegal at t, its generators being separated: both in-circle functions are
// negative.
bool proved_illegal(const Motion& motion, const Quad& q, const Rational& t);

// Whether the four generators of q are provably not cotangent at any time of t, which is a
// DoubleBall or Ball.
template <class T>
bool proved_not_cotangent(const Motion& motion, const Quad& q, const T& t) {
  return is_certain(sign(cotangency(motion.site(q.l, t), motion.site(q.r, t), motion.site(q.s, t),
                                    motion.site(q.e, t))));
}

}  // namespace voroproof::internal
