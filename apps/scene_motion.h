// From a scene file's contents to what the engine takes.
#pragma once

#include "filtered/motion.h"
#include "history/scene.h"
#include "kinetic/engine.h"

namespace voroproof {

MotionInput motion_input(const Scene& scene);
std::vector<ManeuverInput> maneuver_input(const Scene& scene);

}  // namespace voroproof
