// Whether the disks of a scene lie where they may at t = 0.
#pragma once

#include <optional>
#include <string>

#include "history/scene.h"

namespace voroproof::internal {

struct PlacementFault {
  int disk;  // the one to blame; of two that overlap, the one with the larger id
  std::string reason;
};

// The first fault found, or none. Exact. A disk must lie inside the container (it may touch it from
// inside, but not with a velocity that is tangential and not zero) and be smaller than it; the
// interiors of two disks must not meet, and two points (radius 0) must not coincide.
std::optional<PlacementFault> find_placement_fault(const Scene& scene);

}  // namespace voroproof::internal
