// The in-circle predicate at one instant, asked of edges of a diagram.
#pragma once

#include <cstddef>
#include <vector>

#include "exact/generators.h"
#include "exact/predicates.h"
#include "filtered/motion/motion.h"

namespace voroproof::internal::bench {

// Whether e lies outside the circle of (l, s, r), at time t. The first of the three
// that is a disk serves as the base.
struct IncircleTask {
  Quad quad;
  double t;
};

// The predicate in any number type: `site(g)` gives a generator at the instant.
template <class SiteOf>
Sign incircle_at(const Quad& q, SiteOf&& site) {
  const auto base = q.l == container_id ? q.s : q.l;
  const auto j = q.l == container_id ? q.r : q.s;
  const auto k = q.l == container_id ? q.l : q.r;
  const auto at_base = site(base), at_j = site(j), at_k = site(k), at_e = site(q.e);
  const Sign f = sign(cotangency(at_base, at_j, at_k, at_e));
  const bool container = j == container_id || k == container_id;
  return incircle(TangentTriple(at_base, at_j, at_k, container), at_e, q.e == container_id, f);
}

// Does the tasks in CGAL's intervals, from the initial motion of a scene of binary64 numbers.
// Returns how many tasks they leave undecided; `seconds` is the time taken.
long incircles_in_intervals(const Motion& motion, const std::vector<IncircleTask>& tasks,
                            double& seconds);

}  // namespace voroproof::internal::bench
