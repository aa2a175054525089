#include "apps/scene_motion.h"

namespace voroproof {

MotionInput motion_input(const Scene& scene) {
  MotionInput in;
  in.container_x = scene.cx;
  in.container_y = scene.cy;
  in.container_radius = scene.container_radius;
  in.restitution = scene.restitution;
  in.container_restitution = scene.container_restitution;
  in.whole_container_law = scene.law == ContainerLaw::whole;
  in.horizon = scene.horizon;
  in.disks.reserve(scene.disks.size());
  for (const DiskSpec& d : scene.disks) {
    in.disks.push_back({d.x, d.y, d.radius, d.vx, d.vy, d.mass});
  }
  return in;
}

std::vector<ManeuverInput> maneuver_input(const Scene& scene) {
  std::vector<ManeuverInput> out;
  out.reserve(scene.maneuvers.size());
  for (const Maneuver& m : scene.maneuvers) out.push_back({m.t, m.disk, m.vx, m.vy});
  return out;
}

}  // namespace voroproof
