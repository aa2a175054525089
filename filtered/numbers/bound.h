// Error bounds that are derived beforehand: how large quantities are and how far computed ones are
// from the true ones, carried through the same formulas as the quantities themselves.
#pragma once

#include "exact/rounding.h"

namespace voroproof::internal {

// A bound of numbers, or of all coefficients of forms (filtered/numbers/form.h) before they are
// multiplied by binomials: |computed| <= size and |computed - true| <= err.
//
// A product a b, u = 2^-53: size_a err_b + size_b err_a + err_a err_b for the factors. A
// coefficient of it is a mean of products, with weights that add up to 1, so that what holds of
// numbers holds of it. Up to degree 8 it is a sum of at most five products: five roundings on the
// longest way, below 8 u size_a size_b. Underflow adds less than `bound_tiny`.
//
// Sizes and errors are rounded themselves, each a few times. Who uses a bound multiplies it by
// `bound_up`, which is enough for 2^12 roundings one after the other.
//
// Nothing of this holds where a coefficient overflows, which may be 70 times the size: that is the
// largest binomial of degree 8. Who uses a bound adds u (80 size) or more, computed in this order,
// which is infinite then.
template <class T>
struct Bound {
  T size, err;
};

inline constexpr double bound_up = 1 + 0x1p-40, bound_tiny = 0x1p-1000;

template <class T>
[[gnu::always_inline]] inline Bound<T> operator*(const Bound<T>& a, const Bound<T>& b) {
  const T size = a.size * b.size;
  return {size,
          a.size * b.err + a.err * (b.size + b.err) + (8 * unit_roundoff * size + bound_tiny)};
}

// The bound of the tangency x^2 + y^2 - r^2 (tangency_of()), whose size is at most `size` and where
// |x| + |y| + |r| is at most `reach`, both at each end of a window. Each of x, y and r is a
// difference of two numbers that together err by at most `err`. The differences err by eta = err +
// u reach. A product of two coordinates x x' errs by eta (|x| + |x'|) + eta^2. So the sum of those
// for x and y errs by 2 eta (|x| + |y|) + 2 eta^2, and r^2 by 2 eta |r| + eta^2: together (2 reach
// + 3 eta) eta. A product and two sums on every way: below 4 u size.
template <class T>
[[gnu::always_inline]] inline Bound<T> tangency_bound_of(const T& reach, const T& size,
                                                         const T& err) {
  const T eta = err + unit_roundoff * reach;
  return {size, (2 * reach + 3 * eta) * eta + (4 * unit_roundoff * size + bound_tiny)};
}
// The tangency's bound for |x| + |y| at most `far` and |r| at most `dr`.
template <class T>
[[gnu::always_inline]] inline Bound<T> tangency_bound(const T& far, const T& dr, const T& err) {
  return tangency_bound_of<T>(far + dr, far * far + dr * dr, err);
}
// The tangency's bound where r is zero.
template <class T>
[[gnu::always_inline]] inline Bound<T> tangency_bound(const T& far, const T& err) {
  return tangency_bound_of<T>(far, far * far, err);
}

// The bound of the cotangency (a - b - c)^2 - 4 b c (cotangency_of()) from the sum of the bounds of
// a, b and c, of size S and error E. It is a^2 + b^2 + c^2 - 2 (a b + b c + c a), so at most S^2 in
// magnitude, and errors of a, b and c move it by at most 2 S E + E^2. The difference g of all three
// is rounded twice, 2 u S, and with it g^2 errs by 4 u S^2; the squaring and the product, both at
// most S^2 in magnitude, cost 8 u S^2 each, and the last difference one rounding.
template <class T>
[[gnu::always_inline]] inline Bound<T> cotangency_bound(const Bound<T>& sum) {
  const T size = sum.size * sum.size;
  return {size, (2 * sum.size + sum.err) * sum.err + (24 * unit_roundoff * size + bound_tiny)};
}

// The bound of the determinant x1 y2 - y1 x2 of two offsets with |x| + |y| at most far1 and far2,
// whose coordinates err by at most eta1 and eta2. Its error is at most (|x1| + |y1|) eta2 + (|x2| +
// |y2|) eta1 + 2 eta1 eta2. Over a window every coefficient is a mean of such determinants. Three
// roundings on every way.
template <class T>
[[gnu::always_inline]] inline Bound<T> determinant_bound(const T& far1, const T& eta1,
                                                         const T& far2, const T& eta2) {
  const T size = far1 * far2;
  return {size,
          far1 * eta2 + far2 * eta1 + 2 * eta1 * eta2 + (4 * unit_roundoff * size + bound_tiny)};
}

}  // namespace voroproof::internal
