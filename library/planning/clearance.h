// How near vehicles come to each other, exactly.
//
// Between two knots the relative motion of two vehicles is linear, the square of their distance a
// quadratic in time, and its minimum rational. The gap is the root of that less the two radii.
#pragma once

#include <compare>
#include <optional>
#include <utility>

#include "exact/enclosure.h"
#include "library/planning/plan.h"

namespace voroproof::internal {

// The nearest that two vehicles come: gap = sqrt(distance2) - reach.
struct Approach {
  int i, j;            // i < j
  Rational t;          // the first such time
  Rational distance2;  // squared, between the centres
  Rational reach;      // the sum of the radii
};

Approach nearest_approach(const Plan& plan, int i, int j);

// The nearest approach by timetables that are not, or not yet, those of a plan.
Approach nearest_approach(const PlanTask& task, int i, const Timetable& of_i, int j,
                          const Timetable& of_j);

// The smallest gap of the plan; of equal ones the first in time, then by pair. None where there are
// fewer than two vehicles. Doubles with error bounds pass over the pairs that cannot be it, the
// others are compared exactly.
std::optional<Approach> minimum_gap(const Plan& plan);

// Whether the gap is what `clearance` >= 0 asks for: at least that, and positive.
bool keeps_clear(const Approach& approach, const Rational& clearance);

// Compares the approaches by their gaps.
std::strong_ordering compare_gaps(const Approach& a, const Approach& b);

// The nearest to the origin on the segment from a to b: the first point of it that is as near, as a
// part of the way from a to b, and the square of its distance.
std::pair<Rational, Rational> nearest_to_origin(const Point2& a, const Point2& b);

// The root of `square` >= 0 less `less`, to about 2^-80 of the root, rounded outwards.
Enclosure root_less(const Rational& square, const Rational& less);

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
