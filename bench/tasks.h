// What the hot predicates are asked in the benchmarks: always the same questions, of a data set.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "bench/data_sets.h"
#include "bench/incircle_task.h"
#include "filtered/search/collapse.h"

namespace voroproof::internal::bench {

// The first collapse of an edge in the window (0, end], for which its four generators do not touch.
struct FlipTask {
  Quad quad;
  double end;
};

// One for each edge, up to the horizon or the first contact of its generators.
std::vector<FlipTask> flip_tasks(const DataSet& set, double horizon);

// Asks `after(quad, start, end)` until the window is decided: an answer may be for a part of it.
template <class After>
Collapse through_window(const FlipTask& task, After&& after) {
  Collapse c = after(task.quad, 0.0, task.end);
  while (c.kind == Collapse::Kind::none && c.lo < task.end) c = after(task.quad, c.lo, task.end);
  return c;
}

Collapse certified_collapse(CollapseSearch& search, const FlipTask& task);

// One in-circle question for each edge, at a random instant of (0, 1): of 53 bits, as the times
// that a run asks for.
std::vector<IncircleTask> incircle_tasks(const DataSet& set);

// The pairs of generators that share an edge.
std::vector<std::pair<GenId, GenId>> neighbours(const DataSet& set);

struct Hit {
  double t;
  GenId i, j;
};

// The collisions of a scene up to a time, in their order.
std::vector<Hit> hits_of(Scene scene, double horizon);

}  // namespace voroproof::internal::bench
