// Certified isolation of real roots.
//
// The polynomial is written in the Bernstein basis of an interval; by Descartes' rule
// the number of sign variations of the coefficients exceeds the number of roots in
// the open interval, with multiplicity, by an even number, so that 0 and 1 are
// conclusive; otherwise the interval is bisected, which ends for simple roots
// (Vincent's theorem): G. Collins, A. Akritas, "Polynomial real root isolation using
// Descartes' rule of signs", SYMSAC 1976; B. Mourrain, F. Rouillier, M.-F. Roy, "The
// Bernstein basis and real root isolation", in Combinatorial and Computational
// Geometry (MSRI 52, 2005). De Casteljau's subdivision runs over the integers. Over a
// tower the coefficients are integers up to an error bound, with unknown signs where
// that leaves them open, more precision where those matter, and exact signs of the
// polynomial itself at interval ends. Only what looks like a multiple root makes the
// square-free part be computed.
//
// Sturm's sequence f, f', -rem, ... decides the same in another way: its loss of sign
// variations from a to b is the number of distinct roots in (a, b]; see C. Yap,
// Fundamental Problems of Algorithmic Algebra (Oxford 2000), chapter 7. Its
// coefficients grow fast over a tower.
//
// A root is narrowed by quadratic interval refinement (J. Abbott, "Quadratic interval refinement
// for real roots", ACM Communications in Computer Algebra 48, 2014): the secant foretells in which
// of 2^k parts of the interval the root lies, two signs prove it, and the next step takes 2^2k. The
// parts are those of bisection, so that the interval is, too.
//
// All templates are instantiated for Rational and Tower.
#pragma once

#include <vector>

#include "exact/polynomial.h"
#include "exact/rational.h"
#include "exact/sign_evaluator.h"

namespace voroproof::internal {

// One distinct real root of a polynomial f: the root itself if lo == hi; otherwise
// it lies strictly inside, it is the only distinct root of f in [lo, hi], and f is
// nonzero at both ends. (A rational root need not have lo == hi.)
struct RootInterval {
  Rational lo, hi;
  bool is_point() const { return lo == hi; }
};

// The distinct roots of f in the closed interval [lo, hi], in increasing order.
// The intervals returned lie inside it, except that neighbours may share an end.
// Throws std::invalid_argument for f = 0 or lo > hi.
template <class T>
std::vector<RootInterval> isolate_roots(const Polynomial<T>& f, const Rational& lo,
                                        const Rational& hi);

// Whether f is seen to have no root in [lo, hi] by one look at its coefficients there
// (lo < hi); false proves nothing.
template <class T>
bool is_plainly_rootless(const Polynomial<T>& f, const Rational& lo, const Rational& hi);

// Narrows to the interval that bisection gives, until the width is at most `width` (> 0, or
// std::invalid_argument) or the root is met. Roots of even multiplicity cost a square-free part a
// call.
template <class T>
void refine(const Polynomial<T>& f, RootInterval& root, const Rational& width);
// The same of a root where f changes its sign; at_lo is f's sign at root.lo (and stays so).
template <class T>
void refine(const SignEvaluator<T>& f, Sign at_lo, RootInterval& root, const Rational& width);

// One bisection of such an interval, which is no point.
template <class T>
void halve(const SignEvaluator<T>& f, Sign at_lo, RootInterval& root);

// The signs of f just before and just after a root of f: different iff the
// multiplicity is odd.
struct SignsAround {
  Sign before, after;
  friend bool operator==(const SignsAround&, const SignsAround&) = default;
};
template <class T>
SignsAround signs_around(const Polynomial<T>& f, const RootInterval& root);

}  // namespace voroproof::internal
