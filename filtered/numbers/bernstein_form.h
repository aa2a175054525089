// A flip polynomial over a window of time, in the Bernstein basis and in doubles, with bounds for
// the errors of its coefficients.
#pragma once

#include <array>

namespace voroproof::internal {

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
  // A bound on the differences of the four radii where the form is of C and they differ, else 0.
  // With a bound, f is negative wherever the value of this form is beyond err.
  double spread;
  // Other bounds, for a form of degree 8 that is made for collapses: finer at the start where some
  // of the four go farther than they are apart there.
  GrowingBound bound;
};

}  // namespace voroproof::internal
