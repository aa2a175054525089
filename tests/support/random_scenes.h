// Families of random scenes.
#pragma once

#include <random>

#include "history/scene.h"

namespace voroproof::internal::testing {

using Random = std::mt19937_64;

// Uniform over [low, high).
double uniform(Random& random, double low, double high);

// Disks at random places in a container of radius 100 around a random centre, the larger ones
// first; logarithms of radii uniform over [rmin, rmax] (points where rmax is 0, with mass 1),
// speeds uniform over [0, 2 speed].
struct RandomScene {
  int n = 10;
  double rmin = 2, rmax = 8;
  double speed = 3;
  double horizon = 50;
  double density = 0;  // of area; where positive, radii are scaled to reach it
  int maneuvers = 0;
};
Scene random_scene(const RandomScene& options, Random& random);

}  // namespace voroproof::internal::testing
