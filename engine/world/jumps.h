// Disks that come into a diagram and go out of it, in no time.
#pragma once

#include <vector>

#include "engine/world/live_diagram.h"
#include "engine/world/world_sweep.h"

namespace voroproof::internal {

// The steps of a change, and what has become another by them.
struct JumpSteps {
  std::vector<Step> steps;
  std::vector<int> edges;
  std::vector<GenId> disks;
};

// Precondition: it is no swap.
Step step_of(const WorldChange& change);

// A disk that is there and visible shrinks, as all are at t, until another hides it, and is absent
// then. The diagram is right at t. Throws Undecided.
JumpSteps shrink_out(LiveDiagram& live, const MovingRows& rows, GenId g, const Rational& t);
// The disk g, which is there in `rows` and absent in the diagram, grows into it from a radius at
// which another hides it, as all are at t. The diagram without it is right at t. Throws Undecided.
JumpSteps grow_in(LiveDiagram& live, const MovingRows& rows, GenId g, const Rational& t);

}  // namespace voroproof::internal
