// Scenes for tests of the library.
#pragma once

#include <cstdint>
#include <optional>

#include "voroproof/voroproof.h"

namespace voroproof::internal::testing {

inline Disk disk(Number x, Number y, Number radius, Number vx, Number vy) {
  return {x, y, radius, vx, vy, std::nullopt};
}

inline Scene two_disks() {
  Scene scene;
  scene.container_radius = 10;
  scene.horizon = 8;
  scene.disks = {disk(-3, 0, 1, 1, 0), disk(3, 0, 1, -1, 0)};
  return scene;
}

inline Scene reference(int n, double horizon, std::uint64_t seed = 1) {
  ReferenceOptions options;
  options.n = n;
  options.horizon = horizon;
  options.seed = seed;
  return reference_scene(options);
}

}  // namespace voroproof::internal::testing
