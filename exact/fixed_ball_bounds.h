// Radii of fixed-point balls: constants and scaling, for fixed_ball*.cpp alone.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace voroproof::internal::fixed_ball_bounds {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
// Some ten roundings of a radius, each of 2^-53, are paid for by this factor.
inline constexpr double up = 1 + 0x1p-48;
// A radius that is not zero is not less, so that its products with what `upper` returns do not
// underflow.
inline constexpr double least_radius = 0x1p-800;

// 2^e, for -1000 <= e <= 1000.
inline double power_of_two(std::int64_t e) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + e) << 52);
}

// x 2^e.
inline double scaled(double x, std::int64_t e) {
  if (std::abs(e) <= 1000) return x * power_of_two(e);
  return std::ldexp(x, static_cast<int>(std::clamp<std::int64_t>(e, -4000, 4000)));
}

}  // namespace voroproof::internal::fixed_ball_bounds
