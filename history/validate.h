// Whether a file is of one of the project's formats.
#pragma once

#include <string>

namespace voroproof::internal {

// Whether the file looks like a history or an event sequence, and like a scene or a disk file: only
// its beginning is looked at. False where it cannot be read.
bool is_history_file(const std::string& path);
bool is_scene_file(const std::string& path);

// Finds out which of scene, world, history (of either), diagram, plan, disk file and event sequence
// (of which the header alone is looked at) the file claims to be, reads it completely and returns a
// short description: "history: 12 flips, ...". A history need not be complete in time: one that
// stopped early is valid, one without a last line is not; an end line with wrong counts is not
// either. Throws InputError.
std::string validate_file(const std::string& path);

}  // namespace voroproof::internal
