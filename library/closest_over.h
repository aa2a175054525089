// The closest two disks over a window of time.
#pragma once

#include <optional>

#include "library/queries/over_time.h"

namespace voroproof::internal {

// The least gap of any two disks: of equal ones the first in time, then of the smallest pair.
// Nothing with fewer than two disks. No diagram is used: all pairs are looked at as GivenClearance
// does.
std::optional<LeastGap> least_gap_of_all(const Paths& paths, const Window& window);

}  // namespace voroproof::internal
