// From a scene file's contents to what the engine takes.
#pragma once

#include "history/scene.h"
#include "kinetic/engine.h"
#include "queries/replayed_motion.h"

namespace voroproof {

// Besides motion_input().
std::vector<ManeuverInput> maneuver_input(const Scene& scene);

}  // namespace voroproof
