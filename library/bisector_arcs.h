// The bisector of two generators as arcs of conics.
#pragma once

#include <vector>

#include "library/conic_arc.h"
#include "library/diagram_geometry.h"
#include "voroproof/static_diagram.h"

namespace voroproof::internal {

// An end of an edge: a vertex, rounded to nearest, or a place beyond all that matters where the
// edge is cut, which is about on it.
struct ArcEnd {
  Vec2 at{};
  bool is_cut = false;
};

// Arcs that follow each other, relative to `origin`.
struct ArcChain {
  Vec2 origin{};
  std::vector<ConicArc> arcs{};
  // False where rounding hides whether an edge beside the frame leads nowhere or all around its
  // disk: then its ends are taken for one place.
  bool is_certain = true;
};

// The edge between two disks of the plane, neither of which contains the other, from `start` to
// `end` with `left` on its left. An edge without end is left at least `far` from the centres of
// both, and leads straight to its cut from there.
ArcChain plane_arcs(const Circle& left, const Circle& right, const ArcEnd& start, const ArcEnd& end,
                    double far);

// The edge between a disk and the frame, counterclockwise around the disk, of which no arc takes
// more than a quarter turn.
ArcChain frame_arcs(const Circle& disk, const Circle& frame, const Vec2& start, const Vec2& end);

// The line of a wall: a place on it, and its normal of length 1, inwards.
struct WallLine {
  Vec2 at{}, inwards{};
};

// The edge between a disk and a wall, counterclockwise around the disk, likewise.
ArcChain wall_arcs(const Circle& disk, const WallLine& wall, const Vec2& start, const Vec2& end);

// The straight edge between walls. Both ends are on it, rounded to nearest.
ArcChain straight_arc(const Vec2& start, const Vec2& end);

// The boundary of the cell of the only disk in a frame.
ArcChain frame_ellipse(const Circle& disk, const Circle& frame);

}  // namespace voroproof::internal
