// A history of a scene, followed up to an instant, in bounded memory.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "exact/topology/diagram.h"
#include "history/events.h"
#include "history/history_source.h"
#include "history/scene.h"

namespace voroproof::internal {

struct HistoryFollower {
  std::function<void(const HistoryHeader&)> begin;
  // Each event with its line. Times are compared as they are recorded: what the history puts at t
  // or before it has happened.
  std::function<void(const Event&, bool happened, std::int64_t line)> event;
};

// Reads the whole history, which must be complete in form, and shows it; `name` is for messages.
// Throws InputError, also where t is beyond what the history covers: its horizon, or the time it
// stopped at, where events may be missing.
void follow_history(HistorySource& history, const std::string& name, const Rational& t,
                    const HistoryFollower& follower);
// Shows what is left of a history of which something has been read, up to the first event later
// than t, and reads no further. Throws InputError as follow_history() does.
void follow_rest(HistorySource& history, const std::string& name, const Rational& t,
                 const HistoryFollower& follower);
// Reads and shows a history file, which must be a history of this scene.
void follow_history(const Scene& scene, const std::string& path, const Rational& t,
                    const HistoryFollower& follower);

// The diagram at 0+ that the header gives, or `initial` makes where it gives none. Throws
// InputError.
Diagram initial_diagram(const HistoryHeader& header, int disks, const std::string& path,
                        const std::function<Diagram()>& initial);

}  // namespace voroproof::internal
