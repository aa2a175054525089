// The cost of a run, as JSON.
#pragma once

#include <string>

#include "engine/engine.h"
#include "history/history_reader.h"

namespace voroproof::internal {

// The run that the statistics are about.
struct RunDescription {
  std::string producer;
  std::string scene_sha256;
  int disks = 0;
  Rational horizon;
  int start_bits = 0, max_bits = 0, threads = 1;
  bool filters = true;
  double total_seconds = 0;  // time of the run, with the initial diagram and all output
};

// The events by kind, predicted and come true; how often each predicate was decided in which tier;
// the bits of precision; the seconds of the paper's four steps (section 7.3), whose times do not
// add up to the total, as they leave out what belongs to none.
std::string stats_text(const RunDescription& run, const Outcome& outcome, const EngineStats& stats);

}  // namespace voroproof::internal
