// The flip polynomial of a quadruplet over a window of time, in the Bernstein basis
// and in doubles, with bounds for the errors of its coefficients.
#pragma once

#include "filtered/motion/motion.h"
#include "filtered/numbers/bernstein_form.h"

namespace voroproof::internal {

// Whether the four sites have exactly one common radius: then f = -C^2 has even
// roots only, and C itself is the polynomial whose roots are isolated.
bool flip_polynomial_is_cocircularity(const Motion& motion, const Quad& q);

// Forms the polynomial of q = (l, r, s, e) over [a, b], a < b.
// `certified` selects whether the error bound is computed (it is 0 otherwise).
// Returns true when all coefficients certainly have one sign, so that there is no
// root in [a, b]; then `out` is not complete.
template <bool certified>
bool form_flip_polynomial(const Motion& motion, const Quad& q, double a, double b,
                          BernsteinForm& out);

// Forms the polynomial as form_flip_polynomial() does, but takes C, with a spread, for four nearly
// equal radii, too: the roots of f lie in pairs close together then, where C has a simple one.
// True: f has no root in [a, b].
bool form_for_collapse(const Motion& motion, const Quad& q, double a, double b, BernsteinForm& out);

// Whether the four generators of q are separated throughout [a, b], a <= b: the tangency of every
// two disks is positive, that of a disk and the container negative. False says nothing.
// Precondition: q.s != q.e.
bool are_separated(const Motion& motion, const Quad& q, double a, double b);

}  // namespace voroproof::internal
