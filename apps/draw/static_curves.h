// The edges of a diagram of disks at rest as curves for pictures.
#pragma once

#include <vector>

#include "library/edge_curves.h"
#include "voroproof/static_diagram.h"

namespace voroproof::internal {

// The parts of edges in the box, each a chain of cubics within about `tolerance` (> 0) of the true
// arc. Edges at infinity have none; in a frame the boundary of the only cell counts as an edge.
// Throws std::invalid_argument for a box without area.
std::vector<std::vector<Cubic>> curves_in_box(const StaticDiagram& diagram, const Box& box,
                                              double tolerance);

}  // namespace voroproof::internal
