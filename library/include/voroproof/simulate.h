// The engine: from a scene to its history, every decision exact.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "voroproof/export.h"
#include "voroproof/history.h"
#include "voroproof/scene.h"

namespace voroproof {

struct SimulateOptions {
  int threads = 1;               // that compute, with 500 disks or more; the same history
  int max_bits = 32768;          // limit for the numbers from which decisions are taken
  std::uint64_t max_events = 0;  // a history of more stops; 0: no limit
  // Called now and then, also within a long decision, with the time reached and the number of
  // events; false stops the run.
  std::function<bool(double t, std::uint64_t events)> monitor;
};

// The history up to the scene's horizon. Where a decision needs more than the budget, disks undergo
// infinitely many collisions in finite time, or the monitor says so, it stops: its ending says why,
// and what is before is right. Throws InputError, and whatever the sink throws.
VOROPROOF_API History simulate(const Scene& scene, const SimulateOptions& options = {});
VOROPROOF_API Ending simulate(const Scene& scene, EventSink& sink,
                              const SimulateOptions& options = {});

}  // namespace voroproof
