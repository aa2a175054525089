// Histories of worlds: version 2 of the history format (docs/formats.md, section 20).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "exact/generators.h"
#include "exact/rational.h"
#include "exact/world_events.h"
#include "history/world.h"

namespace voroproof::internal {

// Why a history cannot have it as a part; null where it can.
const char* fault_of(const Hide& hide);
const char* fault_of(const Appear& appear);
const char* fault_of(const Jump& jump, const Rational& t);

// Lines are counted, not the steps of jumps.
struct WorldCounts {
  std::int64_t flips = 0, hides = 0, appears = 0, swaps = 0, jumps = 0, collisions = 0,
               maneuvers = 0;
  void add(const WorldEvent& event);
  std::int64_t all() const;
  bool operator==(const WorldCounts&) const = default;
};

struct WorldHistoryHeader {
  std::string scene_sha256;
  Rational horizon;
  std::string producer;
  std::vector<Quad> initial;  // the diagram at 0+: canonical, sorted
};

// The last line: that of a history of all of [0, horizon], or of one that is right up to t only.
struct WorldEnd {
  WorldCounts counts;  // as claimed
};
struct WorldStop {
  Rational t;
  std::string reason;
};

}  // namespace voroproof::internal
