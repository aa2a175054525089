// Makes the motion of a scene.
#pragma once

#include "exact/motion_input.h"
#include "history/scene.h"

namespace voroproof::internal {

// The motion of the scene, with the same exact values. Engine, certifier and queries begin with it.
MotionInput motion_input(const Scene& scene);

}  // namespace voroproof::internal
