// Runs of an experiment as files: everything as JSON, a table as CSV.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "apps/paper/experiment.h"
#include "corpus/generate.h"

namespace voroproof::internal {

struct ExperimentMember {
  int k;
  ReferenceOptions options;  // options of the scene
  ExperimentRun run;
};

struct Experiment {
  std::string producer, set;
  double scale = 1;
  std::vector<nlohmann::ordered_json> members;  // member_json() of each
};

// All that is told of a run; `predictions`: they were counted. Runs that did not complete have
// none.
nlohmann::ordered_json member_json(const ExperimentMember& member, bool predictions);

std::string experiment_json(const Experiment& experiment);

// A line of names, then one a member. Times are left out: what remains depends on the options
// alone.
std::string experiment_csv(const Experiment& experiment);

// Reads what experiment_json() wrote. Throws InputError where the file is of something else.
Experiment read_experiment(const std::string& path);

}  // namespace voroproof::internal
