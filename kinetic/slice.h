// A slice of time of a run, and the history of it while it is being computed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <memory>
#include <vector>

#include "kinetic/engine_stats.h"
#include "kinetic/event_sink.h"
#include "kinetic/turns.h"
#include "topology/diagram.h"

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
  }
  void maneuver(double t, GenId disk, const RoundedState& state) override {
    items_.push_back({t, {disk, disk, 0, 0}, Kind::maneuver});
    states_.push_back(state);
  }

  EngineStats stats;  // of its slice up to its end

  void reserve(std::size_t items) { items_.reserve(items); }
  void end_instant() {
    if (!items_.empty()) items_.back().ends_instant = true;
  }
  std::size_t size() const { return items_.size(); }
  // Tells all of it; calls `instant` before each instant with its time and the number of its
  // events.
  template <class Instant>
  void tell(EventSink& sink, const Instant& instant) const {
    const RoundedState* state = states_.data();
    for (std::size_t k = 0, end = 0; k < items_.size(); ++k) {
      const Item& e = items_[k];
      if (k == end) {
        while (!items_[end++].ends_instant) continue;
        instant(e.t, end - k);
      }
      if (e.kind == Kind::flip) {
        sink.flip(e.t, e.quad);
      } else if (e.kind == Kind::collision) {
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
    Quad quad;  // of other events its l and r are their disks
    Kind kind;
    bool ends_instant = false;
  };
  std::vector<Item> items_;
  std::vector<RoundedState> states_;
};

// The work of a slice of a run on so many threads (Leader::lead()), by its number from 0.
std::uint64_t work_of_slice(int slice, int threads, int disks);

struct Slice {
  int number = 0;
  double begin = 0;
  MotionSnapshot start;  // the leader's motion at the begin, for the follower

  // Written by the leader before `led`, read by the follower.
  Rational end;
  Turns turns;

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
