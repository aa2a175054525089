// The part of a history that a world tells itself: who comes, goes, turns and jumps, and when.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "history/world.h"
#include "history/world_history.h"

namespace voroproof::internal::testing {

// The fault of the turns and jumps: one is missing, or is too many, or says other values than
// those of the world. With `until`, those from it on are not looked at.
std::optional<std::string> unscheduled(const World& world, const std::vector<WorldEvent>& events,
                                       const std::optional<Rational>& until);

}  // namespace voroproof::internal::testing
