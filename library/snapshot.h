// The diagram at one instant, with coordinates.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "engine/engine.h"
#include "history/diagram_file.h"
#include "history/scene.h"
#include "library/history_index.h"
#include "library/queries/recorded_moment.h"

namespace voroproof::internal {

// The diagram just after all events at the exact time t >= 0, which may lie beyond the scene's
// horizon: the motion is followed up to t and the diagram at t built from nothing but the positions
// and velocities there. The edges are exact; the coordinates are rounded to nearest, ties to even.
//
// Throws Undecided where the engine stops before t or the budgets of bits and of exact arithmetic
// do not tell to what a coordinate rounds, and Interrupted where the monitor says so.
DiagramFile snapshot(const Scene& scene, const Rational& t, const EngineOptions& options = {});

// How the diagram at an instant comes from a history (the paper's section 6: Move-1 to 3,
// Construct-1 and 2).
enum class Construct {
  from_scratch = 1,  // from the positions at the instant
  by_flips = 2,      // the initial diagram, flipped
};
struct SnapshotWay {
  Move move = Move::colliding;
  Construct construct = Construct::by_flips;
  // An index of the history, for Move::colliding and Construct::by_flips: it is read from the last
  // entry before t to t, and the entry is taken at its word.
  std::optional<IndexFile> index = std::nullopt;
  bool checked = true;  // by flips: a diagram with an illegal edge (illegal_edge.h) is refused
};

// The diagram at t according to a history of the scene: its initial diagram after its flips up to
// t, the disks where its last recorded centres and velocities put them. What the history does not
// record, the engine computes.
//
// All ways give the same, provided that the history is right. Construct::from_scratch takes the
// edges from the true motion at t, replayed from the collisions (replayed_motion), and then puts
// the flips recorded within a unit in the last place of t on the side of t on which they are
// recorded; it throws InputError where the collisions are not those of the true motion.
//
// Throws InputError besides: see recorded_moment(), and where the way says that the diagram is
// checked.
DiagramFile snapshot(const Scene& scene, const std::string& history_path, const Rational& t,
                     const EngineOptions& options = {}, const SnapshotWay& way = {});
// The snapshot by the flips of a history that need be no file; `name` is for messages.
DiagramFile snapshot(const Scene& scene, HistorySource& history, const std::string& name,
                     const Rational& t, const EngineOptions& options = {}, bool checked = true);

}  // namespace voroproof::internal
