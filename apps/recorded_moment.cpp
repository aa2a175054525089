#include "apps/recorded_moment.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <variant>

#include "history/error.h"
#include "history/history_file.h"
#include "history/json_text.h"

namespace voroproof {
namespace {

using HalfEdge = Diagram::HalfEdge;

struct TripleHash {
  std::size_t operator()(const Triple& v) const {
    std::uint64_t hash = 0;
    for (const GenId id : v) {
      hash = (hash ^ static_cast<std::uint32_t>(id)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash);
  }
};

std::string name_of(const Quad& q) {
  return "[" + std::to_string(q.l) + "," + std::to_string(q.r) + "," + std::to_string(q.s) + "," +
         std::to_string(q.e) + "]";
}

// A diagram whose edges are found by their names.
class NamedDiagram {
 public:
  explicit NamedDiagram(Diagram diagram) : diagram_(std::move(diagram)) {
    corners_.reserve(2 * static_cast<std::size_t>(diagram_.edges()));
    for (HalfEdge h = 0; h < 2 * diagram_.edges(); ++h) corners_.emplace(corner(h), h);
  }

  // Throws std::invalid_argument, with the reason, where that is no flip of the diagram.
  void flip(const Quad& q) {
    const auto found = corners_.find({q.l, q.r, q.e});
    if (found == corners_.end() || diagram_.quad(found->second) != q) {
      throw std::invalid_argument("the diagram has no edge " + name_of(q) + " at this time");
    }
    if (q.s == q.e) {
      throw std::invalid_argument("the edge " + name_of(q) + " cannot flip: its ends are the " +
                                  "two vertices of three generators");
    }
    const HalfEdge h = found->second;
    for (const HalfEdge side : sides(h)) corners_.erase(corner(side));
    diagram_.flip(h);
    for (const HalfEdge side : sides(h)) {
      if (!corners_.emplace(corner(side), side).second) {
        throw std::invalid_argument("the flip of " + name_of(q) +
                                    " makes a second vertex of one name");
      }
    }
  }

  Diagram take() { return std::move(diagram_); }

 private:
  // The three generators of the vertex on the left of h, from the start of h.
  Triple corner(HalfEdge h) const { return {diagram_.org(h), diagram_.dest(h), diagram_.apex(h)}; }
  // The half-edges of the two dual triangles at h.
  std::array<HalfEdge, 6> sides(HalfEdge h) const {
    const HalfEdge t = Diagram::twin(h);
    return {h, diagram_.next(h), diagram_.previous(h), t, diagram_.next(t), diagram_.previous(t)};
  }

  Diagram diagram_;
  std::unordered_map<Triple, HalfEdge, TripleHash> corners_;
};

// The states of the disks as the events go by; known until an event does not tell.
class RecordedStates {
 public:
  explicit RecordedStates(const Scene& scene) {
    states_.reserve(scene.disks.size());
    for (const DiskSpec& disk : scene.disks) {
      states_.push_back({0, {disk.x, disk.y}, {disk.vx, disk.vy}});
    }
  }

  void follow(const CollideEvent& event) {
    for (const int side : {0, 1}) {
      const GenId id = side == 0 ? event.i : event.j;
      if (id == container_id) continue;
      set(id, exact_time(event), exact_center(event, side), exact_velocity(event, side));
    }
  }
  void follow(const ManeuverEvent& event) {
    set(event.disk, exact_time(event), exact_center(event), exact_velocity(event));
  }
  void follow(const FlipEvent&) {}

  std::optional<std::vector<RecordedState>> take() {
    if (!known_) return std::nullopt;
    return std::move(states_);
  }

 private:
  void set(GenId id, Rational t, std::optional<ExactVec2> center,
           std::optional<ExactVec2> velocity) {
    if (!center || !velocity) {
      known_ = false;
    } else if (known_) {
      states_[id] = {std::move(t), *std::move(center), *std::move(velocity)};
    }
  }

  std::vector<RecordedState> states_;
  bool known_ = true;
};

Diagram initial_diagram(const HistoryHeader& header, int disks, const std::string& path,
                        const std::function<Diagram()>& initial) {
  if (!header.initial) return initial();
  try {
    return diagram_of(disks, *header.initial);
  } catch (const std::invalid_argument& fault) {
    throw InputError(path, 1, "initial", fault.what());
  }
}

// Whether the history tells all about the time t: of a history that stopped, events at the last
// instant may be missing.
void check_covered(const HistoryReader& history, const std::string& path, const Rational& t) {
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

}  // namespace

RecordedMoment recorded_moment(const Scene& scene, const std::string& history_path,
                               const Rational& t, const std::function<Diagram()>& initial) {
  const int disks = static_cast<int>(scene.disks.size());
  HistoryReader history(history_path, disks);
  const HistoryHeader& header = history.header();
  if (header.scene_sha256 != scene.sha256) {
    throw InputError(history_path, 1, "scene_sha256", "not that of the scene, " + scene.sha256);
  }
  if (t > header.horizon) {
    throw InputError(history_path, 1, "horizon",
                     "the history covers [0, " + number_text(header.horizon) + "] only, and " +
                         number_text(t) + " is asked for");
  }
  NamedDiagram diagram(initial_diagram(header, disks, history_path, initial));
  RecordedStates states(scene);
  // An event at the horizon may have been rounded up with it.
  const bool all = t == header.horizon;
  while (const std::optional<Event> event = history.next()) {
    if (!all && exact_time(*event) > t) continue;
    if (const auto* flip = std::get_if<FlipEvent>(&*event)) {
      try {
        diagram.flip(flip->quad);
      } catch (const std::invalid_argument& fault) {
        throw InputError(history_path, history.line(), "flip", fault.what());
      }
    }
    std::visit([&](const auto& kind) { states.follow(kind); }, *event);
  }
  check_covered(history, history_path, t);
  return {diagram.take(), states.take()};
}

}  // namespace voroproof
