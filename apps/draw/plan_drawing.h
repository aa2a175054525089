// The content of a plan's drawing, from a plan as it was made or from a report of one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "history/events.h"
#include "library/planning/planner.h"

namespace voroproof::internal {

// The content of a plan's drawing, in doubles, for the eye.
struct PlanDrawing {
  struct Knot {
    double t;
    Vec2 at;
  };
  struct DrawnVehicle {
    double radius;
    std::vector<Knot> way;  // from the start at 0 to the goal, linear in between
  };
  struct Pair {
    int i, j;
    double t;
  };
  Vec2 container_center{};
  double container_radius = 0;
  std::vector<DrawnVehicle> vehicles;  // by id
  std::vector<Vec2> conjunctions;      // that were predicted and are avoided
  std::optional<Pair> nearest;         // the least gap of the plan

  // Where the vehicle is at t.
  Vec2 place(int i, double t) const;
};

PlanDrawing drawing_of(const PlanResult& result);

// Reads the drawing from a report of `voroproof plan`. Throws InputError where the file is none.
PlanDrawing read_plan_report(const std::string& path);

}  // namespace voroproof::internal
