// A place in a history, moved forwards and backwards.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "exact/topology/named_diagram.h"
#include "history/events.h"
#include "history/history_reader.h"
#include "history/history_source.h"
#include "history/scene.h"

namespace voroproof::internal {

// The diagram between two events of a history, which is kept in memory: O(n + k) for n disks and k
// events. A step takes O(1) expected time, there and back.
class HistoryCursor {
 public:
  // Stands before the first event. The history must be of this scene and complete in form; one that
  // stopped early is followed to where it stopped. `initial` as for recorded_moment(). Throws
  // InputError, also where it does not cover the time `covered` and, from the members that move,
  // where a flip names an edge that is not there.
  HistoryCursor(const Scene& scene, const std::string& path,
                const std::function<Diagram()>& initial, const Rational& covered = 0);
  // The same for a history of this scene that need be no file; `name` is for messages.
  HistoryCursor(const Scene& scene, HistorySource& history, const std::string& name,
                const std::function<Diagram()>& initial, const Rational& covered = 0);

  const HistoryHeader& header() const { return header_; }
  // The number of events.
  std::size_t size() const { return events_.size(); }
  const Event& event(std::size_t number) const { return events_[number]; }

  // The number of events that have happened: event(position()) is the next.
  std::size_t position() const { return position_; }
  const NamedDiagram& diagram() const { return diagram_; }

  // One step; false at the end, and at the beginning.
  bool next();
  bool previous();
  // Moves to where `position` events have happened (position <= size()).
  void seek(std::size_t position);
  // Moves to just after all events that are recorded at the time t or before it; at the horizon,
  // after all events, for times may have been rounded up with it. Precondition: t >= 0.
  void seek(const Rational& t);
  // Where seek(t) leads.
  std::size_t position_at(const Rational& t) const;

 private:
  void flip(const Quad& q, std::size_t number);

  std::string path_;
  HistoryHeader header_;
  std::vector<Event> events_;
  std::size_t position_ = 0;
  NamedDiagram diagram_;
};

}  // namespace voroproof::internal
