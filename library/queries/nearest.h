// Nearness: of disks to a point, of generators to each other. All order is exact.
#pragma once

#include <utility>
#include <vector>

#include "history/scene.h"
#include "library/queries/clearance.h"

namespace voroproof::internal {

// The gap between the boundaries of two generators.
Enclosure gap(const Clearance& clearance, GenId i, GenId j);

struct NearDisk {
  GenId disk;
  Enclosure distance;  // distance of the point from the disk's boundary, negative inside
  bool tied;           // at the very same distance as the one before
};

// The `count` nearest disks to a point, nearest first, equally near ones by their ids; all disks
// where there are fewer. O(n log n) comparisons.
std::vector<NearDisk> nearest_disks(const Motion& motion, const Rational& t, const Point2& point,
                                    std::size_t count, TierCounts& counts);

struct Neighbour {
  GenId generator;
  int edges;      // that the two cells share
  Enclosure gap;  // between the boundaries
};

// The generators whose cells share an edge with that of the disk, by their ids; of a lone disk the
// container.
std::vector<Neighbour> neighbours(Clearance& clearance, GenId disk);

struct ClosestPairs {
  std::vector<std::pair<GenId, GenId>> pairs;  // i < j, sorted: all that have the least gap
  Enclosure gap;                               // meaningless without a pair
};

// The closest pairs of generators, the container among them. They are neighbours: the circle over
// the gap of a closest pair is empty.
ClosestPairs closest_generators(Clearance& clearance);

// The closest pairs of disks. Where the container is nearer to their gap than they are, they need
// not be neighbours, so that disks close to the wall are compared besides.
ClosestPairs closest_disks(Clearance& clearance);

}  // namespace voroproof::internal
