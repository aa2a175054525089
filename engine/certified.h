// The arithmetic of the engine: every answer is proved.
#pragma once

#include <vector>

#include "engine/engine_stats.h"
#include "engine/event_times.h"
#include "engine/led_turns.h"
#include "engine/present.h"
#include "engine/static_diagram.h"
#include "filtered/search/collapse.h"
#include "filtered/search/contact.h"
#include "filtered/search/point_cells.h"

namespace voroproof::internal {

// The engine's arithmetic: all that the engine (engine/processing.h) asks of numbers. Another
// class with these members makes another engine of it: bench/plain_doubles.h is one, to measure
// against.
class Certified {
 public:
  Certified(ComputedMotion& motion, EngineStats& stats)
      : motion_(motion),
        stats_(stats),
        collapses_(motion, stats.tiers),
        contacts_(motion, stats.tiers),
        points_(motion, contacts_),
        times_(motion, collapses_, contacts_, stats),
        present_(motion) {}

  // ---- The present instant. ----
  const Instant& now() const { return present_.instant(); }
  void begin(const std::vector<TimedEvent>& events) { present_.begin(events); }
  void is_at(const Rational& t) { present_.is_at(t); }
  void note_flip(const Quad& q) { present_.note_flip(q); }
  void after_changes() { present_.after_changes(); }

  // ---- Searches, as those of CollapseSearch and ContactSearch. ----
  Collapse collapse_from_now(const Quad& q, double end) { return collapses_.from(q, now(), end); }
  Collapse collapse_after(const Quad& q, double start, double end, const RootInterval* fine) {
    return collapses_.after(q, start, end, fine);
  }
  NextContact contact_from_now(GenId i, GenId j, double end) {
    return contacts_.from(i, j, now(), end);
  }
  // Whether a pair is not searched for contacts within the present instant.
  bool certainly_apart(GenId i, GenId j) const { return contacts_.certainly_apart(i, j, now()); }

  // ---- Points, as PointCells says. ----
  bool has_points() const { return points_.any(); }
  bool is_point(GenId g) const { return points_.is_point(g); }
  // Nothing is asked of generators that are no points.
  void require_area(GenId g, const std::vector<GenId>& neighbours) const {
    if (points_.is_point(g)) points_.require_area(g, neighbours, now());
  }

  // ---- The times of events, as those of EventTimes. ----
  TimedEvent rough(const FoundEvent& event) const { return times_.rough(event); }
  TimedEvent tight(const FoundEvent& event) const { return times_.tight(event); }
  int order(const TimedEvent& a, const TimedEvent& b) { return times_.order(a, b); }
  double rounded(const TimedEvent& event) { return times_.rounded(event); }

  // ---- What happens now. ----
  // The diagram at the start, right at the instant, becomes that just after it; returns the number
  // of flips.
  long settle(Diagram& diagram) { return internal::settle(diagram, motion_, now(), stats_.tiers); }
  // i < j touch now. `lone`: the collision is the first event of the instant and tells its time.
  Impact collide(GenId i, GenId j, bool lone) {
    present_.before_change();
    const Impact impact = motion_.collide(i, j, now().dd.hi);
    present_.after_collision(j, lone ? &impact : nullptr);
    return impact;
  }
  RoundedState maneuver(GenId disk, const Rational& t, const Rational& vx, const Rational& vy) {
    present_.before_change();
    return motion_.maneuver(disk, t, vx, vy);
  }
  // Repeats a turn of the leader (engine/led_turns.h): a collision, which tells the `time` of the
  // instant unless that is null, or a maneuver.
  void follow(const LedTurn& turn, const DdBall* time) {
    present_.before_change();
    motion_.follow(turn.i, turn.first, turn.j, turn.second, turn.v_scale);
    if (turn.i == turn.j) return;
    Impact impact{};
    if (time != nullptr) impact.time_dd = *time;
    present_.after_collision(turn.j, time != nullptr ? &impact : nullptr);
  }

 private:
  ComputedMotion& motion_;
  EngineStats& stats_;
  CollapseSearch collapses_;
  ContactSearch contacts_;
  PointCells points_;
  EventTimes times_;
  Present present_;
};

}  // namespace voroproof::internal
