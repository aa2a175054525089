// Collision-free plans (paper section 8): everybody flies straight to its goal and arrives at the
// same instant; predicted conjunctions are avoided by changes of speed.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "library/planning/clearance.h"
#include "library/planning/plan.h"

namespace voroproof::internal {

// A conjunction that was predicted and how it was avoided.
struct Avoidance {
  Approach predicted;  // with the speeds before the change
  Point2 place;        // then, midway between the centres of the two
  int vehicle;         // whose speed changed
  bool slowed;         // by slowing down before; otherwise by a new timetable
};

struct PlanResult {
  Plan plan;
  std::vector<Avoidance> avoided;
  std::optional<Approach> nearest;  // the smallest gap of the plan; none with fewer than two
  // Two vehicles that are too near at the start or at their goals: there is no plan at all.
  std::optional<Approach> impossible;
  // The first pair that still comes too near where no plan was found; another planner may find one.
  std::optional<Approach> unsolved;

  bool found() const { return !impossible && !unsolved; }
};

// Takes the conjunctions in the order of time. For each, one of the two slows down where that
// leaves it with fewer conjunctions, else gets a timetable without any; the number of conjunctions
// falls with every change, so that there is an end. Deterministic. `monitor`, if given, is called
// with the number of conjunctions left; false stops with what there is, as unsolved.
PlanResult make_plan(PlanTask task, const std::function<bool(std::size_t)>& monitor = {});

}  // namespace voroproof::internal
