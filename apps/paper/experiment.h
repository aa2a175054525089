// One run of an experiment after the paper's section 7: what Figs. 18 to 22 plot.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "engine/engine.h"
#include "history/events.h"
#include "history/scene.h"

namespace voroproof::internal {

// Summary of a set of numbers; zeros where the set is empty.
struct Distribution {
  std::size_t count = 0;
  double mean = 0, deviation = 0;  // the standard deviation
  double least = 0, lower_quartile = 0, median = 0, upper_quartile = 0, greatest = 0;
};
Distribution distribution_of(std::vector<double> values);

// The length of the intervals of Fig. 22, in units of time.
inline constexpr int frequency_interval = 10;

struct ExperimentRun {
  int disks = 0;
  Outcome outcome;
  EngineStats stats;
  double seconds = 0;  // time of the engine, without the counting besides
  // The predictions, counted by the rule of predictions.h.
  std::uint64_t predicted_flips = 0, predicted_flips_before_contact = 0, predicted_roots = 0,
                predicted_collisions = 0;
  // Events in [10 k, 10 (k + 1)); what happens exactly at the horizon counts in the last interval.
  std::vector<std::uint64_t> flip_frequency, collision_frequency;
  // When the run ended, in binary64, from states right to about 1e-12 of their size: of each disk
  // the mean gap to the disks that its cell shares an edge with; its speed.
  Distribution neighbor_distance, speed;
};

// Runs the engine with these options, and a profile. `predictions` also counts predictions, which
// takes longer than the run; the options' monitor is called again then, from the first event on.
// Where it says no, what is counted is of no use.
ExperimentRun run_experiment(const Scene& scene, bool predictions, EngineOptions options = {});

}  // namespace voroproof::internal
