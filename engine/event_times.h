// The times of events: enclosed, put in order, rounded. Doubles, double-doubles and balls decide
// nearly always; else a proof by symmetry, or exact arithmetic within its budget.
#pragma once

#include "engine/engine_stats.h"
#include "engine/event.h"
#include "filtered/motion/motion.h"
#include "filtered/search/collapse.h"
#include "filtered/search/contact.h"

namespace voroproof::internal {

class EventTimes {
 public:
  EventTimes(Motion& motion, const CollapseSearch& collapses, const ContactSearch& contacts,
             EngineStats& stats)
      : motion_(motion), collapses_(collapses), contacts_(contacts), stats_(stats) {}

  // The time as the search has found it, where that is narrow enough: for a contact.
  TimedEvent rough(const FoundEvent& event) const;
  // The time as narrow as double-doubles say; more bits are taken where these leave much open.
  TimedEvent tight(const FoundEvent& event) const;

  // The order of two events: negative, zero (simultaneous: proved) or positive. Throws Undecided
  // where the bits do not suffice.
  int order(const TimedEvent& a, const TimedEvent& b);

  // The time rounded to nearest. Throws Undecided where the bits do not suffice.
  double rounded(const TimedEvent& event);

  // The time as an algebraic number. Throws BudgetExceeded.
  static ExactTime exact(const FoundEvent& event, ExactMotion& exact);

 private:
  int bits() const { return motion_.goal_bits() + 32; }
  Ball ball(const FoundEvent& event, int bits) const;
  DdBall by_ball(const FoundEvent& event) const;
  bool is_rational(const FoundEvent& event) const;
  bool same_by_symmetry(const FoundEvent& a, const FoundEvent& b) const;
  [[noreturn]] static void give_up(const std::string& reason, const FoundEvent& event);

  Motion& motion_;
  const CollapseSearch& collapses_;
  const ContactSearch& contacts_;
  EngineStats& stats_;
};

}  // namespace voroproof::internal
