#include "library/maneuver_input.h"

namespace voroproof::internal {

std::vector<ManeuverInput> maneuver_input(const Scene& scene) {
  std::vector<ManeuverInput> out;
  out.reserve(scene.maneuvers.size());
  for (const Maneuver& m : scene.maneuvers) out.push_back({m.t, m.disk, m.vx, m.vy});
  return out;
}

}  // namespace voroproof::internal
