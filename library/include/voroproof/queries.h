// Questions about one instant of a scene, answered by its true motion. All order is exact.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "voroproof/export.h"
#include "voroproof/free_space.h"
#include "voroproof/number.h"
#include "voroproof/scene.h"

namespace voroproof {

struct NearDisk {
  int disk = 0;
  Enclosure distance;  // distance of the point from the disk's boundary, negative inside
  bool tied = false;   // at the very same distance as the one before
};

struct Neighbour {
  int generator = 0;
  int edges = 0;  // that the two cells share
  Enclosure gap;  // between the boundaries
};

struct ClosestPairs {
  std::vector<std::pair<int, int>> pairs;  // i < j, sorted: all that have the least gap
  Enclosure gap;                           // without meaning where there is no pair
};

// The scene just after all events at t, computed once and asked often.
class VOROPROOF_API Instant {
 public:
  // t >= 0. Throws InputError, and Undecided where the engine stops before t.
  Instant(const Scene& scene, const Number& t, int max_bits = 32768);
  Instant(Instant&&) noexcept;
  Instant& operator=(Instant&&) noexcept;
  ~Instant();

  // All may throw Undecided, and std::invalid_argument for a disk that there is not and for the
  // radius of a probe that is negative.

  // The `count` nearest disks to a point, nearest first, equally near ones by their ids.
  std::vector<NearDisk> nearest(const Number& x, const Number& y, std::size_t count);
  // The generators whose cells share an edge with that of the disk, by their ids.
  std::vector<Neighbour> neighbours(int disk);
  ClosestPairs closest_generators();  // the container among them
  ClosestPairs closest_disks();

  // The boundary of the places for a probe's centre: arcs by generator, the container's first,
  // along a generator's circle from one edge to the next.
  std::vector<OffsetArc> offset(const Number& probe);
  // The voids of a probe in the order of their smallest vertices; those without a vertex last.
  std::vector<Void> voids(const Number& probe);
  CriticalRadii critical();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace voroproof
