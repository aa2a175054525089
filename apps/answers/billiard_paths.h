// The paths that a history of a billiard records, as given paths whose clearance can be told.
#pragma once

#include <string>

#include "exact/billiard.h"
#include "history/paths_file.h"

namespace voroproof::internal {

// Every disk from 0 to where the history ends, on the path that docs/claim.md, section 9, calls
// recorded: its places follow from the scene and the claimed times and velocities. Contacts are the
// claimed collisions of two that touch then, but for what roundings explain. What is missing is as
// for history_paths.h. Throws InputError, also where images move.
GivenPaths billiard_paths(const Billiard& billiard, const std::string& scene_path,
                          const std::string& history_path);

}  // namespace voroproof::internal
