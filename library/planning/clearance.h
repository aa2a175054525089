// How near vehicles come to each other, exactly.
//
// Between two knots the relative motion of two vehicles is linear, the square of their distance a
// quadratic in time, and its minimum rational. The gap is the root of that less the two radii.
#pragma once

#include <compare>
#include <optional>
#include <utility>

#include "exact/billiard.h"
#include "exact/enclosure.h"
#include "library/planning/plan.h"

namespace voroproof::internal {

// The nearest that two vehicles, or disks, come: gap = sqrt(distance2) - reach. Or a disk j and the
// container or a wall, i < 0: gap = reach - sqrt(distance2).
struct Approach {
  int i, j;            // i < j; equal for a disk and an image of itself
  Rational t;          // the first such time
  Rational distance2;  // squared, between the centres; zero at a wall
  Rational reach;      // the sum of the radii, their difference, or the gap to a wall
  // By how much the true time and square may be greater: zero but for curves, where both are
  // algebraic numbers.
  Rational t_width{}, distance2_width{};
  LatticeImage image{};  // the one of j, in a periodic box
  // Not at an instant at which they just do not count as near, so that gaps only come as near to
  // this one as one likes.
  bool is_reached = true;

  bool is_exact() const { return t_width == 0 && distance2_width == 0; }
};

Approach nearest_approach(const Plan& plan, int i, int j);

// The nearest approach by timetables that are not, or not yet, those of a plan.
Approach nearest_approach(const PlanTask& task, int i, const Timetable& of_i, int j,
                          const Timetable& of_j);

// The smallest gap of the plan; of equal ones the first in time, then by pair. None where there are
// fewer than two vehicles. Doubles with error bounds pass over the pairs that cannot be it, the
// others are compared exactly.
std::optional<Approach> minimum_gap(const Plan& plan);

// Whether a gap of exactly 0 is one that is kept where 0 is asked for.
enum class Touching { is_too_near, is_allowed };

// Whether the gap is proved to be what is asked for: at least `clearance`, and, where that is 0 and
// touching is too near, positive. A negative clearance is an overlap that is allowed.
bool keeps_clear(const Approach& approach, const Rational& clearance,
                 Touching touching = Touching::is_too_near);
// Whether it is proved not to be that. The one or the other holds of an exact approach.
bool falls_short(const Approach& approach, const Rational& clearance, Touching touching);

// Compares two exact approaches by their gaps, both of disks or both to walls.
std::strong_ordering compare_gaps(const Approach& a, const Approach& b);

// The one with the smaller gap of two of one kind; of equal ones the first in time, then by disks
// and image. Gaps that differ by less than about 2^-80 of the distance may count as equal where one
// is not exact; what comes back encloses both of them then.
Approach nearer_of(const Approach& a, const Approach& b);

// The nearest to the origin on the segment from a to b: the first point of it that is as near, as a
// part of the way from a to b, and the square of its distance.
std::pair<Rational, Rational> nearest_to_origin(const Point2& a, const Point2& b);

// Bounds of the root of `square` >= 0, about 2^-80 of it apart, or equal where it is rational.
std::pair<Rational, Rational> root_bounds(const Rational& square);
// The gap to about 2^-80 of the distance, rounded outwards.
Enclosure gap(const Approach& approach);

// Calls piece(from, to) for the common pieces of two timetables, in order of time.
template <class Piece>
void for_each_piece(const Timetable& a, const Timetable& b, Piece&& piece) {
  int from = 0;
  for (std::size_t p = 1, q = 1; from < time_steps;) {
    const int to = a[p].step < b[q].step ? a[p].step : b[q].step;
    piece(from, to);
    p += a[p].step == to;
    q += b[q].step == to;
    from = to;
  }
}

}  // namespace voroproof::internal
