// The places on the sides of a box where the clearance of a diagram of disks at rest may be the
// greatest in the box around.
#pragma once

#include <vector>

#include "library/static_slopes.h"

namespace voroproof::internal {

struct BorderPlace {
  EmptyCircle circle;
  // Whether in no direction into the box or along its sides the clearance rises, as far as doubles
  // tell.
  bool is_greatest;
};

// The corners, and on the sides the vertices, the points where edges cross them, and those nearest
// to the frame's centre. Of places within 2^-40 of a side's length there is one. The radius is the
// clearance of the place, rounded to nearest; the place is where double-double arithmetic puts it.
std::vector<BorderPlace> border_places(const StaticDiagram& diagram,
                                       const std::vector<ClearanceEdge>& edges, const Box& box);

}  // namespace voroproof::internal
