// How near disks come to the container, or to walls, on given paths, exactly.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "history/paths_file.h"
#include "library/planning/common_piece.h"

namespace voroproof::internal {

class WallClearance {
 public:
  // As GivenClearance. O(1) for each waypoint and wall.
  WallClearance(const GivenPaths& given, std::function<bool()> go_on);

  // The least gap; of equal ones the first in time, then of the smallest wall and disk. Nothing
  // without disks or walls.
  std::optional<Approach> least() const;
  // All spells in which a gap is less than the distance >= 0, by wall, disk and time.
  std::vector<NearSpell> spells_below(const Rational& distance) const;

 private:
  template <class Visit>
  void each_piece(Visit&& visit) const;

  const GivenPaths& given_;
  std::function<bool()> go_on_;
};

}  // namespace voroproof::internal
