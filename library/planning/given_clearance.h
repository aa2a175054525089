// How near disks come to each other on given paths, exactly.
//
// On the common piece of two paths the relative motion is a polynomial (common_piece.h). Disks may
// overlap: the gap is negative then. In a periodic box all images count, a disk's own among them.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "history/paths_file.h"
#include "library/planning/common_piece.h"
#include "library/planning/image_search.h"
#include "library/planning/least_distance.h"

namespace voroproof::internal {

struct ClearanceRules {
  // The instants of waypoints alone count, not the ways between; a disk that is said to stay is
  // there at those of all others.
  bool at_waypoints = false;
  // Two that differ in height, the third coordinate, by at least that do not count as near, and a
  // gap is one of the other two coordinates.
  std::optional<Rational> height{};
};

// Pairs of legs are looked at that are there at one time: O(l log l + l m) for l legs of which at
// most m are there at one time. Boxes in doubles with outward rounding pass over nearly all, and
// where the least gap is asked for, bounds of their motions over nearly all others.
class GivenClearance {
 public:
  // The paths outlive this. `go_on` is asked now and then; where it says no, Interrupted is thrown.
  GivenClearance(const GivenPaths& given, std::function<bool()> go_on, ClearanceRules rules = {});

  std::int64_t legs() const { return static_cast<std::int64_t>(legs_.size()); }

  // The least gap of any two while both are there; of equal ones the first in time, then of the
  // smallest pair and image. Nothing where no two count as near at one time.
  std::optional<Approach> least() const;
  // All spells in which a gap is less than the distance >= 0, by pair, image and time.
  std::vector<NearSpell> spells_below(const Rational& distance) const;

 private:
  struct Leg {
    int path;
    std::size_t first, last;    // waypoints: the next one, or the same where it is of one instant
    double from, to;            // times, rounded outwards
    Vector3<double> low, high;  // bounds of the centre, outwards
    double radius;              // the greatest, rounded up
  };
  // A straight leg as it is from `t` on, with bounds of all errors.
  struct Motion {
    DoubleBall t;
    Ball3 at, velocity;
    bool is_straight;
  };
  void add_leg(int path, std::size_t first, std::size_t last);
  Motion motion_of(const Leg& leg) const;
  std::pair<const Waypoint&, const Waypoint&> ends(const Leg& leg) const;
  bool has_end(const Leg& leg) const;
  int disk(int path) const { return disks_[static_cast<std::size_t>(path)]; }
  const Curve* curve_of(const Leg& leg) const;
  Curve course(const Leg& leg, const Rational& from, const Rational& to) const;
  std::pair<Rational, Rational> common_time(const Leg& a, const Leg& b) const;
  Curve offset(const Leg& a, const Leg& b, const Rational& from, const Rational& to) const;
  template <class Visit>
  void each_pair(const std::optional<double>& near, Visit&& visit) const;
  template <class Visit>
  void each_image(const Leg& a, const Leg& b, const std::optional<double>& near,
                  Visit&& visit) const;
  std::vector<CommonPiece> own_images() const;
  double apart_above(const Leg& a, const Leg& b, const LatticeImage& image) const;
  std::optional<CommonPiece> common(const Leg& a, const Leg& b, const LatticeImage& image) const;
  double gap_above(const Leg& a, const Leg& b, const LatticeImage& image) const;
  double largest_gap_at_contacts() const;

  const GivenPaths& given_;
  std::vector<int> disks_;  // by path
  std::function<bool()> go_on_;
  ClearanceRules rules_;
  Vector3<double> sides_below_, sides_above_;  // the sides of the box, rounded
  ImageSearch images_;
  std::vector<Leg> legs_;        // by the time at which they begin
  std::vector<Motion> motions_;  // theirs
};

// Where the path is at a time from its first waypoint to its last.
Vec3 place_at(const GivenPath& path, const Rational& t);

// Its way from a waypoint to the next, between two of their times, by s from 0 to 1. What takes no
// time is gone at one pace.
Curve course_of(const GivenPath& path, std::size_t leg, const Rational& from, const Rational& to);
// Its radius, in the same way.
Polynomial<Rational> radius_of(const GivenPath& path, const Rational& from, const Rational& to);

}  // namespace voroproof::internal
