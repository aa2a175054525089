// Directions in the plane, up to positive factors, and arcs of them.
#pragma once

#include <array>
#include <optional>

#include "exact/rational.h"

namespace voroproof::internal {

template <class T>
using Direction = std::array<T, 2>;

template <class T>
Sign cross(const Direction<T>& a, const Direction<T>& b) {
  return sign(T(a[0] * b[1] - a[1] * b[0]));
}
template <class T>
Sign dot(const Direction<T>& a, const Direction<T>& b) {
  return sign(T(a[0] * b[0] + a[1] * b[1]));
}

// Whether direction x lies on the counterclockwise arc from a to b, a included iff
// `closed_at_a`, b never. Equal a and b make an empty arc.
template <class T>
std::optional<bool> on_arc(const Direction<T>& a, const Direction<T>& b, const Direction<T>& x,
                           bool closed_at_a) {
  const auto positive = [](Sign s) -> std::optional<bool> {
    if (s == Sign::unknown) return std::nullopt;
    return s == Sign::positive;
  };
  const auto starts = [&](Sign ax) -> std::optional<bool> {  // x ahead of a, less than pi
    if (ax == Sign::unknown) return std::nullopt;
    return ax == Sign::positive || (ax == Sign::zero && closed_at_a);
  };
  switch (cross(a, b)) {
    case Sign::unknown:
      return std::nullopt;
    case Sign::positive: {  // the arc is shorter than pi
      const Sign ax = cross(a, x), xb = cross(x, b);
      if (ax == Sign::negative || xb == Sign::negative || xb == Sign::zero) return false;
      if (xb == Sign::unknown) return std::nullopt;
      return starts(ax);
    }
    case Sign::negative: {  // longer: its complement, from b to a, is shorter
      const Sign bx = cross(b, x), xa = cross(x, a);
      if (bx == Sign::negative || xa == Sign::negative) return true;
      if (bx == Sign::unknown || xa == Sign::unknown) return std::nullopt;
      if (xa == Sign::zero) return closed_at_a;  // x = a, as x = -a has bx < 0
      return false;
    }
    case Sign::zero: {
      const Sign ab = dot(a, b);
      if (ab == Sign::unknown) return std::nullopt;
      if (ab == Sign::positive) return false;
      const Sign ax = cross(a, x);
      if (ax != Sign::zero) return positive(ax);
      return closed_at_a ? positive(dot(a, x)) : std::optional<bool>(false);
    }
  }
  return std::nullopt;
}

}  // namespace voroproof::internal
