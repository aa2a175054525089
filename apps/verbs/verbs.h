// The verbs of the command line: each one's file is named as it is.
#pragma once

#include "apps/cli/verb.h"

namespace voroproof::internal {

// Each adds a verb to the program.
void add_generate(Verb& program);
void add_simulate(Verb& program);
void add_query(Verb& program);
void add_queries_over_time(Verb& query);  // below the verb query
void add_snapshot(Verb& program);
void add_diagram(Verb& program);
void add_render(Verb& program);
void add_movie(Verb& program);
void add_page(Verb& program);
void add_validate(Verb& program);
void add_certify(Verb& program);
void add_index(Verb& program);
void add_clearance(Verb& program);
void add_explain(Verb& program);
void add_convert(Verb& program);
void add_corpus(Verb& program);
void add_plan(Verb& program);
void add_minimize(Verb& program);
void add_truth(Verb& program);

}  // namespace voroproof::internal
