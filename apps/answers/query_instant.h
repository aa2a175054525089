// Queries about one instant, answered by the true motion.
#pragma once

#include <cstddef>
#include <string>

#include "apps/answers/query_answer.h"
#include "library/true_moment.h"

namespace voroproof::internal {

// The common input of all queries at an instant. The moment must be that of the scene at t, and
// outlive the call. The queries throw Undecided where a decision needs more than the budget.
struct InstantQuery {
  const Scene& scene;
  const Rational& t;
  TrueMoment& moment;
};

Answer answer_nearest(const InstantQuery& query, const Point2& point, std::size_t count);
Answer answer_neighbours(const InstantQuery& query, GenId disk);
Answer answer_closest(const InstantQuery& query);
Answer answer_offset(const InstantQuery& query, const Rational& probe);
Answer answer_voids(const InstantQuery& query, const Rational& probe);
Answer answer_critical(const InstantQuery& query);

}  // namespace voroproof::internal
