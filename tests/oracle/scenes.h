// Disks in one container, thrown at random, for the oracles' own tests.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <vector>

#include "tests/oracle/brute_force.h"
#include "tests/oracle/circle.h"

namespace voroproof::oracle {

using Disks = std::vector<ExactCircle>;
using Random = std::mt19937_64;

inline const ExactCircle kContainer{0, 0, 250};

inline std::vector<Circle> rounded(const Disks& disks) {
  std::vector<Circle> result;
  for (const ExactCircle& d : disks) result.push_back(oracle::rounded(d));
  return result;
}

inline double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

// Decided exactly; a point must not even touch.
inline bool fits(const Disks& disks, const ExactCircle& d) {
  const auto far_enough = [](const mpq_class& squared, const mpq_class& reach, bool strictly) {
    const mpq_class least = reach * reach;
    return strictly ? squared > least : squared >= least;
  };
  const mpq_class room = kContainer.radius - d.radius;
  if (room <= 0) return false;
  const mpq_class from_centre = d.x * d.x + d.y * d.y, room2 = room * room;
  if (d.radius == 0 ? from_centre >= room2 : from_centre > room2) return false;
  return std::all_of(disks.begin(), disks.end(), [&](const ExactCircle& e) {
    const mpq_class dx = d.x - e.x, dy = d.y - e.y;
    return far_enough(dx * dx + dy * dy, d.radius + e.radius, d.radius == 0 || e.radius == 0);
  });
}

inline ExactCircle somewhere(Random& random, double radius) {
  const double distance = 250 * std::sqrt(uniform(random, 0, 1));
  const double angle = uniform(random, 0, 6.283185307179586);
  return {distance * std::cos(angle), distance * std::sin(angle), radius};
}

// n disks whose radii `radius` draws, thrown until they fit.
inline Disks thrown(Random& random, int n, const std::function<double()>& radius) {
  Disks disks;
  while (disks.size() < static_cast<std::size_t>(n)) {
    const ExactCircle d = somewhere(random, radius());
    if (fits(disks, d)) disks.push_back(d);
  }
  return disks;
}

inline std::vector<Quadruple> edges_of(const BruteDiagram& diagram) {
  return {diagram.edges.begin(), diagram.edges.end()};
}

}  // namespace voroproof::oracle
