// The V-edges of a world: when they collapse.
#pragma once

#include <optional>

#include "engine/world/moving_rows.h"
#include "filtered/worlds/edge_ends.h"

namespace voroproof::internal {

class MovingEdge {
 public:
  // All four generators are there or the frame. `rows` outlives it.
  MovingEdge(const MovingRows& rows, const Quad& q);

  // A polynomial that has a root wherever the edge may collapse: f, but C where f is - C^2, as of
  // equal radii that grow alike, or zero. It is zero where there is nothing to look for.
  const TimePolynomial& polynomial() const { return is_square_ ? ends_.c : f_; }
  // Whether the edge is one that must not be there just after the instant, and a point at it: then
  // it collapses at the instant, or has been wrong before. Where its four generators touch one
  // circle from then on the rule of the largest id tells. Where one of the four touches another
  // from inside at the instant, it is taken for a point unless it certainly has a length. `after`:
  // the sign of the polynomial just after the instant, if it is known.
  bool collapses_at(const WorldTime& t, Sign after = Sign::unknown) const;
  // Whether one of its ends is not there just after the instant, a point or not.
  bool is_illegal_after(const WorldTime& t) const;
  // Whether the edge has no length at the instant itself, right or wrong; or it is not known, as
  // where two of three generators at one of its ends touch the third there.
  bool may_be_point_at(const WorldTime& t) const;

 private:
  enum class Which { conflict_at_start, conflict_at_end, same_circle };
  template <class T>
  static RootExpression<T> expression(const EdgeEnds<T>& ends, Which which);
  Sign sign_then(Which which, const WorldTime& t) const;
  bool has_inner_touch(const WorldTime& t, const Ball& about) const;
  Sign sign_of(Which which, Sign f, const WorldTime& t,
               const std::optional<EdgeEnds<Ball>>& near) const;

  const MovingRows& rows_;
  Quad quad_;  // a disk on its left
  EdgeEnds<TimePolynomial> ends_;
  TimePolynomial f_;
  bool is_square_;
};

}  // namespace voroproof::internal
