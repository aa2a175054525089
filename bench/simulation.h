// One whole simulation: engine built, run to the horizon, history written and closed.
#pragma once

#include <cstdint>
#include <string>

#include "engine/engine.h"
#include "history/scene.h"

namespace voroproof::internal::bench {

// The paper's REFERENCE family (corpus/generate.h), by what is varied here.
struct SceneChoice {
  int n = 1000;
  std::uint64_t seed = 1;
  double horizon = 1000;
  double density = 0.05;
  double rmin = 1, rmax = 10;  // radii are uniform between them
};

Scene scene_of(const SceneChoice& choice);

struct RunResult {
  double seconds = 0;           // everything from the scene in memory to the closed history
  double cpu_seconds = 0;       // the same, of all threads, as the system counts them
  double loop_cpu_seconds = 0;  // from the first diagram on: without its construction
  std::uint64_t bytes = 0;      // of the history
  Outcome outcome;
  EngineStats stats;
  std::uint64_t events() const {
    return stats.flip_count() + stats.disk_collisions + stats.wall_collisions + stats.maneuvers;
  }
};

// Runs the exact engine or, uncertified, the same engine in plain doubles. The history goes
// to a temporary file, written by a thread of its own, and is removed afterwards.
RunResult simulate(const Scene& scene, bool certified, const EngineOptions& options = {});

// The largest resident memory, in bytes, of a process that makes the scene and simulates it;
// without `engine`, of one that only makes the scene. The process is a fork of this one and
// starts with its memory: measure before making anything large.
enum class EngineKind { none, plain, certified };
std::uint64_t peak_memory(const SceneChoice& choice, EngineKind engine);

}  // namespace voroproof::internal::bench
