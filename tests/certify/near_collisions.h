// Two collisions that no filter tells apart.
#pragma once

#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {

// A scene with collisions of disks 0 and 1, then of 2 and 3, far from each other: at irrational
// times 1e-45 apart.
inline Scene near_collisions() {
  Integer big;
  mpz_ui_pow_ui(big.get_mpz_t(), 10, 45);
  const Rational later(Integer(1), big);
  const Rational aside(1, 2);
  return scene_of(60, 2,
                  {disk(-20, -3, 1, 0, 0), disk(-20 + aside, 2, 1, 0, -2), disk(20, -3, 1, 0, 0),
                   disk(20 + aside, 2 + 2 * later, 1, 0, -2)});
}

}  // namespace voroproof::internal::testing
