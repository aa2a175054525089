// A scene whose disks move as given paths say.
#pragma once

#include "history/paths_file.h"

namespace voroproof::internal {

// The scene in which disk k follows the k-th path exactly: velocities are the quotients of the
// waypoints, and change by maneuvers. Time is counted from the first waypoints. The container is so
// large that no disk touches it; a point has mass 1. No disk collides if no two of the paths touch,
// which is not looked at here.
// Throws InputError where the paths do not all begin at one time and end at one time, which a scene
// cannot say, or where there are too many; `file` is for messages.
Scene scene_of_paths(const GivenPaths& given, const std::string& file);

}  // namespace voroproof::internal
