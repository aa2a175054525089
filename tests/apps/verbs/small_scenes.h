// Scenes as text, for tests of the verbs.
#pragma once

#include <string>

namespace voroproof::internal {

inline std::string scene_text(const std::string& disks, const std::string& more = "") {
  return R"({"format": "voroproof-scene", "version": 1,
 "container": {"center": [0, 0], "radius": 10},
 "horizon": 5,)" +
         more + R"(
 "disks": [
)" + disks +
         "]}\n";
}

inline const std::string two_disks =
    R"({"center": [-3, 0], "radius": 1, "velocity": [1, 0]},
{"center": [3, 1], "radius": 2, "velocity": [-1, 0]})";

}  // namespace voroproof::internal
