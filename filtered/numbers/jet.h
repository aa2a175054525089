// Functions of time at one instant, with bounds that are derived beforehand: values in
// double-doubles, slopes in doubles.
#pragma once

#include "exact/rounding.h"
#include "filtered/numbers/lanes.h"

namespace voroproof::internal {

inline constexpr double jet_w = unit_roundoff * unit_roundoff, jet_tiny = 0x1p-900;

// Double-doubles without radii, normalized: |lo| <= u |hi|. While nothing overflows,
//   a + b  errs by at most 4 w (|a.hi| + |b.hi|) =: 4 w M. The leading sum is split exactly into s
//          and e, |e| <= u M. Rounding a.lo + b.lo costs u (u M); adding that to e, 2 u M in all,
//          costs 2 u (u M). The last sum is exact. Together 3 w M.
//   a * b  errs by at most 9 w |a.hi b.hi| =: 9 w M. The leading product is split exactly into p
//          and e, |e| <= u M. Left out: |a.lo b.lo| <= w M. Roundings: the two mixed products, w M
//          each; their sum, of 2 u M, 2 w M; its sum with e, of 3 u M, 3 w M. The last sum is
//          exact, as |p| is the larger. Together 8 w M.
template <class T>
struct Dd {
  T hi, lo;
};

template <class T>
[[gnu::always_inline]] inline Dd<T> operator+(const Dd<T>& a, const Dd<T>& b) {
  T s, e;
  two_sum_of(a.hi, b.hi, s, e);
  Dd<T> r;
  two_sum_of<T>(s, e + (a.lo + b.lo), r.hi, r.lo);
  return r;
}
template <class T>
[[gnu::always_inline]] inline Dd<T> operator-(const Dd<T>& a, const Dd<T>& b) {
  return a + Dd<T>{-b.hi, -b.lo};
}
template <class T>
[[gnu::always_inline]] inline Dd<T> operator*(const Dd<T>& a, const Dd<T>& b) {
  const T p = a.hi * b.hi;
  const T e = product_error(a.hi, b.hi, p) + (a.hi * b.lo + a.lo * b.hi);
  const T s = p + e;
  return {s, e - (s - p)};
}

// A function at a time c: v its value, d its slope; within h of c at most Vh, Dh and D2h in
// magnitude, with its slope and its second derivative.
//
// Notation. u = 2^-53, w = u^2. e_x bounds the distance of a value x to the truth, and the capital
// X bounds |x|. Bounds are sums and products of nonnegative numbers, so that all that is relatively
// small in them (their own roundings, x against its leading part, factors 1 + O(u), products of two
// relative errors) is paid for by the factor `jet_up` that who uses them multiplies them by: some
// hundred operations of relative error 4 u each at most stay far below its 2^-30. `jet_tiny` is
// above what underflow can add to one operation.
//
// Rules.
//   a +- b   the errors of both, 4 w V for the value and u D for the slope.
//   a b      of factors with e_v <= 4 u V.
//            e_v   from the factors A e_b + B e_a + e_a e_b, 9 w V for the product: below 16 w V.
//                  Of factors with e_v <= u V it is at most 3 u V.
//            e_d   of a b' + a' b: from the slopes A e_b' + B e_a'; leading parts of a and b, each
//                  off by 4 u for e and by u for the part below, 5 u D; two products and a sum, 2 u
//                  D. Below 16 u D.
template <class T>
struct Jet {
  Dd<T> v;
  T d;
  T V, D;  // V >= |v|, D >= |d|
  T e_v, e_d;
  T Vh, Dh, D2h;
};

inline constexpr double jet_up = 1 + 0x1p-30;

template <class T>
[[gnu::always_inline]] inline Jet<T> with_value(const Dd<T>& v, const T& d, const Jet<T>& a,
                                                const Jet<T>& b) {
  const T V = a.V + b.V, D = a.D + b.D;
  return {v,
          d,
          V,
          D,
          a.e_v + b.e_v + 4 * jet_w * V,
          a.e_d + b.e_d + unit_roundoff * D,
          a.Vh + b.Vh,
          a.Dh + b.Dh,
          a.D2h + b.D2h};
}
template <class T>
[[gnu::always_inline]] inline Jet<T> operator+(const Jet<T>& a, const Jet<T>& b) {
  return with_value<T>(a.v + b.v, a.d + b.d, a, b);
}
template <class T>
[[gnu::always_inline]] inline Jet<T> operator-(const Jet<T>& a, const Jet<T>& b) {
  return with_value<T>(a.v - b.v, a.d - b.d, a, b);
}
template <class T>
[[gnu::always_inline]] inline Jet<T> operator*(const Jet<T>& a, const Jet<T>& b) {
  const T V = a.V * b.V, D = a.V * b.D + a.D * b.V;
  return {a.v * b.v,
          a.v.hi * b.d + a.d * b.v.hi,
          V,
          D,
          a.V * b.e_v + b.V * a.e_v + a.e_v * b.e_v + 16 * jet_w * V + jet_tiny,
          a.V * b.e_d + b.V * a.e_d + 16 * unit_roundoff * D + jet_tiny,
          a.Vh * b.Vh,
          a.Vh * b.Dh + a.Dh * b.Vh,
          a.D2h * b.Vh + 2 * a.Dh * b.Dh + a.Vh * b.D2h};
}

}  // namespace voroproof::internal
