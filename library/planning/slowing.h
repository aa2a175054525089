// A vehicle slows down before a predicted conjunction, takes up its speed again after it, and makes
// up for the delay on the rest of its way (paper section 8, Fig. 23).
#pragma once

#include <vector>

#include "library/planning/plan.h"

namespace voroproof::internal {

// Nobody flies faster than this many times its even speed.
inline constexpr int max_speed_up = 4;

// How fast the fastest piece is, in even speeds.
double top_speed(const Timetable& timetable);

// The timetable with its speed multiplied by slow / 4 from one step to another; the rest of the
// way is stretched over the rest of the time. An empty timetable where nothing is left to stretch
// or that would need more than max_speed_up.
Timetable slowed(const Timetable& timetable, int from, int until, int slow);

// The ways to slow down around a conjunction that are tried, the gentle ones first.
std::vector<Timetable> slowings(const Timetable& timetable, double conjunction);

}  // namespace voroproof::internal
