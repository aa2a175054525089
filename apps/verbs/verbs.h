// The verbs of the command line: each one's file is named as it is.
#pragma once

#include <CLI/CLI.hpp>

#include "apps/cli/command_line.h"

namespace voroproof::internal {

// Each adds a verb; parsing it sets `action`.
void add_generate(CLI::App& app, Action& action);
void add_simulate(CLI::App& app, Action& action);
void add_query(CLI::App& app, Action& action);
void add_queries_over_time(CLI::App& query, Action& action);  // below the verb query
void add_snapshot(CLI::App& app, Action& action);
void add_render(CLI::App& app, Action& action);
void add_movie(CLI::App& app, Action& action);
void add_validate(CLI::App& app, Action& action);
void add_certify(CLI::App& app, Action& action);
void add_explain(CLI::App& app, Action& action);
void add_convert(CLI::App& app, Action& action);
void add_corpus(CLI::App& app, Action& action);
void add_plan(CLI::App& app, Action& action);
void add_check72(CLI::App& app, Action& action);
void add_experiment(CLI::App& app, Action& action);

}  // namespace voroproof::internal
