// How near disks come to each other on given paths, exactly.
//
// On the common piece of two paths the relative motion is linear, so that what clearance.h says of
// plans holds. Disks may overlap: the gap is negative then.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <vector>

#include "history/paths_file.h"
#include "library/planning/clearance.h"
#include "library/planning/least_distance.h"

namespace voroproof::internal {

// A longest interval in which the gap of a pair is less than some distance. Each end is enclosed;
// it is where the distance is reached, or where one of the two comes or goes.
struct NearSpell {
  Enclosure from, to;
  Approach nearest;  // the least gap in it, and when first
};

// Pairs of legs are looked at that are there at one time: O(l log l + l m) for l legs of which at
// most m are there at one time. Boxes in doubles with outward rounding pass over nearly all, and
// where the least gap is asked for, bounds of their motions over nearly all others.
class GivenClearance {
 public:
  // The paths outlive this. At a contact the gap of its two is zero. `go_on` is asked now and then;
  // where it says no, Interrupted is thrown.
  GivenClearance(const std::vector<GivenPath>& paths, std::function<bool()> go_on,
                 std::set<GivenContact> contacts = {});

  std::int64_t legs() const { return static_cast<std::int64_t>(legs_.size()); }

  // The least gap of any two while both are there; of equal ones the first in time, then of the
  // smallest pair. Nothing where no two are there at one time.
  std::optional<Approach> least() const;
  // All spells in which a gap is less than the distance >= 0, by pair and time.
  std::vector<NearSpell> spells_below(const Rational& distance) const;

 private:
  struct Leg {
    int path;
    std::size_t first;              // waypoint; it ends at the next, or here where there is none
    double from, to;                // times, rounded outwards
    double x_lo, x_hi, y_lo, y_hi;  // bounds of the centre, outwards
  };
  // A leg as it is from `t` on, with bounds of all errors.
  struct Motion {
    DoubleBall t;
    Ball2 at, velocity;
    DoubleBall radius;
  };
  struct Common;
  std::pair<const Waypoint&, const Waypoint&> ends(const Leg& leg) const;
  template <class Visit>
  void each_pair(Visit&& visit) const;
  std::optional<Common> common(const Leg& a, const Leg& b) const;
  double gap_above(const Leg& a, const Leg& b) const;
  double largest_gap_at_contacts() const;

  const std::vector<GivenPath>& paths_;
  std::function<bool()> go_on_;
  std::set<GivenContact> contacts_;
  std::vector<Leg> legs_;        // by the time at which they begin
  std::vector<Motion> motions_;  // theirs
};

// Where the path is at a time from its first waypoint to its last.
Point2 place_at(const GivenPath& path, const Rational& t);

}  // namespace voroproof::internal
