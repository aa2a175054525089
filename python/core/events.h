// Histories as Python holds them: the events are rows of one array.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "voroproof/history.h"

namespace voroproof::python {

enum Kind : std::int32_t { flip = 0, collision = 1, maneuver = 2 };
inline constexpr std::int32_t no_id = -2;

// An event: an item of the structured array. Ids are l, r, s, e of a flip, i, j of a collision, the
// disk of a maneuver, and no_id; vectors that there are not are NaN.
struct EventRow {
  double t;
  std::int32_t kind;
  std::int32_t ids[4];
  double velocity[2][2];
  double center[2][2];
};

EventRow row_of(const Event& event);
// Throws std::invalid_argument where the row is no event.
Event event_of(const EventRow& row);

struct EventTable {
  History head;  // without its events
  std::vector<EventRow> rows;

  History history() const;  // a copy, as the library takes it
};
// Collects the rows of a run.
class RowSink final : public EventSink {
 public:
  explicit RowSink(EventTable& table) : table_(table) {}
  void begin(const std::vector<Edge>& initial) override { table_.head.initial = initial; }
  void event(const Event& event) override { table_.rows.push_back(row_of(event)); }

 private:
  EventTable& table_;
};

// Reads a history file. Throws InputError.
EventTable read_table(const std::string& path);

}  // namespace voroproof::python
