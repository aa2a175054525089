// The present instant of a run: how tightly its time is known, what its exact time is made of, and
// what is known to happen at it.
#pragma once

#include <memory>
#include <vector>

#include "engine/event.h"
#include "filtered/computed/computed_motion.h"
#include "filtered/search/collapse.h"
#include "filtered/search/symmetry.h"

namespace voroproof::internal {

// Nothing is allocated, and no rational is made, for an instant that nobody asks for exactly.
class Present {
 public:
  explicit Present(Motion& motion) : motion_(motion) {}
  Present(const Present&) = delete;
  Present& operator=(const Present&) = delete;

  const Instant& instant() const { return now_; }

  // The instant of these simultaneous events, at least one, none of which has been processed.
  void begin(const std::vector<TimedEvent>& events);
  // Gives the present instant, or the start of the run, by its exact time: the time of a flip is no
  // root of its generators any more once their motion changes.
  void is_at(const Rational& t);

  // An edge that collapses at this instant and whose flip no search has isolated.
  void note_flip(const Quad& q) { known_.flips.push_back(states_of(motion_, q)); }
  // States are about to change: what happens at the instant is noted as they are before.
  void before_change();
  // The pair with j as its larger generator has collided. `narrower`: the time of the instant as
  // the collision tells it, or null.
  void after_collision(GenId j, const Impact* narrower);
  // All collisions and maneuvers of the instant are done: what is proved of them is noted.
  void after_changes();

 private:
  void set(const TimedEvent& event);

  Motion& motion_;
  Instant now_;
  // The origin of the exact time, where a flip or a contact began the instant.
  struct {
    Quad q;
    IsolatingInterval at;
    std::shared_ptr<const RootInterval> fine;
  } root_;
  struct {
    GenId i = 0, j = 0;
    double near = 0;
  } contact_;
  Coincidence known_;
  bool lone_flip_ = false;  // which is the flip at root_, not noted in known_ yet
};

}  // namespace voroproof::internal
