// How the four generators of a quadruplet, side by side in the lanes l, r, s and e, are paired for
// the flip polynomial. The last lane of a pairing says nothing; it repeats one.
#pragma once

#include "filtered/numbers/lanes.h"

namespace voroproof::internal {

// The pairs lr, ls, le and the pairs se, re, rs: products of tangencies of both are the a, b and c
// of cotangency_of().
struct PairsWithL {
  static Lanes first(const Lanes& x) { return __builtin_shufflevector(x, x, 0, 0, 0, 0); }
  static Lanes second(const Lanes& x) { return __builtin_shufflevector(x, x, 1, 2, 3, 3); }
};
struct OtherPairs {
  static Lanes first(const Lanes& x) { return __builtin_shufflevector(x, x, 2, 1, 1, 1); }
  static Lanes second(const Lanes& x) { return __builtin_shufflevector(x, x, 3, 3, 2, 2); }
};

// The pairs le, re, se of the cocircularity with the base e.
struct PairsWithBase {
  static Lanes first(const Lanes& x) { return x; }
  static Lanes second(const Lanes& x) { return __builtin_shufflevector(x, x, 3, 3, 3, 3); }
};
// The values of l, r and s, moved to the lane before, in cyclic order, and to the one before that.
inline Lanes next(const Lanes& x) { return __builtin_shufflevector(x, x, 1, 2, 0, 3); }
inline Lanes last(const Lanes& x) { return __builtin_shufflevector(x, x, 2, 0, 1, 3); }

template <class Pairs>
Lanes difference(const Lanes& x) {
  return Pairs::first(x) - Pairs::second(x);
}
template <class Pairs>
Lanes sum(const Lanes& x) {
  return Pairs::first(x) + Pairs::second(x);
}

// The sum of the first three lanes, which are those that say something.
inline double total(const Lanes& x) { return x[0] + x[1] + x[2]; }

}  // namespace voroproof::internal
