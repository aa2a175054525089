// The state that a history gives for one instant: the diagram, and where the disks are.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "exact/topology/diagram.h"
#include "history/events.h"
#include "history/history_source.h"
#include "history/scene.h"

namespace voroproof::internal {

// A disk since its last turn on its recorded path (docs/claim.md, section 3): at
// center + velocity (t - since).
struct RecordedState {
  Rational since;
  ExactVec2 center, velocity;
  bool operator==(const RecordedState&) const = default;
};

// The paper's ways to bring the disks to their places (section 6). All are exact here, so that they
// differ in cost alone: for k events of which k_C are collisions or maneuvers of n disks, O(k n),
// O(k_C n), and O(k_C + n).
enum class Move {
  all_at_events = 1,      // every disk at every event
  all_at_collisions = 2,  // every disk at every collision or maneuver
  colliding = 3,          // the colliding (or maneuvering) disks alone, the others at the end
};

struct RecordedMoment {
  std::optional<Diagram> diagram;  // where asked for
  // Nothing where some collision or maneuver up to the instant lacks its `v`.
  std::optional<std::vector<RecordedState>> states;
};

// Follows the history up to the exact time t (see follow_history): the states of the disks, and
// with `replay_flips` (the paper's Construct-2) the diagram at 0+ after its flips. Where the
// history lacks the diagram at 0+, `initial` is called for it. Throws InputError, also where a flip
// names an edge that is not there.
RecordedMoment recorded_moment(const Scene& scene, const std::string& history_path,
                               const Rational& t, Move move, bool replay_flips,
                               const std::function<Diagram()>& initial);
// The recorded moment at t of a history of which all up to `known`, a moment of it, has been read.
// No more is read than up to t. Precondition: known.diagram.
RecordedMoment recorded_moment(HistorySource& history, const std::string& name, const Rational& t,
                               RecordedMoment known);
// The recorded moment of a history of this scene that need be no file; `name` is for messages.
RecordedMoment recorded_moment(const Scene& scene, HistorySource& history, const std::string& name,
                               const Rational& t, Move move, bool replay_flips,
                               const std::function<Diagram()>& initial);

}  // namespace voroproof::internal
