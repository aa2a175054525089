// Families of random worlds. All numbers are whole, dyadic or of small denominators.
#pragma once

#include <array>
#include <random>

#include "history/world.h"

namespace voroproof::internal::testing {

enum class WorldFamily {
  overlapping,      // disks of all sizes that overlap
  growing,          // rates of both signs
  equal_radii,      // one radius and one rate for all
  points,           // most radii are 0
  nested,           // small disks in and about large ones
  lattice,          // places and velocities on a lattice: ties
  lifetimes,        // disks that come and go
  jumping,          // and that jump and turn
  simultaneous,     // jumps and lives on a lattice, at times of other events
  crossing_circle,  // disks cross the circle and leave it wholly
  growing_circle,   // the circle grows or shrinks, too, and disks outgrow it
};
inline constexpr std::array world_families{
    WorldFamily::overlapping,     WorldFamily::growing,       WorldFamily::equal_radii,
    WorldFamily::points,          WorldFamily::nested,        WorldFamily::lattice,
    WorldFamily::lifetimes,       WorldFamily::jumping,       WorldFamily::simultaneous,
    WorldFamily::crossing_circle, WorldFamily::growing_circle};
const char* name_of(WorldFamily family);  // one word

// 0 to 12 disks, in the plane or in a circle. In some worlds units of length and time are powers of
// two far from 1.
World random_world(WorldFamily family, std::mt19937_64& random);

}  // namespace voroproof::internal::testing
