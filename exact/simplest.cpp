#include "exact/simplest.h"

namespace voroproof::internal {

Rational simplest_between(const Rational& lo, const Rational& hi) {
  const Integer whole = lo.get_num() / lo.get_den();
  if (Rational(whole) == lo) return lo;
  if (Rational(whole + 1) <= hi) return whole + 1;
  const Rational a = hi - whole, b = lo - whole;  // in (0,1)
  return whole + 1 / simplest_between(1 / a, 1 / b);
}

}  // namespace voroproof::internal
