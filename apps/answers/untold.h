// Time and events of a scene that its history does not tell.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exact/billiard.h"

namespace voroproof::internal {

struct ClaimedManeuver {
  Rational t;
  std::optional<Vec3> v;  // none: the scheduled one
};

// A history that was read to its end.
struct ToldHistory {
  Rational end;               // up to which it tells
  bool stops = false;         // there, before its own horizon
  bool counts_match = false;  // its last line has the numbers of its events
  std::vector<std::vector<ClaimedManeuver>> maneuvers{};  // by disk
};

// In words: the time up to the scene's horizon, events that the last line counts otherwise, the
// scene's maneuvers up to the history's end that it lacks or has otherwise, but for rounding, and
// claims of maneuvers that the scene lacks. `scheduled`: by time.
std::vector<std::string> untold(const ToldHistory& told, const Rational& horizon,
                                const std::vector<BilliardManeuver>& scheduled);

}  // namespace voroproof::internal
