// The roots of polynomials after an instant of a world.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "engine/world/moving_rows.h"

namespace voroproof::internal {

// Roots are narrowed to this part of all the time there is: then balls tell most signs at them, and
// few have to be compared exactly.
inline constexpr int kBitsOfTimes = 60;

// The roots of f, which is not constant, after `now` and up to `end`, in order. `vanishes`: f is
// known to vanish at `now`, so that no comparison has to find out.
std::vector<WorldTime> roots_after(const TimePolynomial& f, const WorldTime& now, bool vanishes,
                                   const Rational& end);

// The first of them for which is_right(t, sign of f just after t).
template <class IsRight>
std::optional<WorldTime> first_root(const TimePolynomial& f, const WorldTime& now,
                                    const Rational& end, IsRight&& is_right,
                                    bool vanishes = false) {
  if (f.degree() < 1) return std::nullopt;
  for (WorldTime& root : roots_after(f, now, vanishes, end)) {
    if (!root.is_point()) root.refine(end >> kBitsOfTimes);
    if (is_right(std::as_const(root), signs_around(f, root.interval()).after)) {
      return std::move(root);
    }
  }
  return std::nullopt;
}

}  // namespace voroproof::internal
