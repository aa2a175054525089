#include "exact/rounding.h"

#include <stdexcept>

namespace voroproof::internal {

bool arithmetic_is_ieee() {
  // Read at run time, so that the compiler computes none of it.
  const volatile double one = 1, half_place = 0x1p-53, least = DBL_MIN, near_one = 1 + 0x1p-27,
                        square = 1 + 0x1p-26;
  const double up = one + half_place;               // a tie: to even, 1
  const double odd = (one + 0x1p-52) + half_place;  // a tie: to even, away from zero
  const double down = -one - half_place;            // the same with the other sign
  const volatile double subnormal = least / 2;
  const double exact_if_contracted = near_one * near_one - square;
  const double kept = subnormal * 2;
  return up == 1 && odd == 1 + 0x1p-51 && down == -1 && subnormal > 0 && kept == DBL_MIN &&
         exact_if_contracted == 0;
}

void require_ieee_arithmetic() {
  if (!arithmetic_is_ieee()) {
    throw std::runtime_error(
        "doubles are not rounded to nearest as IEEE 754 says: another rounding mode, subnormal "
        "numbers turned off (-ffast-math), or contracted operations");
  }
}

}  // namespace voroproof::internal
