// Histories: every change of the diagram of a scene, with its time.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "voroproof/export.h"
#include "voroproof/extensions.h"
#include "voroproof/number.h"
#include "voroproof/scene.h"

namespace voroproof {

using Vector = std::array<double, 2>;

// A V-edge [l,r,s,e]: it leads from the vertex of l, s, r to that of l, r, e, with generator l on
// its left and r on its right. [r,l,e,s] is the same edge; canonical() is the smaller of the two.
struct Edge {
  int l = 0, r = 0, s = 0, e = 0;
};
constexpr bool operator==(const Edge& a, const Edge& b) {
  return a.l == b.l && a.r == b.r && a.s == b.s && a.e == b.e;
}
constexpr bool operator!=(const Edge& a, const Edge& b) { return !(a == b); }
VOROPROOF_API Edge canonical(const Edge& edge);
// The edge that a flip leaves in its place.
VOROPROOF_API Edge flipped(const Edge& edge);

// The edge, named as just before, shrinks to a point and is replaced by flipped(edge).
struct FlipEvent {
  double t = 0;
  Edge edge;
};

// i < j touch; i may be the container. Velocities are those just after, centres those then: [0] of
// i, [1] of j, none of the container. A history has them of both disks or of neither.
struct CollisionEvent {
  double t = 0;
  int i = 0, j = 0;
  std::array<std::optional<Vector>, 2> velocity, center;
};

// A maneuver of the scene takes place.
struct ManeuverEvent {
  double t = 0;
  int disk = 0;
  std::optional<Vector> velocity, center;
};

using Event = std::variant<FlipEvent, CollisionEvent, ManeuverEvent>;

VOROPROOF_API double time(const Event& event);

// How a history ends: it covers the whole horizon, or is right before t only.
struct Ending {
  bool complete = true;
  double t = 0;             // the horizon, rounded, of a complete one
  std::string reason;       // why it stopped
  Extensions extensions{};  // fields of the last line
};

struct History {
  std::string scene_sha256;  // see scene_sha256(const Scene&)
  Number horizon;
  std::string producer;                      // "name version"
  std::optional<std::vector<Edge>> initial;  // the diagram just after 0, canonical and sorted
  std::vector<Event> events;                 // in their order (docs/formats.md)
  Ending ending;
  // Events of a file that states numbers exactly (as text) which are no binary64: here they are
  // rounded. certify_files() judges the file itself.
  std::int64_t rounded = 0;
  Extensions extensions{};                             // fields of the header
  std::map<std::size_t, Extensions> event_extensions;  // by index, of the events that have any
};

// Receives a history in its order.
class VOROPROOF_API EventSink {
 public:
  virtual ~EventSink();
  // The diagram just after 0, canonical and sorted. Called first, if there is one.
  virtual void begin(const std::vector<Edge>& initial) = 0;
  virtual void event(const Event& event) = 0;
};

// Reads a history file. Throws InputError.
VOROPROOF_API History read_history(const std::string& path);
// Hands its events on as they are read, however many; the history that is returned has none of
// them, but their extensions. Throws whatever the sink throws, too.
VOROPROOF_API History read_history(const std::string& path, EventSink& sink);
// Writes it, whole or not at all, with edges canonical. Throws OutputError, and InputError where it
// is no history: times that decrease, ids out of range.
VOROPROOF_API void write_history(const std::string& path, const History& history);

}  // namespace voroproof
