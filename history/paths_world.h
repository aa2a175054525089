// A world whose disks move as given paths say.
#pragma once

#include "history/paths_file.h"
#include "history/world.h"

namespace voroproof::internal {

// The world in the plane in which the disks follow the paths exactly, each from its first waypoint
// to its last, and pass through each other. Time is counted from the first of all waypoints to the
// last. At each waypoint a disk has its own radius, and from there to the next it grows by `growth`
// >= 0 in a unit of time: what may have become of it since it was seen last. A disk that has one
// waypoint only is left out, and missing.
// Throws InputError where there are too many disks or waypoints; `file` is for messages.
World world_of_paths(const GivenPaths& given, const Rational& growth, const std::string& file);

}  // namespace voroproof::internal
