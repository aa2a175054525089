// The Voronoi diagram of any disks at rest: they may overlap, lie in each other and coincide.
#pragma once

#include <vector>

#include "engine/static_diagram.h"
#include "exact/motion_input.h"

namespace voroproof::internal {

// A disk is hidden if another contains it, touching it from inside or not (of equal ones the one of
// larger id), or if it lies outside of the frame: just then it has no cell. (From a point x of its
// cell to its centre its distance falls at least as fast as any other, so the centre is in the
// cell, too; and that is so iff no other disk contains it. Disks together hide nobody.)
struct RestingDiagram {
  static constexpr GenId visible = -2;
  // By disk: `visible`, or a visible disk that hides it, or the container.
  std::vector<GenId> host;
  // The edges, by canonical names, sorted: those of a triangulation of the sphere by the visible
  // disks and the frame. None for fewer than two visible disks. Where more than three generators
  // touch one empty circle, the edges join the largest of them with all others, and so on
  // (docs/formats.md, section 3).
  std::vector<Quad> edges;
};

// The disks as they are at t = 0. The frame `circle` is the container.
// Throws Undecided where a predicate needs more than the budget.
RestingDiagram resting_diagram(const MotionInput& input, Frame frame, const MotionOptions& options,
                               TierCounts& counts);

}  // namespace voroproof::internal
