// A new timetable for one vehicle among others that keep theirs.
//
// Its way is fixed, so that the question is one of time and progress: the other vehicles block
// parts of that plane, and a path through it that never goes back is sought on a grid, with the
// least sum of squares of deviations from the even speed (K. Kant, S. Zucker, "Toward efficient
// trajectory planning: the path-velocity decomposition", Int. J. Robotics Research 5, 1986).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "library/planning/conjunctions.h"

namespace voroproof::internal {

// The preference of a new timetable: an even speed, or going early or late.
enum class Haste { even, early, late };
inline constexpr std::array<Haste, 3> all_hastes{Haste::even, Haste::early, Haste::late};

// Keeps clear of all others but `ignored` (an id, or -1); nothing where the grid has no such path.
std::optional<Timetable> rescheduled(int vehicle, const std::vector<Timetable>& all,
                                     const Conjunctions& conjunctions, Haste haste = Haste::even,
                                     int ignored = -1);

}  // namespace voroproof::internal
