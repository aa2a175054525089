// Where a disk that leaves its host comes into the diagram.
#pragma once

#include "engine/world/live_diagram.h"
#include "engine/world/moving_rows.h"

namespace voroproof::internal {

// The half-edge of the cell of j through which the ray from the centre of j through that of g
// leaves it just after the instant; for the frame the one through which it comes into the cell. j
// is visible and has edges, g has left it from inside.
Diagram::HalfEdge cell_exit(const MovingRows& rows, const Diagram& diagram, GenId j, GenId g,
                            const WorldTime& t);

}  // namespace voroproof::internal
