#include "library/queries/recorded_moment.h"

#include <cstdint>
#include <stdexcept>
#include <utility>
#include <variant>

#include "exact/topology/named_diagram.h"
#include "history/error.h"
#include "library/queries/followed_history.h"

namespace voroproof::internal {
namespace {

// The states of the disks as the events go by; known until an event does not tell.
class RecordedStates {
 public:
  RecordedStates(const Scene& scene, Move move) : move_(move) {
    states_.reserve(scene.disks.size());
    for (const DiskInput& disk : scene.disks) {
      states_.push_back({0, {disk.x, disk.y}, {disk.vx, disk.vy}});
    }
  }

  void follow(const Event& event) {
    if (!known_) return;
    const bool flip = std::holds_alternative<FlipEvent>(event);
    if (move_ == Move::all_at_events || (move_ == Move::all_at_collisions && !flip)) {
      const Rational t = exact_time(event);
      for (RecordedState& state : states_) move(state, t);
    }
    std::visit([&](const auto& kind) { follow_kind(kind); }, event);
  }

  RecordedStates(std::optional<std::vector<RecordedState>> known, Move move)
      : move_(move), known_(known.has_value()) {
    if (known) states_ = *std::move(known);
  }

  std::optional<std::vector<RecordedState>> take() {
    if (!known_) return std::nullopt;
    return std::move(states_);
  }

 private:
  static void move(RecordedState& state, const Rational& t) {
    if (state.since == t) return;
    const Rational passed = t - state.since;
    for (const int axis : {0, 1}) state.center[axis] += state.velocity[axis] * passed;
    state.since = t;
  }

  void follow_kind(const CollideEvent& event) {
    for (const int side : {0, 1}) {
      const GenId id = side == 0 ? event.i : event.j;
      if (id == container_id) continue;
      turn(id, exact_time(event), exact_velocity(event, side));
    }
  }
  void follow_kind(const ManeuverEvent& event) {
    turn(event.disk, exact_time(event), exact_velocity(event));
  }
  void follow_kind(const FlipEvent&) {}

  void turn(GenId id, const Rational& t, std::optional<ExactVec2> velocity) {
    known_ = known_ && velocity;
    if (!known_) return;
    move(states_[id], t);
    states_[id].velocity = *std::move(velocity);
  }

  Move move_;
  std::vector<RecordedState> states_;
  bool known_ = true;
};

void flip(NamedDiagram& diagram, const FlipEvent& event, const std::string& name,
          std::int64_t line) {
  try {
    diagram.flip(event.quad);
  } catch (const std::invalid_argument& fault) {
    throw InputError(name, line, "flip", fault.what());
  }
}

}  // namespace

RecordedMoment recorded_moment(const Scene& scene, const std::string& history_path,
                               const Rational& t, Move move, bool replay_flips,
                               const std::function<Diagram()>& initial) {
  const auto history =
      open_history(history_path, static_cast<int>(scene.disks.size()), scene.sha256);
  return recorded_moment(scene, *history, history_path, t, move, replay_flips, initial);
}

RecordedMoment recorded_moment(const Scene& scene, HistorySource& history, const std::string& name,
                               const Rational& t, Move move, bool replay_flips,
                               const std::function<Diagram()>& initial) {
  const int disks = static_cast<int>(scene.disks.size());
  RecordedStates states(scene, move);
  std::optional<NamedDiagram> diagram;
  HistoryFollower follower;
  follower.begin = [&](const HistoryHeader& header) {
    if (replay_flips) diagram.emplace(initial_diagram(header, disks, name, initial));
  };
  follower.event = [&](const Event& event, bool happened, std::int64_t line) {
    if (!happened) return;
    states.follow(event);
    const auto* f = std::get_if<FlipEvent>(&event);
    if (f != nullptr && diagram) flip(*diagram, *f, name, line);
  };
  follow_history(history, name, t, follower);
  RecordedMoment moment;
  if (diagram) moment.diagram = diagram->take();
  moment.states = states.take();
  return moment;
}

RecordedMoment recorded_moment(HistorySource& history, const std::string& name, const Rational& t,
                               RecordedMoment known) {
  RecordedStates states(std::move(known.states), Move::colliding);
  NamedDiagram diagram(*std::move(known.diagram));
  HistoryFollower follower;
  follower.event = [&](const Event& event, bool, std::int64_t line) {
    states.follow(event);
    if (const auto* f = std::get_if<FlipEvent>(&event)) flip(diagram, *f, name, line);
  };
  follow_rest(history, name, t, follower);
  return {.diagram = diagram.take(), .states = states.take()};
}

}  // namespace voroproof::internal
