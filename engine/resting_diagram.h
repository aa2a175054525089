// The Voronoi diagram of any disks at rest: they may overlap, lie in each other and coincide.
#pragma once

#include <vector>

#include "engine/static_diagram.h"
#include "exact/motion_input.h"

namespace voroproof::internal {

struct RestingDiagram {
  // hosts_of() the disks.
  std::vector<GenId> host;
  // The edges, by canonical names, sorted: those of a triangulation of the sphere by the visible
  // disks and the frame. None for fewer than two visible disks. Where more than three generators
  // touch one empty circle, the edges join the largest of them with all others, and so on
  // (docs/formats.md, section 3).
  std::vector<Quad> edges;
};

// The disks as they are at t = 0. The frame `circle` is the container.
// Throws Undecided where a predicate needs more than the budget.
RestingDiagram resting_diagram(MotionInput input, Frame frame, const MotionOptions& options,
                               TierCounts& counts);

}  // namespace voroproof::internal
