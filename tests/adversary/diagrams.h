// Whether the diagram that a history claims is that of given paths, at instants between claims.
#pragma once

#include <vector>

#include "tests/adversary/paths.h"
#include "tests/adversary/truth.h"

namespace voroproof::internal::adversary {

// Replays the claimed flips. `turns`: the times of turns on the paths, between which there are
// looks. Looks up to `end` farther than the tolerance from all claimed flips, at the hints, too,
// but not where a generator is inside another, and at each claimed flip: its edge must change from
// legal to illegal within the tolerance.
Opinion judge_diagrams(const Motion& motion, const History& history, double end,
                       const std::vector<double>& turns, const std::vector<double>& hints);

}  // namespace voroproof::internal::adversary
