// Small scenes on a lattice of integers: a shrinkable description, and its meaning as a scene.
//
// Small integers make all that is rare elsewhere ordinary: simultaneous collisions, grazing,
// touching starts, cotangent generators at an instant or for ever, flips at the instant of a
// collision, times exactly on a binary64.
#pragma once

#include <rapidcheck.h>

#include <ostream>
#include <vector>

#include "history/scene.h"

namespace voroproof::internal::testing {

struct LatticeDisk {
  int x, y, radius, vx, vy;
};

struct LatticeManeuver {
  int t, disk, vx, vy;  // the disk modulo the number of disks
};

struct LatticeScene {
  std::vector<LatticeDisk> disks;
  std::vector<LatticeManeuver> maneuvers;
  int restitution_halves = 2;  // 0, 1 or 2 halves
  int wall_quarters = 4;       // 1 to 4 quarters
  bool whole_law = false;
};

// The scene has a container of radius 12 around the origin and goes up to time 6. Disks that do not
// fit among those before them, or would slide along the wall, are left out, and so is the second of
// two maneuvers of a disk at one time: every description has a meaning, and what is left of it
// after shrinking too.
Scene scene_of(const LatticeScene& lattice);

void showValue(const LatticeScene& lattice, std::ostream& out);

// `elastic`: only coefficients 1. `points`: radii may be 0.
struct LatticeFamily {
  int max_radius = 3;
  int min_radius = 1;
  int max_speed = 2;
  bool maneuvers = false;
  bool elastic = true;
};
rc::Gen<LatticeScene> lattice_scenes(const LatticeFamily& family);

}  // namespace voroproof::internal::testing
