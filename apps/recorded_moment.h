// What a history says about one instant: the diagram, and where the disks are.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "history/events.h"
#include "history/scene.h"
#include "topology/diagram.h"

namespace voroproof {

// A disk since its last event: at center + velocity (t - since).
struct RecordedState {
  Rational since;
  ExactVec2 center, velocity;
};

struct RecordedMoment {
  Diagram diagram;
  // Nothing where some collision or maneuver up to the instant lacks its `v` or its `p`.
  std::optional<std::vector<RecordedState>> states;
};

// Reads the whole history, which must be one of this scene and complete in form, and follows it up
// to the exact time t. Times are compared as they are recorded: what the history puts at t or
// before it has happened. Where the history lacks the diagram at 0+, `initial` is called for it.
//
// Throws InputError, also where a flip names an edge that is not there or where t is beyond what
// the history covers: its horizon, or the time it stopped at, where events may be missing.
RecordedMoment recorded_moment(const Scene& scene, const std::string& history_path,
                               const Rational& t, const std::function<Diagram()>& initial);

}  // namespace voroproof
