// The moving disks and their laws: all of a scene that the motion depends on, but the maneuvers.
#pragma once

#include <array>
#include <vector>

#include "exact/compact_rational.h"
#include "exact/rational.h"

namespace voroproof::internal {

// A disk at t = 0.
struct DiskInput {
  CompactRational x, y;    // centre
  CompactRational radius;  // >= 0
  CompactRational vx, vy;  // velocity
  CompactRational mass;    // > 0, but 0 for a lone disk of radius 0 that was given none
};

struct MotionInput {
  Rational container_x, container_y, container_radius;
  std::array<Rational, 2> origin;      // where in the scene the origin of these coordinates is
  Rational restitution = 1;            // between disks, in [0, 1]
  Rational container_restitution = 1;  // in (0, 1]
  bool whole_container_law = false;    // scale the whole reflected velocity
  Rational horizon;                    // guides the choice of precision only
  std::vector<DiskInput> disks;
};

// The same in coordinates about the container's centre: how far that is from the origin of a scene
// costs no bit of a distance then.
MotionInput about_center(MotionInput input);

}  // namespace voroproof::internal
