// The verb simulate, for billiards.
#pragma once

#include "apps/verbs/simulate_world.h"

namespace voroproof::internal {

// Writes the history of a scene of version 2 whose disks bounce; `filters` of the request does not
// count.
ExitCode simulate_billiard(const WorldRequest& request, int max_bits);

}  // namespace voroproof::internal
