// A slice of time of a run, and the history of it while it is being computed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <memory>
#include <optional>
#include <vector>

#include "engine/engine_stats.h"
#include "engine/event_sink.h"
#include "engine/inelastic_collapse.h"
#include "engine/led_turns.h"
#include "exact/topology/diagram.h"
#include "filtered/computed/computed_motion.h"

namespace voroproof::internal {

// Events of whole instants, in their order.
class Chunk final : public EventSink {
 public:
  void begin(const std::vector<Quad>&) override {}
  void flip(double t, const Quad& edge) override { items_.push_back({t, edge, Kind::flip}); }
  void collide(double t, GenId i, GenId j, const RoundedState& first,
               const RoundedState& second) override {
    items_.push_back({t, {i, j, 0, 0}, Kind::collision});
    states_.push_back(first);
    states_.push_back(second);
    ++turns_;
  }
  void maneuver(double t, GenId disk, const RoundedState& state) override {
    items_.push_back({t, {disk, disk, 0, 0}, Kind::maneuver});
    states_.push_back(state);
    ++turns_;
  }

  EngineStats stats;  // counts for this slice up to its end

  void reserve(std::size_t items) { items_.reserve(items); }
  void end_instant() {
    if (!items_.empty()) items_.back().ends_instant = true;
  }
  std::size_t size() const { return items_.size(); }
  int turns() const { return turns_; }
  // Tells all of it; calls `instant` before each instant with its time, the number of its events
  // and the number of turns told before.
  template <class Instant>
  void tell(EventSink& sink, const Instant& instant) const {
    const RoundedState* state = states_.data();
    int turns = 0;
    for (std::size_t k = 0, end = 0; k < items_.size(); ++k) {
      const Item& e = items_[k];
      if (k == end) {
        while (!items_[end++].ends_instant) continue;
        instant(e.t, end - k, turns);
      }
      if (e.kind == Kind::flip) {
        sink.flip(e.t, e.quad);
        continue;
      }
      ++turns;
      if (e.kind == Kind::collision) {
        sink.collide(e.t, e.quad.l, e.quad.r, state[0], state[1]);
        state += 2;
      } else {
        sink.maneuver(e.t, e.quad.l, *state++);
      }
    }
  }

 private:
  enum class Kind : std::uint8_t { flip, collision, maneuver };
  struct Item {
    double t;
    Quad quad;  // for other events, l and r are their disks
    Kind kind;
    bool ends_instant = false;
  };
  std::vector<Item> items_;
  std::vector<RoundedState> states_;
  int turns_ = 0;
};

// The next work of a thread in a run in slices, with the number of the slice among those not told
// yet.
struct SliceWork {
  enum class Kind { none, lead, follow };
  Kind kind = Kind::none;
  std::size_t slice = 0;
};

// Slices wait for followers, and not followers for slices; but few do, for what they take of
// memory. Of `count` slices, the last of which is the one to lead into, is_led(k) and is_taken(k)
// tell whether the leader is through with it and whether it has a follower. `may_lead`: nobody
// leads, and there is something to lead. `may_follow_ahead`: a slice may have a follower before it
// is led, who makes its first diagram meanwhile.
template <class IsLed, class IsTaken>
SliceWork next_work(std::size_t count, const IsLed& is_led, const IsTaken& is_taken, int threads,
                    bool may_lead, bool may_follow_ahead) {
  const auto many = static_cast<std::size_t>(threads);
  std::size_t ready = 0;
  for (std::size_t k = 0; k < count; ++k) ready += is_led(k) && !is_taken(k) ? 1 : 0;
  if (may_lead && count <= 2 * many && ready < (many + 1) / 2) {
    return {SliceWork::Kind::lead, count - 1};
  }
  for (const bool led : {true, false}) {
    if (!led && !may_follow_ahead) continue;
    for (std::size_t k = 0; k < count; ++k) {
      if (!is_taken(k) && is_led(k) == led) return {SliceWork::Kind::follow, k};
    }
  }
  return {};
}

// The work of the next slice of a run (Leader::lead()) of so many disks with so many threads: by
// its number from 0 and the work that is still to come.
std::uint64_t work_of_slice(int slice, double ahead, int disks, int threads);

// The begin of a slice, from which a run can be taken up.
struct SliceBegin {
  MotionSnapshot motion;
  std::shared_ptr<MotionStates::LastingSnapshot> states;  // as accurate as the leader's are by now
  std::vector<InelasticCollapse::Past> collapses;         // known to the leader then
};

struct Slice {
  int number = 0;
  double begin = 0;
  MotionSnapshot start;            // the leader's motion at the begin, for the follower
  std::optional<SliceBegin> kept;  // only if the run is to be kept

  // Written by the leader before `led`, read by the follower.
  Rational end;
  LedTurns turns;

  // The others are guarded by the run's mutex.
  bool led = false;      // as far as `end`
  bool taken = false;    // by a follower
  bool settled = false;  // its first diagram is there
  bool done = false;
  std::vector<Quad> first, last;  // the diagrams just after its begin and its end
  std::deque<Chunk> chunks;       // not told yet
  std::exception_ptr failure;
  EngineStats stats;
  Diagram diagram{0};  // at its end
};

}  // namespace voroproof::internal
