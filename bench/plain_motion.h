// The peer in plain doubles: the same searches and the same laws, with no error bound and no proof.
#pragma once

#include <vector>

#include "filtered/computed/computed_motion.h"
#include "filtered/search/collapse.h"
#include "filtered/search/contact.h"

namespace voroproof::internal::bench {

// Moves and searches by doubles(g) of a Motion, which tells nothing else of the disks once they
// have collided here.
class PlainMotion {
 public:
  explicit PlainMotion(Motion& motion);

  // The first collapse of q after `start`, up to `end` at most.
  Collapse collapse(const Quad& q, double start, double end) const;
  // The next contact of i < j at or after `now`, not after `end`.
  NextContact contact(GenId i, GenId j, double now, double end) const;

  // i < j touch at t and get their velocities after it.
  Impact collide(GenId i, GenId j, double t);
  RoundedState maneuver(GenId g, double t, double vx, double vy);

 private:
  Motion& motion_;
  double restitution_, container_restitution_;
  // The number of the last change of motion of each generator g, at g + 1: a pair that has just
  // collided is at distance 0 and does not collide again.
  std::vector<int> last_change_;
  int changes_ = 0;
};

}  // namespace voroproof::internal::bench
