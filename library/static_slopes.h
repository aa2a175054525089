// The edges of a diagram of disks at rest that are not at infinity, each with its ends, and how the
// clearance changes along them.
#pragma once

#include <vector>

#include "exact/generators.h"
#include "exact/rational.h"
#include "voroproof/static_diagram.h"

namespace voroproof::internal {

// It runs counterclockwise around `disk`. The edge around a lone disk in a frame has no ends, and
// ends at infinity are none.
struct ClearanceEdge {
  GenId disk, other;
  static constexpr int none = -1;
  int start = none, end = none;  // indices into the vertices
};
std::vector<ClearanceEdge> clearance_edges(const StaticDiagram& diagram);

// Centre and signed radius: that of the frame is negative.
Circle generator_of(const StaticDiagram& diagram, GenId g);

// The slopes of the clearance along edges, exactly. Seen from the centre of its disk, in the polar
// angle from the direction d of the other centre, the clearance on an edge beside another disk is
// least at 0, the gate, and rises on both sides; beside the frame it is greatest at 0, the far
// point, least at the gate, which is opposite, and the same everywhere where both centres are one.
class StaticSlopes {
 public:
  explicit StaticSlopes(const StaticDiagram& diagram) : diagram_(diagram) {}

  // Whether the clearance rises on the way into the edge from its end.
  bool rises_from_start(const ClearanceEdge& edge) const { return rises(edge, false); }
  bool rises_from_end(const ClearanceEdge& edge) const { return rises(edge, true); }
  // The same clearance at all of the edge.
  bool is_level(const ClearanceEdge& edge) const;
  // Whether the far point is on the edge, not at its ends.
  bool has_far_point(const ClearanceEdge& edge) const;
  // That point and its clearance, rounded from sums of two doubles.
  EmptyCircle far_point(const ClearanceEdge& edge) const;

 private:
  bool rises(const ClearanceEdge& edge, bool at_end) const;
  Sign side(const ClearanceEdge& edge, bool at_end, bool turned) const;

  const StaticDiagram& diagram_;
};

}  // namespace voroproof::internal
