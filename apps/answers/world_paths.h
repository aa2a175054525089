// The paths of the disks of a world, as given paths whose clearance can be told.
#pragma once

#include "history/paths_file.h"
#include "history/world.h"

namespace voroproof::internal {

// Every disk from when it enters to when it leaves, or to the horizon. A path ends where the disk
// jumps or grows at another rate, and the disk goes on with the next one.
GivenPaths world_paths(const World& world);

}  // namespace voroproof::internal
