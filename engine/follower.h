// The diagram over one slice of time: a run in slices (engine/sliced_run.h) is made of these.
#pragma once

#include <stdexcept>
#include <utility>

#include "engine/certified.h"
#include "engine/event_sink.h"
#include "engine/led_turns.h"
#include "engine/run.h"

namespace voroproof::internal {

// Finds the flips of its slice and takes collisions and maneuvers over from the leader.
class Follower : public Run<Follower, Certified> {
 public:
  // `motion` follows the leader's and is as that is at the slice's begin, at which nothing turns
  // unless it is 0. It outlives this object.
  Follower(ComputedMotion& motion, double begin, bool profile)
      : Run(motion, {}, profile, 0), begin_(begin), profile_(profile) {}

  // Makes a diagram that is right at the slice's begin.
  void construct();
  // Makes it the diagram just after that instant, for which the turns at t = 0 are needed. The
  // slice has these `turns`, which outlive this object, and ends with the events at `end`.
  void settle(const LedTurns& turns, const Rational& end);
  // Tells the events of the slice, those at t = 0 included; calls `end_instant` after those of each
  // instant.
  template <class EndInstant>
  void run(EventSink& sink, const EndInstant& end_instant) {
    instant_.tell(sink);
    end_instant();
    flipping_.begin();
    flipping_.search_all();
    announce();
    while (!at_horizon_ && step()) {
      instant_.tell(sink);
      end_instant();
    }
    if (next_ != turns_->size()) throw std::logic_error("a slice ends before its turns");
  }

 private:
  friend Run;
  // ---- What Run asks for. ----
  void begin_instant();
  bool tells_time() const { return turns_now_; }
  void process_turns() {
    if (std::exchange(schedule_.due_turns().maneuvers, false)) follow_turns();
  }
  void search_contact(int) {}  // the leader tells of them

  void announce();
  void follow_turns();

  double begin_;
  bool profile_;
  const LedTurns* turns_ = nullptr;
  std::size_t next_ = 0;     // index of the next instant in turns_
  Moment turn_;              // the announced one
  bool turns_now_ = false;   // it is at the present instant
  bool is_last_ = false;     // the slice ends at the run's horizon
  bool at_horizon_ = false;  // the last instant of the slice is reached
};

}  // namespace voroproof::internal
