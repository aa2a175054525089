#include "history/scene_motion.h"

namespace voroproof::internal {

MotionInput motion_input(const Scene& scene) {
  MotionInput in;
  in.container_x = scene.cx;
  in.container_y = scene.cy;
  in.container_radius = scene.container_radius;
  in.restitution = scene.restitution;
  in.container_restitution = scene.container_restitution;
  in.whole_container_law = scene.law == ContainerLaw::whole;
  in.horizon = scene.horizon;
  in.disks = scene.disks;
  return in;
}

}  // namespace voroproof::internal
