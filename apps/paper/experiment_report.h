// Runs of an experiment as files: everything as JSON, a table as CSV.
#pragma once

#include <string>
#include <vector>

#include "apps/paper/experiment.h"
#include "corpus/generate.h"

namespace voroproof::internal {

struct ExperimentMember {
  int k;
  ReferenceOptions options;  // of the scene
  ExperimentRun run;
};

struct Experiment {
  std::string producer, set;
  double scale = 1;
  bool predictions = true;
  std::vector<ExperimentMember> members;
};

std::string experiment_json(const Experiment& experiment);

// A line of names, then one a member. Times are left out: what remains depends on the options
// alone.
std::string experiment_csv(const Experiment& experiment);

}  // namespace voroproof::internal
