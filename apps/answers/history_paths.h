// The paths that a history records, as given paths whose clearance can be told.
#pragma once

#include <string>

#include "engine/engine.h"
#include "history/paths_file.h"
#include "history/scene.h"

namespace voroproof::internal {

// The paths of library/queries/paths.h, from 0 to where the history ends: a disk has a waypoint at
// each of its turns. Its contacts are theirs. A disk's name is its id. Missing are the time up to
// the scene's horizon, and the scene's maneuvers, where the history does not tell them. Throws
// InputError.
GivenPaths history_paths(const Scene& scene, const std::string& history_path,
                         const EngineOptions& options);

}  // namespace voroproof::internal
