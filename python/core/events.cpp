#include "python/core/events.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>

namespace voroproof::python {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

void put(const std::optional<Vector>& vector, double (&to)[2]) {
  if (!vector) return;
  to[0] = (*vector)[0];
  to[1] = (*vector)[1];
}

std::optional<Vector> vector_of(const double (&from)[2]) {
  if (std::isnan(from[0]) && std::isnan(from[1])) return std::nullopt;
  return Vector{from[0], from[1]};
}

struct Filler {
  EventRow& row;

  void operator()(const FlipEvent& e) const {
    row.kind = Kind::flip;
    row.ids[0] = e.edge.l;
    row.ids[1] = e.edge.r;
    row.ids[2] = e.edge.s;
    row.ids[3] = e.edge.e;
  }
  void operator()(const CollisionEvent& e) const {
    row.kind = Kind::collision;
    row.ids[0] = e.i;
    row.ids[1] = e.j;
    for (const int side : {0, 1}) {
      put(e.velocity[side], row.velocity[side]);
      put(e.center[side], row.center[side]);
    }
  }
  void operator()(const ManeuverEvent& e) const {
    row.kind = Kind::maneuver;
    row.ids[0] = e.disk;
    put(e.velocity, row.velocity[0]);
    put(e.center, row.center[0]);
  }
};

}  // namespace

EventRow row_of(const Event& event) {
  EventRow row{time(event),
               0,
               {no_id, no_id, no_id, no_id},
               {{nan, nan}, {nan, nan}},
               {{nan, nan}, {nan, nan}}};
  std::visit(Filler{row}, event);
  return row;
}

Event event_of(const EventRow& row) {
  const auto& id = row.ids;
  switch (row.kind) {
    case Kind::flip:
      return FlipEvent{row.t, {id[0], id[1], id[2], id[3]}};
    case Kind::collision:
      return CollisionEvent{row.t,
                            id[0],
                            id[1],
                            {vector_of(row.velocity[0]), vector_of(row.velocity[1])},
                            {vector_of(row.center[0]), vector_of(row.center[1])}};
    case Kind::maneuver:
      return ManeuverEvent{row.t, id[0], vector_of(row.velocity[0]), vector_of(row.center[0])};
    default:
      throw std::invalid_argument("events: no kind of event is " + std::to_string(row.kind));
  }
}

History EventTable::history() const {
  History out = head;
  out.events.reserve(rows.size());
  for (const EventRow& row : rows) out.events.push_back(event_of(row));
  return out;
}

EventTable read_table(const std::string& path) {
  EventTable table;
  RowSink sink(table);
  table.head = read_history(path, sink);
  return table;
}

}  // namespace voroproof::python
