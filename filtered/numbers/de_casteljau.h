// De Casteljau's scheme for polynomials in the Bernstein basis, in doubles and in lanes.
#pragma once

#include <type_traits>

namespace voroproof::internal {

// One level: w[k] becomes at(w[k], w[k + 1]). The loops are unrolled by recursion on constants, so
// that w stays in registers.
template <int k, int last, class T, class At>
[[gnu::always_inline]] inline void combine(T* w, const At& at) {
  if constexpr (k < last) {
    w[k] = at(w[k], w[k + 1]);
    combine<k + 1, last>(w, at);
  }
}

// All levels; after each calls then(rest), a constant: w[0..rest] are what is left.
template <int degree, class T, class At, class Then>
[[gnu::always_inline]] inline void each_level(T* w, const At& at, const Then& then) {
  if constexpr (degree > 0) {
    combine<0, degree>(w, at);
    then(std::integral_constant<int, degree - 1>());
    each_level<degree - 1>(w, at, then);
  }
}

}  // namespace voroproof::internal
