// Billiards: disks, or balls in space, that bounce off each other and off their frame.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "exact/vector3.h"

namespace voroproof::internal {

// The half-space normal.x >= offset + speed t.
struct BilliardWall {
  Vec3 normal;  // its length is 1
  Rational offset, speed;
  Rational restitution = 1;  // in (0,1]
};

// A circle or a sphere around all disks.
struct RoundFrame {
  Vec3 center;
  Rational radius;           // > 0
  Rational restitution = 1;  // in (0,1]
};

// Which image of a disk, in sides of the box.
using LatticeImage = std::array<int, 3>;

// Images of a disk are at its centre + (k_0 L_0 + k_1 shear L_1 t, k_1 L_1, k_2 L_2).
struct PeriodicBox {
  Vec3 sides;      // zero where an axis is not periodic
  Rational shear;  // zero unless the first two axes are periodic
  bool is_periodic() const { return sides[0] != 0 || sides[1] != 0 || sides[2] != 0; }
};

struct BilliardDisk {
  Vec3 center, velocity;  // at time 0
  Rational radius;        // at time 0; >= 0
  Rational growth;        // by how much the radius grows in a unit of time
  Rational mass;          // > 0, but for a point that is alone
  bool fixed = false;     // at rest whatever happens, as if of infinite mass
};

struct BilliardManeuver {
  Rational t;
  int disk;
  Vec3 velocity;
};

struct Billiard {
  int dimension = 2;  // 2 or 3
  std::optional<RoundFrame> round;
  std::vector<BilliardWall> walls;  // none where there is a round frame
  PeriodicBox lattice;              // periodic only where there is no round frame
  Rational restitution = 1;         // between disks, in [0,1]
  Vec3 gravity;                     // acceleration of all disks that are not fixed
  Rational horizon;                 // >= 0
  std::vector<BilliardDisk> disks;
  std::vector<BilliardManeuver> maneuvers;  // sorted by t; one of a disk at one time
  std::string sha256;                       // hash of the bytes that were read

  // The most negative id of a wall: -1 where the frame is round, 0 where nothing is.
  int last_wall() const { return round ? -1 : -static_cast<int>(walls.size()); }
};

}  // namespace voroproof::internal
