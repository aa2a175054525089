// Queries over a window of time, answered by the paths that a history records.
#pragma once

#include <string>

#include "apps/answers/query_answer.h"
#include "library/queries/history_cursor.h"
#include "library/queries/openings.h"
#include "library/queries/over_time.h"
#include "library/queries/paths.h"
#include "library/queries/void_lives.h"

namespace voroproof::internal {

// The common input of all queries over time. A query moves the cursor.
struct TimeQuery {
  const Scene& scene;
  HistoryCursor& history;
  const Paths& paths;
  const Window& window;
};

Answer answer_neighbours_over(const TimeQuery& query, GenId disk);
Answer answer_gap_over(const TimeQuery& query, GenId i, GenId j);
Answer answer_closest_over(const TimeQuery& query);
Answer answer_tunnel(const TimeQuery& query, GenId i, GenId j, const Rational& probe);
Answer answer_void(const TimeQuery& query, const Triple& vertex, const Rational& probe);
Answer answer_voids_over(const TimeQuery& query, const Rational& probe);

}  // namespace voroproof::internal
