// The neighbours of a double, as std::nextafter without a call.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

namespace voroproof::internal {

// The least double above x; infinity of itself.
inline double next_above(double x) {
  if (x == std::numeric_limits<double>::infinity()) return x;
  if (x == 0) return std::numeric_limits<double>::denorm_min();
  return std::bit_cast<double>(std::bit_cast<std::int64_t>(x) + (x > 0 ? 1 : -1));
}
inline double next_below(double x) { return -next_above(-x); }

}  // namespace voroproof::internal
