// Scenes made by rule: the same on every platform for the same options.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "voroproof/export.h"
#include "voroproof/scene.h"

namespace voroproof {

// All throw std::invalid_argument for options without meaning.

// n disjoint disks of random radii at random places in a container around the origin, with random
// directions and one speed: the paper's data (section 7.1) by default. Throws Error where a disk
// finds no free place: densities up to about 0.5 are reached.
struct ReferenceOptions {
  enum class Radii { uniform, log, equal };  // equal: all rmax
  int n = 1000;
  std::uint64_t seed = 1;
  Radii radii = Radii::uniform;
  double rmin = 1, rmax = 10;
  double density = 0.05;  // area of the disks / area of the container
  double speed = 1;
  double restitution = 1;
  double horizon = 1000;
};
VOROPROOF_API Scene reference_scene(const ReferenceOptions& options);

// n equal disks on a square lattice: many generators are cotangent, at an instant or always.
struct GridOptions {
  enum class Motion { rest, common, random, shear };
  int n = 100;
  std::uint64_t seed = 1;  // matters to random motion only
  Motion motion = Motion::random;
  double spacing = 4, radius = 1, speed = 1, horizon = 100;
};
VOROPROOF_API Scene grid_scene(const GridOptions& options);

// n equal disks fly from a square lattice to a circle and stop there at half the horizon (the
// paper's section 8). Nobody evades.
struct SwarmOptions {
  int n = 20;
  std::uint64_t seed = 1;
  double spacing = 4, radius = 1, horizon = 100;
};
VOROPROOF_API Scene swarm_scene(const SwarmOptions& options);

}  // namespace voroproof
