// Makes the motion of a scene.
#pragma once

#include "exact/motion_input.h"
#include "history/scene.h"

namespace voroproof::internal {

// What moves in the scene: the same exact values. Engine, certifier and queries all begin with it.
MotionInput motion_input(const Scene& scene);

}  // namespace voroproof::internal
