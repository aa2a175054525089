// Which vehicle flies to which goal.
#pragma once

#include <vector>

#include "history/plan_file.h"

namespace voroproof::internal {

// Exchanges the goals among vehicles of equal radius so that the sum of the squares of all ways is
// least: then no two vehicles that fly evenly come nearer than 1/sqrt 2 of the lesser of their
// distances at both ends (M. Turpin, N. Michael, V. Kumar, "CAPT: Concurrent assignment and
// planning of trajectories for multiple robots", Int. J. Robotics Research 33, 2014). The squares
// are rounded to 2^-40 of the largest, so that the sum may exceed the least one by 2^-40 of that
// for each vehicle. Returns for each vehicle whose goal it takes.
std::vector<int> nearest_goals(const std::vector<Vehicle>& vehicles);

// The task with the goals exchanged so.
void assign_nearest_goals(PlanTask& task);

}  // namespace voroproof::internal
