// Collision-free plans: everybody flies straight to its goal and arrives at the same time;
// predicted conjunctions are avoided by changes of speed (the paper's section 8).
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "voroproof/export.h"
#include "voroproof/number.h"
#include "voroproof/scene.h"

namespace voroproof {

struct Vehicle {
  Number radius;  // >= 0
  Number start_x, start_y, goal_x, goal_y;
};

// The task of a plan: all leave at 0 and arrive together. vehicles[k] has the id k.
struct PlanTask {
  Number container_x, container_y;
  Number container_radius = 1;
  Number arrive = 1;  // > 0
  Number clearance;   // >= 0: between the boundaries of two vehicles
  std::vector<Vehicle> vehicles;
  std::string name;
};

// Two vehicles and the least gap of their boundaries, proved by exact arithmetic.
struct Approach {
  int i = 0, j = 0;
  Number t;
  Enclosure gap;
};

struct Plan {
  bool found = false;  // everybody keeps the clearance: proved
  Scene scene;         // the plan so far as a scene: every change of speed is a maneuver
  std::optional<Approach> nearest;  // the least gap of the plan; none with fewer than two
  // Where none was found: the pair that cannot or does not keep the clearance.
  std::optional<Approach> conflict;
  std::size_t avoided = 0;  // conjunctions that were predicted
};

// Deterministic. The monitor is called with the number of conjunctions left; false stops with what
// there is. Throws InputError where the task is none: vehicles outside the container, say.
VOROPROOF_API Plan make_plan(const PlanTask& task,
                             const std::function<bool(std::size_t conjunctions)>& monitor = {});

}  // namespace voroproof
