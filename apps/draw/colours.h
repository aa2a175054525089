// The colours of disks in pictures.
#pragma once

#include <cstddef>

#include "library/palette.h"

namespace voroproof::internal {

// A disk's colour follows from its id alone: it is the same in every picture. The first ones are
// those of the palette, further ones lie between two of it that are next to each other in hue.
Colour disk_colour(std::size_t disk);

// The colour with `share` of it left in white, as that of a cell.
Colour pale(const Colour& colour, double share);

// The share of a disk's colour in its cell.
inline constexpr double cell_share = 0.32;

}  // namespace voroproof::internal
