// The colours that all pictures of diagrams share.
#pragma once

#include <array>

namespace voroproof::internal {

// Components in [0, 1].
struct Colour {
  double red, green, blue;
};

// The colours of disks and, paler, of their cells.
inline constexpr std::array<Colour, 8> palette{{{0.36, 0.58, 0.82},
                                                {0.93, 0.60, 0.32},
                                                {0.44, 0.70, 0.47},
                                                {0.85, 0.45, 0.47},
                                                {0.60, 0.51, 0.77},
                                                {0.87, 0.76, 0.33},
                                                {0.35, 0.70, 0.71},
                                                {0.84, 0.55, 0.74}}};

inline constexpr Colour ink{0.20, 0.23, 0.30};        // edges, rims
inline constexpr Colour arrow_ink{0.55, 0.10, 0.16};  // velocities
inline constexpr Colour white{1, 1, 1};

}  // namespace voroproof::internal
