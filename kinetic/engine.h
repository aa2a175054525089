// The kinetic engine: from moving disks to the history of their Voronoi diagram.
//
// The paper's Algorithm 2 (DynamicVoronoiDiagram) without its two assumptions. The
// queue holds, for every V-edge, a time before which it certainly does not collapse
// and one before which its pair certainly does not touch; look-ahead is short, so most
// entries are such bounds, and enclosures of true events are refined only when they
// reach the head. Events at one instant are proved simultaneous and processed in the
// order of docs/formats.md.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "filtered/motion/motion.h"
#include "filtered/numbers/stats.h"
#include "topology/diagram.h"

namespace voroproof::internal {

struct ManeuverInput {
  Rational t;
  GenId disk;
  Rational vx, vy;
};

// Receives the history in its order. Times and states are rounded to nearest.
class EventSink {
 public:
  virtual ~EventSink() = default;
  // The diagram at 0+, canonical and sorted. Called first.
  virtual void begin(const std::vector<Quad>& initial) = 0;
  virtual void flip(double t, const Quad& edge) = 0;  // canonical, just before the flip
  // i < j; `first` is the state of i, meaningless where i is the container.
  virtual void collide(double t, GenId i, GenId j, const RoundedState& first,
                       const RoundedState& second) = 0;
  virtual void maneuver(double t, GenId disk, const RoundedState& state) = 0;
};

// The paper's flips by the cells they change (Figs. 4 to 15): `ordinary` is every other
// flip; `two_two_to_three_three` is Configuration W to its neighbour, an ordinary flip to the
// paper.
enum class FlipKind {
  ordinary,
  three_to_two,
  two_to_three,
  twofour_to_threethree,
  threethree_to_twofour,
  threethree_to_twotwo,
  twotwo_to_threethree,
  count
};
inline constexpr std::array<std::string_view, static_cast<int>(FlipKind::count)> flip_kind_names{
    "ordinary", "3-to-2", "2-to-3", "24-to-33", "33-to-24", "33-to-22", "22-to-33"};

struct EngineStats {
  std::array<std::uint64_t, static_cast<int>(FlipKind::count)> flips{};
  std::uint64_t disk_collisions = 0, wall_collisions = 0, maneuvers = 0;
  // Collapses and contacts that were predicted (found by a search), whether or not they
  // came true; and the searches made.
  std::uint64_t predicted_flips = 0, predicted_collisions = 0;
  std::uint64_t flip_searches = 0, contact_searches = 0;
  std::uint64_t ties = 0;            // pairs of events proved simultaneous
  std::uint64_t settling_flips = 0;  // at t = 0, not events
  std::uint64_t replays = 0;
  int highest_bits = 0, goal_bits = 0;
  double end = 0;  // time reached
  // The paper's four steps (section 7.3), in seconds; only where asked for.
  double flip_seconds = 0, collision_seconds = 0, queue_seconds = 0, move_seconds = 0;
  double initial_seconds = 0;
  TierCounts tiers;
  std::uint64_t flip_count() const {
    std::uint64_t sum = 0;
    for (const auto f : flips) sum += f;
    return sum;
  }
};

struct EngineOptions {
  MotionOptions motion;
  bool profile = false;
  std::uint64_t max_events = 0;  // a history of more stops before the instant; 0: no limit
  // Called now and then, also within a long decision, with the time reached and the number of
  // events; false stops the run (Outcome::interrupted).
  std::function<bool(double t, std::uint64_t events)> monitor;
};

struct Outcome {
  enum class Kind { complete, stopped, interrupted };
  Kind kind = Kind::complete;
  double t = 0;        // the history is right before this time
  std::string reason;  // of a stop
  // The events in question, with their generators.
  std::vector<std::variant<Quad, std::pair<GenId, GenId>>> events;
};

// As files and tables call it.
constexpr const char* name_of(Outcome::Kind kind) {
  switch (kind) {
    case Outcome::Kind::complete:
      return "complete";
    case Outcome::Kind::stopped:
      return "stopped";
    case Outcome::Kind::interrupted:
      break;
  }
  return "interrupted";
}

// Runs from 0 to the horizon of `input` (events at the horizon included). `certified`
// selects the exact engine; false is an instance of the same engine in plain doubles,
// which proves nothing and exists to be measured against.
template <bool certified>
class Engine {
 public:
  Engine(MotionInput input, std::vector<ManeuverInput> maneuvers, EngineOptions options);
  ~Engine();

  Outcome run(EventSink& sink);

  const EngineStats& stats() const;
  const Diagram& diagram() const;
  const Motion& motion() const;
  Motion& motion();

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

extern template class Engine<true>;
extern template class Engine<false>;

}  // namespace voroproof::internal
