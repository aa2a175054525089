// The flip polynomial of a quadruplet over a window of time, in the Bernstein basis
// and in doubles, with bounds for the errors of its coefficients.
#pragma once

#include <array>

#include "filtered/motion.h"

namespace voroproof {

// Coefficient k is within first * growth^k of the true one.
struct GrowingBound {
  double first, growth;
};

// Coefficients c[0..degree] on a window: c[0] and c[degree] are the values at its
// ends, and the values inside lie between the smallest and the largest. The degree
// is 8 (cotangency) or, for four equal radii, 4 (cocircularity): see
// flip_polynomial_is_cocircularity. (Of nearly equal ones, too, where form_for_collapse() says so.)
struct BernsteinForm {
  std::array<double, 9> c;
  int degree;
  double err;  // every true coefficient is within err of c[k]; 0 in the plain instance
  // Of C for four radii that differ: a bound on their differences. f is negative wherever the value
  // of this form is beyond err. Else 0.
  double spread;
  // Of degree 8, made for collapses: other bounds, finer at the start where some of the four go
  // farther than they are apart there.
  GrowingBound bound;
};

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

// The same, but for four nearly equal radii C again, with a spread: the roots of f lie in pairs
// close together then, where C has a simple one. True: f has no root in [a, b].
bool form_for_collapse(const Motion& motion, const Quad& q, double a, double b, BernsteinForm& out);

}  // namespace voroproof
