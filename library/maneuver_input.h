// Makes of a scene file's contents what the engine takes.
#pragma once

#include "engine/engine.h"
#include "history/scene.h"
#include "history/scene_motion.h"

namespace voroproof::internal {

// The maneuvers; for what moves, see motion_input().
std::vector<ManeuverInput> maneuver_input(const Scene& scene);

}  // namespace voroproof::internal
