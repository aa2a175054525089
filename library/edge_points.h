// The edges and cells of a diagram file as chains of points.
#pragma once

#include <vector>

#include "exact/predicates.h"
#include "history/diagram_file.h"

namespace voroproof::internal {

using Points = std::vector<Vec2>;

// The edge q, whose vertices are `start` and `end`, as points on its true arc, the chords between
// which keep within about `tolerance` (> 0) of it. Seen from the generators on both sides the
// points follow each other in angle, as those of the edge do: so the polygon of a cell is simple,
// however few they are.
Points edge_points(const DiagramFile& diagram, const Quad& q, const Vec2& start, const Vec2& end,
                   double tolerance);
// The same for an edge beside a wall, of which `row` is that seen from the disk about `center`.
Points wall_points(const Quad& q, const Vec2& center, const GeneratorRow<double>& row,
                   const Vec2& start, const Vec2& end, double tolerance);

// The boundary of the cell of the only disk, an ellipse about its centre and the container's,
// counterclockwise and closed (the first point is not repeated). Precondition: there is one disk.
Points only_cell(const DiagramFile& diagram, double tolerance);

// The boundaries of the cells of the disks, and last of the container, from the points of all
// edges: closed, with the cell on the left; empty for a generator without edges. Throws
// std::invalid_argument where the edges around one do not close.
std::vector<Points> cells_between(const DiagramFile& diagram, const std::vector<Points>& edges);

}  // namespace voroproof::internal
