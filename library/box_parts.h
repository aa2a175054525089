// The parts of an arc inside and outside of a box.
#pragma once

#include <vector>

#include "library/conic_arc.h"
#include "library/diagram_geometry.h"
#include "voroproof/static_diagram.h"

namespace voroproof::internal {

// Throws std::invalid_argument for a box without area, or beyond 1e100 in magnitude.
void require_area(const Box& box);

// A box relative to an origin. Its sides are left, right, bottom and top.
struct BallBox {
  static constexpr int sides = 4;

  BallBox(const Box& box, const Vec2& origin);
  // How far a point is beyond a side.
  DoubleBall beyond(int side, const BallPoint& p) const;
  // The nearest point of the box.
  BallPoint nearest(const BallPoint& p) const;
  // How far a way leads along a side, counterclockwise around the box.
  static DoubleBall along(int side, const BallPoint& from, const BallPoint& to);

  BallPoint low, high;
  double size;  // at least its diagonal
};

// The part of an arc from t = `from` to `to`. Where it is unclear it is within `excess` of the box,
// or comes so near to the side `side`, if that is not `several`, and keeps from the others.
struct BoxPart {
  enum class Kind { inside, outside, unclear };
  static constexpr int several = -1;

  double from, to;
  Kind kind;
  int side = several;  // an outside part is beyond this one, or on it
  double excess = 0;
};

// All parts in their order. Those that are not clear are short, or so near to a side of the box
// that rounding hides on which side of it they are. Infinite excess where the arc is not known to
// be proper.
std::vector<BoxPart> box_parts(const ConicArc& arc, const BallBox& box);

}  // namespace voroproof::internal
