// Generators of scenes: the paper's data, lattices and formation flights.
//
// A scene depends on its options alone, on every platform: random numbers come
// from std::mt19937_64 through a mapping of our own, cosines, sines and powers
// from MPFR with correct rounding, everything else from single binary64
// operations and rationals. Every number of a scene is a binary64 number, but
// for formation flights, where it may be any rational.
//
// All generators throw std::invalid_argument for options without meaning. Their
// lengths, times and speeds are in one consistent set of units of the caller's.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "history/scene.h"

namespace voroproof::internal {

// n disjoint disks of random radii at random places in a container centred at
// the origin, with random directions and one common speed: the REFERENCE data of
// the paper (section 7.1, from which the defaults are taken) and, with other
// options, its families of varied speed, size, density and restitution.
struct ReferenceOptions {
  enum class Radii {
    uniform,  // uniform over [rmin, rmax]
    log,      // their logarithm is uniform over [log rmin, log rmax]
    equal     // all rmax; rmin is ignored
  };
  int n = 1000;
  std::uint64_t seed = 1;
  Radii radii = Radii::uniform;
  double rmin = 1;  // > 0
  double rmax = 10;
  double density = 0.05;  // area of the disks / area of the container, in (0, 1)
  double speed = 1;
  double restitution = 1;
  double horizon = 1000;
};

// Disks are placed one after the other at uniformly random free places, the
// larger ones first, so that densities up to about 0.5 are reached; their ids do
// not show that order. No two disks touch, nor does a disk touch the container:
// the gap is at least 1e-9 of the sum of the two radii (of the container's
// radius). Throws std::runtime_error when a disk finds no free place.
Scene generate_reference(const ReferenceOptions& options);

// n equal disks on a square lattice, row by row from below, in as many columns as
// make it nearly square; the last row may be shorter. Many generators are
// cotangent, at an instant or always, which makes the family a test of ties.
// Coordinates are integer multiples of half the spacing.
struct GridOptions {
  enum class Motion {
    rest,    // no disk moves
    common,  // all velocities are (speed, 0)
    random,  // random directions, one common speed
    shear    // horizontal; a linear function of the row, zero at mid-height, at
             // most `speed`; exact while the significand of speed is short
  };
  int n = 100;
  std::uint64_t seed = 1;  // matters to random motion only
  Motion motion = Motion::random;
  double spacing = 4;  // >= 2 radius
  double radius = 1;   // > 0
  double speed = 1;
  double horizon = 100;
};
Scene generate_grid(const GridOptions& options);

// n equal disks fly in straight lines from a square lattice to a circle, where
// all arrive at half the horizon and stop (maneuvers to velocity zero), as in the
// paper's application (section 8, Fig. 24). Disks are assigned to the places on
// the circle by their direction from the centre; the seed turns the circle. Nobody
// evades: disks may collide on the way, and then stop elsewhere.
struct SwarmOptions {
  int n = 20;
  std::uint64_t seed = 1;
  double spacing = 4;  // in the lattice, and at least on the circle; > 2 radius
  double radius = 1;   // > 0
  double horizon = 100;
};
Scene generate_swarm(const SwarmOptions& options);

// n equal disks fly from one formation to others, all in straight lines, all starting and arriving
// at the same instants (maneuvers), and none colliding. A flight is a list of names: first a
// formation (corpus/formations.h), then formations and moves of the whole swarm:
//
//   east, north, west, south  by four spacings
//   turn                      about its centre, each straight to its place turned by atan(4/3)
//   shear                     x += 3 y / 4 about its centre
//   spread                    to 3/2 of the distances
//   rest                      nobody moves
//
// Each takes one and the same part of the horizon, and the last part finds all at rest. Between
// formations every disk goes to the place where no exchange of two makes the sum of the squares of
// all ways shorter. Every value is exact, a binary64 or not: disks arrive where their formation is.
//
// Throws std::invalid_argument besides where disks would collide. From formation to formation and
// in moves other than `shear` they never do while spacing > 2 sqrt(2) radius.
struct FormationOptions {
  int n = 20;  // at most max_formation_disks
  std::vector<std::string> flight = {"frame", "circle"};
  double spacing = 5;  // > 2 radius
  double radius = 1;   // > 0
  double horizon = 32;
};
inline constexpr int max_formation_disks = 5000;
Scene generate_formation(const FormationOptions& options);

// Flights after those of the paper (section 8 and Fig. 1), each step 16 units of time:
//
//   figure24    20 vehicles from the outline of a square to a circle (Fig. 24)
//   h-to-y      19 drones from one letter to the other (Fig. 1d)
//   segments58  58 drones, eight steps
//   drones1218  square lattice, turned and sheared, to a staggered one
//   drones2018  square lattice, flown, sheared through another square lattice, to rings
//
// Throws std::invalid_argument for another name.
FormationOptions formation_preset(const std::string& name);

}  // namespace voroproof::internal
