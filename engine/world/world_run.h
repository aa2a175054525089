// The engine of worlds: from disks that pass, grow, come and go to the history of their diagram.
//
// Nothing turns by itself in a world, so that every path is given, every time of an event is a root
// of a rational polynomial, and all decisions are taken with exact numbers behind balls. The
// diagram that the disks at rest have just after 0 is brought from event to event by what comes
// next for each of its edges and hidden disks (world_sweep.h). A disk that comes grows into the
// diagram from a radius at which another hides it, in no time; one that goes shrinks.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "exact/world_events.h"
#include "exact/world_motion.h"

namespace voroproof::internal {

// Receives a history in its order. Times and states are rounded to nearest.
class WorldSink {
 public:
  virtual ~WorldSink() = default;
  // The diagram at 0+, canonical and sorted. Called first.
  virtual void begin(const std::vector<Quad>& initial) = 0;
  virtual void event(const WorldEvent& event) = 0;
};

struct WorldOutcome {
  enum class Kind { complete, stopped, interrupted };
  Kind kind = Kind::complete;
  double t = 0;        // the history is right before this time
  std::string reason;  // why it stopped
};

struct WorldOptions {
  bool filters = true;           // doubles decide where they can: the history is the same without
  std::uint64_t max_events = 0;  // a history of more stops before the instant; 0: no limit
  // Called now and then, also within a long decision, with the time reached and the number of
  // events; false stops the run (WorldOutcome::Kind::interrupted).
  std::function<bool(double t, std::uint64_t events)> monitor;
};

// Runs from 0 to the horizon, events at the horizon included.
WorldOutcome run_world(const WorldMotion& world, const WorldOptions& options, WorldSink& sink);

}  // namespace voroproof::internal
