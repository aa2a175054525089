// The closest two disks over a window of time.
#pragma once

#include <optional>

#include "library/queries/over_time.h"

namespace voroproof::internal {

// The least gap of any two disks: of equal ones the first in time, then of the smallest pair.
// Nothing with fewer than two disks. All pairs are looked at, as GivenClearance does. The diagram
// is followed to the end of the window (and the cursor stays there) for one reason: a history with
// flips that do not fit is refused, as by the other questions that follow it. Throws InputError.
std::optional<LeastGap> least_gap_of_all(const Paths& paths, HistoryCursor& history,
                                         const Window& window);

}  // namespace voroproof::internal
