// The diagram over one slice of time: a run in slices (engine/sliced_run.h) is made of these.
#pragma once

#include <optional>
#include <stdexcept>
#include <vector>

#include "engine/certified.h"
#include "engine/event_sink.h"
#include "engine/fetch.h"
#include "engine/flipping.h"
#include "engine/instant_record.h"
#include "engine/led_turns.h"
#include "engine/schedule.h"

namespace voroproof::internal {

// Finds the flips of its slice and takes collisions and maneuvers over from the leader. At each
// instant it does what the engine does (engine/processing.h), but for searching for contacts.
class Follower {
 public:
  // `motion` follows the leader's and is as that is at the slice's begin, at which nothing turns
  // unless it is 0. It outlives this object.
  Follower(ComputedMotion& motion, double begin, bool profile);
  Follower(const Follower&) = delete;
  Follower& operator=(const Follower&) = delete;

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
    while (step()) {
      instant_.tell(sink);
      end_instant();
    }
    if (next_ != turns_->size()) throw std::logic_error("a slice ends before its turns");
  }

  Diagram& diagram() { return diagram_; }
  // Statistics: events reported, and the cost of finding the flips.
  const EngineStats& stats() const { return stats_; }

 private:
  void announce();
  bool step();
  void process_turns();
  void search_around(GenId g);

  EngineStats stats_;
  ComputedMotion& motion_;
  double begin_;
  bool profile_;
  Diagram diagram_;
  Certified arithmetic_;
  Schedule<Certified> schedule_;
  InstantRecord instant_;
  Flipping<Certified> flipping_;
  Fetch fetch_;
  const LedTurns* turns_ = nullptr;
  std::size_t next_ = 0;     // index of the next instant in turns_
  FoundEvent turn_;          // the announced one
  bool is_last_ = false;     // the slice ends at the run's horizon
  bool at_horizon_ = false;  // the last instant of the slice is reached
  std::vector<GenId> changed_;
  std::vector<TimedEvent> ties_;
};

}  // namespace voroproof::internal
