// A disk that touches another from inside for an instant and is not hidden by it.
#pragma once

#include <optional>
#include <vector>

#include "engine/world/moving_rows.h"
#include "exact/topology/diagram.h"

namespace voroproof::internal {

// The cell of g has no area at the instant, at which g touches j from inside: it leads from the
// centre of g away from that of j to where the ray leaves the cell of j. If this is a vertex, the
// cell may lead into another edge afterwards. Returned are the half-edges by whose flips, one after
// the other, the diagram becomes that just after the instant; mostly none. Both are visible, before
// and after. Throws Undecided as cell_exit() does.
std::vector<Diagram::HalfEdge> flips_after_touch(const MovingRows& rows, const Diagram& diagram,
                                                 GenId g, GenId j, const WorldTime& t);

// The edge without length that is flipped next of a cell of more than two edges that lies between
// sides with j along such a ray: that of the smallest name. -1: the cell has two edges. nullopt: it
// has more, and none to be flipped.
std::optional<Diagram::HalfEdge> edge_without_length(const Diagram& diagram, GenId g, GenId j);

}  // namespace voroproof::internal
