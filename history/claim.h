// A scene and a history that claims to be its own, in whichever formats.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "history/history_source.h"
#include "history/scene.h"

namespace voroproof::internal {

struct Claim {
  Scene scene;
  std::unique_ptr<HistorySource> history;
  // Remarks on what was taken from elsewhere than the scene file, and on what neither file tells.
  std::vector<std::string> remarks;
};

// Opens both files. The scene may be a scene or a disk file; a disk file takes its horizon, its
// restitution and its maneuvers from the header and the events of the event sequence it comes with.
// Throws InputError where a file is not of its format, or the history names another scene.
Claim open_claim(const std::string& scene_path, const std::string& history_path);

}  // namespace voroproof::internal
