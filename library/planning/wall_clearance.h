// How near disks come to the container on given paths, exactly.
//
// On a leg the distance of a disk's centre from the container's is convex in time: it is greatest,
// and the gap to the container least, at a waypoint.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "exact/enclosure.h"
#include "history/paths_file.h"
#include "library/planning/clearance.h"

namespace voroproof::internal {

// The nearest that a disk comes to the container: gap = room - sqrt(distance2).
struct WallApproach {
  int disk;
  Rational t;          // the first such time
  Rational distance2;  // squared, of the centre from the container's
  Rational room;       // the container's radius less the disk's
};

// A longest interval in which the gap of a disk to the container is less than some distance.
struct WallSpell {
  Enclosure from, to;
  WallApproach nearest;
};

// The gap to about 2^-80 of the distance, rounded outwards.
Enclosure gap(const WallApproach& approach);
// Whether the gap is what is asked for: at least `clearance`, and, where that is 0 and touching is
// too near, positive.
bool keeps_clear(const WallApproach& approach, const Rational& clearance, Touching touching);

class WallClearance {
 public:
  // As GivenClearance; the container of the paths is there. O(1) for each waypoint.
  WallClearance(const GivenPaths& given, std::function<bool()> go_on);

  // The least gap; of equal ones the first in time, then of the smallest disk. Nothing without
  // disks.
  std::optional<WallApproach> least() const;
  // All spells in which a gap is less than the distance >= 0, by disk and time.
  std::vector<WallSpell> spells_below(const Rational& distance) const;

 private:
  struct Leg;
  WallApproach at(int disk, const Waypoint& waypoint) const;
  std::vector<WallSpell> parts(const Leg& leg, const Rational& distance) const;

  const GivenPaths& given_;
  std::function<bool()> go_on_;
};

}  // namespace voroproof::internal
