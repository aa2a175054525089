// The two circles of a V-edge side by side, in doubles with error bounds.
#pragma once

#include "exact/generators.h"
#include "filtered/motion/motion_lanes.h"

namespace voroproof::internal {

// The edge q = [l,r,s,e] over a time that may be an interval: the signs of circle_exists() and
// incircle() for its circles (l,s,r) and (r,e,l), with e and s as the fourth site.
class EdgeCircles {
 public:
  EdgeCircles(const Motion& motion, const Quad& q, const DoubleBall& t);

  Sign start_exists() const { return exists(0); }
  Sign end_exists() const { return exists(1); }
  // `f`: the sign of the cotangency of the four.
  Sign end_in_start(Sign f) const { return in_circle(0, f); }
  Sign start_in_end(Sign f) const { return in_circle(1, f); }

 private:
  Sign exists(int circle) const;
  Sign in_circle(int circle, Sign f) const;

  bool with_container_[2];      // whether the circle touches the container
  bool other_is_container_[2];  // whether the fourth site is
  // The terms of the signs (exact/predicates.h), the start in lane 0 and the end in lane 1.
  BallLanes g_, c_, along_, across_, difference_;
};

}  // namespace voroproof::internal
