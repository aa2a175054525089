// The polygons that the edges of a diagram bound, as chains of points.
#pragma once

#include <vector>

#include "exact/generators.h"
#include "history/events.h"
#include "voroproof/static_diagram.h"

namespace voroproof::internal {

// The boundaries of the cells of so many disks, and last of the container, from those of the edges,
// each from its start to its end: closed, with the cell on the left; empty for a generator without
// edges. Throws std::invalid_argument where the edges around one do not close.
std::vector<std::vector<Vec2>> polygons(std::size_t disks, const std::vector<Quad>& edges,
                                        const std::vector<std::vector<Vec2>>& sides);

// The cell of a disk that is alone in a circle.
std::vector<Vec2> only_cell(const Circle& disk, const Circle& frame, double tolerance);

}  // namespace voroproof::internal
