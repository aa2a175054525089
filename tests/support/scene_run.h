// Scenes made in a line, and the engine's history of one, kept in memory.
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "engine/engine.h"
#include "history/scene.h"

namespace voroproof::internal::testing {

// Mass: radius squared, as by default in scene files.
DiskInput disk(Rational x, Rational y, Rational radius, Rational vx, Rational vy);
DiskInput disk(Rational x, Rational y, Rational radius, Rational vx, Rational vy, Rational mass);

// An elastic scene around the origin.
Scene scene_of(Rational container_radius, Rational horizon, std::vector<DiskInput> disks);

// Whether the readers of scene files accept it: nothing overlaps, nobody slides along the wall.
bool is_acceptable(const Scene& scene);

// The scene file, for messages that can be reproduced.
std::string text(const Scene& scene);
std::string text(const Quad& q);

struct Event {
  enum class Kind { flip, collision, maneuver };
  Kind kind;
  double t;
  Quad edge{};                     // of a flip
  GenId i = 0, j = 0;              // of a collision, i < j; a maneuver has i = j
  RoundedState first{}, second{};  // of a collision: `first` is meaningless for the container
};

std::string text(const Event& event);

struct RecordedRun {
  std::vector<Quad> initial;
  std::vector<Event> events;
  std::vector<Quad> final_diagram;  // of the engine when it ended
  Outcome outcome;
  EngineStats stats;
  int begins = 0;  // calls of EventSink::begin

  bool complete() const { return outcome.kind == Outcome::Kind::complete; }
  std::size_t count(Event::Kind kind) const;
};

// The exact engine's run from 0 to the horizon, or until the monitor (EngineOptions) stops it.
RecordedRun run(const Scene& scene, const MotionOptions& options = {},
                std::function<bool(double t, std::uint64_t events)> monitor = {});

// The run with all options that an engine has.
RecordedRun run_with(const Scene& scene, const EngineOptions& options);

// When a run is kept: where it is asked for, or only when the monitor ends it.
enum class Keeping { asked_for, at_end };

// A run that is kept, and ended, once so many events are told, or some more, and another one that
// goes on from there: what both tell. `kept` gets how many are of the first; 0 where it came to its
// end before, or could not be kept.
RecordedRun resume(const Scene& scene, std::size_t events, const EngineOptions& options,
                   Keeping keeping, std::size_t& kept);

// "flip [..]" or "collide i j" in order, without times: what two runs must share.
std::vector<std::string> names(const RecordedRun& run);

// The first difference between two runs in events or any written number; empty if there is none.
std::string difference(const RecordedRun& a, const RecordedRun& b);

}  // namespace voroproof::internal::testing
