// Swarms that are to fly from one configuration to another.
#pragma once

#include <string>
#include <vector>

#include "history/plan_file.h"

namespace voroproof::internal {

// Tasks after those of the paper, to be planned with library/planning/:
//
//   five               five vehicles, one of which crosses the ways of all others (Fig. 23)
//   square-to-circle   20 vehicles from the outline of a square to a circle (Figs. 24 to 26)
//   h-to-y             19 drones from one letter to the other (Fig. 1d)
//   drones58           58 drones from a square lattice to rings
//   random500          500 vehicles from random places to random places
//
// Vehicles have radius 1 and keep a clearance of 1/2. Throws std::invalid_argument for another
// name.
PlanTask plan_preset(const std::string& name);

// The names, in this order.
const std::vector<std::string>& plan_preset_names();

}  // namespace voroproof::internal
