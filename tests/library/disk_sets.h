// Disks at random, and areas of polygons.
#pragma once

#include <random>
#include <vector>

#include "voroproof/static_diagram.h"

namespace voroproof {

// n disks with centers in the square from 0 to 10 and radii up to `largest`.
inline std::vector<Circle> random_disks(unsigned seed, int n, double largest) {
  std::mt19937 random(seed);
  const auto part = [&] { return static_cast<double>(random() % 1000003) / 1000003; };
  std::vector<Circle> disks;
  for (int k = 0; k < n; ++k) {
    const double x = part(), y = part(), r = part();
    disks.push_back({{10 * x, 10 * y}, largest * r});
  }
  return disks;
}

// Positive for a polygon that runs counterclockwise.
inline double area(const std::vector<Vector>& polygon) {
  double twice = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return twice / 2;
}

}  // namespace voroproof
