#include "library/queries/followed_history.h"

#include <optional>
#include <stdexcept>
#include <variant>

#include "history/error.h"
#include "history/json_text.h"

namespace voroproof::internal {
namespace {

void check_covered(const HistorySource& history, const std::string& path, const Rational& t) {
  if (const auto* stop = std::get_if<HistoryStop>(&history.ending())) {
    const Rational stop_t = stop->exact_t ? *stop->exact_t : to_rational(stop->t);
    if (t >= stop_t) {
      throw InputError(path, history.line(), "stopped.t",
                       "the history is right before t = " + number_text(stop_t) + " only, and " +
                           number_text(t) + " is asked for");
    }
  } else if (!history.counts_match()) {
    throw InputError(path, history.line(), "end", "wrong counts of events");
  }
}

void check_horizon(const HistorySource& history, const std::string& name, const Rational& t) {
  const Rational& horizon = history.header().horizon;
  if (t <= horizon) return;
  throw InputError(name, 1, "horizon",
                   "the history covers [0, " + number_text(horizon) + "] only, and " +
                       number_text(t) + " is asked for");
}

// Whether an event has happened at t: one at the horizon may have been rounded up with it.
bool has_happened(const Event& event, const HistorySource& history, const Rational& t) {
  return t == history.header().horizon || exact_time(event) <= t;
}

}  // namespace

void follow_history(HistorySource& history, const std::string& name, const Rational& t,
                    const HistoryFollower& follower) {
  check_horizon(history, name, t);
  follower.begin(history.header());
  while (const std::optional<Event> event = history.next()) {
    follower.event(*event, has_happened(*event, history, t), history.line());
  }
  check_covered(history, name, t);
}

void follow_rest(HistorySource& history, const std::string& name, const Rational& t,
                 const HistoryFollower& follower) {
  check_horizon(history, name, t);
  while (const std::optional<Event> event = history.next()) {
    if (!has_happened(*event, history, t)) return;
    follower.event(*event, true, history.line());
  }
  check_covered(history, name, t);
}

void follow_history(const Scene& scene, const std::string& path, const Rational& t,
                    const HistoryFollower& follower) {
  const auto history = open_history(path, static_cast<int>(scene.disks.size()), scene.sha256);
  follow_history(*history, path, t, follower);
}

Diagram initial_diagram(const HistoryHeader& header, int disks, const std::string& path,
                        const std::function<Diagram()>& initial) {
  if (!header.initial) return initial();
  try {
    return diagram_of(disks, *header.initial);
  } catch (const std::invalid_argument& fault) {
    throw InputError(path, 1, "initial", fault.what());
  }
}

}  // namespace voroproof::internal
