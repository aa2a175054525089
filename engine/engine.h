// The kinetic engine: from moving disks to the history of their Voronoi diagram.
//
// The paper's Algorithm 2 (DynamicVoronoiDiagram) without its two assumptions. The
// queue holds, for every V-edge, a time before which it certainly does not collapse
// and one before which its pair certainly does not touch; look-ahead is short, so most
// entries are such bounds, and enclosures of true events are refined only when they
// reach the head. Events at one instant are proved simultaneous and processed in the
// order of docs/formats.md.
//
// Its parts: what is to come (schedule.h), the times of events and their order (moment.h of
// filtered/search/), what is done at each instant (run.h). On several threads a run is made
// in slices of time (sliced_run.h).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "engine/engine_stats.h"
#include "engine/event_sink.h"
#include "engine/maneuvers.h"
#include "exact/topology/diagram.h"
#include "filtered/computed/computed_motion.h"

namespace voroproof::internal {

struct KeptRun;  // engine/kept_run.h

// The hooks of tests of runs in slices; each may be null.
struct SliceHooks {
  // The least work of a slice (Leader::lead), in place of what suits.
  std::function<std::uint64_t(int slice)> work;
  // Where between two times a slice ends.
  std::function<double(double after, double before)> border;
  // May change the diagram that a slice begins with.
  std::function<void(int slice, Diagram& diagram)> diagram;
  // Called by the threads between their steps.
  std::function<void()> pause;
};

struct EngineOptions {
  MotionOptions motion;
  // With more than one the run is made in slices of time (engine/sliced_run.h), unless the scene
  // has fewer disks than that is worth.
  int threads = 1;
  int least_sliced = 500;
  SliceHooks slice_hooks;
  bool profile = false;
  std::uint64_t max_events = 0;  // a history of more stops before the instant; 0: no limit
  // Called now and then, also within a long decision, with the time reached and the number of
  // events; false stops the run (Outcome::interrupted).
  std::function<bool(double t, std::uint64_t events)> monitor;
  // All three or none. Asked as often as the monitor: whether what the run has come to is to be
  // kept.
  std::function<bool()> is_to_keep;
  // Called once all events are told up to a time at which nothing happens, and from which the run
  // may be kept.
  std::function<void()> mark;
  // Given the run as it was at the last mark(), soon after that where it is to be kept; also where
  // the monitor ends it.
  std::function<void(KeptRun&& kept)> keep;
};

struct Outcome {
  enum class Kind { complete, stopped, interrupted };
  Kind kind = Kind::complete;
  double t = 0;        // the history is right before this time
  std::string reason;  // why it stopped
  // The events in question, with their generators.
  std::vector<std::variant<Quad, std::pair<GenId, GenId>>> events;
};

// The name that files and tables call it by.
constexpr const char* name_of(Outcome::Kind kind) {
  switch (kind) {
    case Outcome::Kind::complete:
      return "complete";
    case Outcome::Kind::stopped:
      return "stopped";
    case Outcome::Kind::interrupted:
      break;
  }
  return "interrupted";
}

// Thrown where the told beginning cannot belong to a run of this engine.
class OtherRun : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Engine {
 public:
  // The maneuvers in order of their times; those after the horizon of `input` are left out.
  Engine(MotionInput input, std::vector<ManeuverInput> maneuvers, EngineOptions options);
  ~Engine();

  // Runs from 0 to the horizon, events at the horizon included. Once only.
  Outcome run(EventSink& sink);
  // Goes on with a run of the same input that was kept, in place of run(): `told` tells the
  // collisions and maneuvers of its history up to there, and may tell flips. The sink is told what
  // comes after.
  //
  // Throws OtherRun where what is told does not fit what was kept. Nothing of it is computed again:
  // both must be what this engine gave.
  Outcome resume(const KeptRun& kept, const std::function<void(EventSink&)>& told, EventSink& sink);

  const EngineStats& stats() const;
  // The diagram and the motion at the end of the run.
  const Diagram& diagram() const;
  const ComputedMotion& motion() const;
  ComputedMotion& motion();

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace voroproof::internal
