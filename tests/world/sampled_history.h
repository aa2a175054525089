// The history of a world by looking: brute-force diagrams at many times, and what differs between
// two of them.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "history/world.h"
#include "history/world_history.h"
#include "tests/world/world_oracle.h"

namespace voroproof::internal::testing {

// A change of one diagram into another: a flip, hide, appear or swap. None if it is none of these,
// but several. Only the differences of the two are looked at.
using Change = std::variant<Quad, Hide, Appear, Swap>;
std::optional<Change> single_change(const BruteDiagram& a, const BruteDiagram& b);

struct SampledHistory {
  std::vector<Quad> initial;
  std::vector<WorldEvent> events;  // times are rounded as those of the engine
  std::string why_not;             // not empty: at some time there was more than one change
};
// In each part without a turn or a jump so many diagrams are compared, and more where they differ:
// two changes between two of them that undo each other are not seen. For worlds in which no two
// things happen at a time.
SampledHistory sampled_history(const World& world, int samples);

}  // namespace voroproof::internal::testing
