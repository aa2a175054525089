// The arithmetic of the engine: every answer is proved.
#pragma once

#include <string>
#include <vector>

#include "engine/engine_stats.h"
#include "engine/event.h"
#include "engine/led_turns.h"
#include "engine/static_diagram.h"
#include "filtered/search/collapse.h"
#include "filtered/search/contact.h"
#include "filtered/search/moment.h"
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
        chronology_(motion, collapses_, contacts_, stats.tiers) {}

  // ---- The present instant. ----
  const Moment& now() const { return now_; }
  // The instant of these simultaneous events, at least one, none of which has been processed.
  void begin(const std::vector<FoundEvent>& events) {
    is_at(events.front());
    chronology_.begin_present();
    for (const FoundEvent& event : events) chronology_.note_present(event);
  }
  // Gives the present instant, or the start of the run, by its exact time: the time of a flip is no
  // root of its generators any more once their motion changes.
  void is_at(const Moment& m) {
    now_ = m;
    now_.present = &chronology_;
  }
  // An edge that collapses at this instant and whose flip no search has isolated.
  void note_flip(const Quad& q) { chronology_.note_flip(q); }
  // All collisions and maneuvers of the instant are done: what is proved of them is noted.
  void after_changes() { chronology_.note_collisions(now_); }

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

  // ---- The times of events. ----
  // Makes the moment tight; balls are asked where double-doubles leave much open.
  void tighten(Moment& m) const;
  int order(const Moment& a, const Moment& b) {
    if (a.is_contact() && b.is_contact() && a.i == b.i && a.j == b.j) return 0;
    std::string budget;
    const auto order = chronology_.order(a, b, budget);
    if (!order) a.give_up("two events may be simultaneous: " + budget);
    if (*order == 0) ++stats_.ties;
    return *order;
  }
  // The moment rounded to nearest. Throws Undecided where the bits do not suffice.
  double rounded(const Moment& m);

  // ---- What happens now. ----
  // The diagram at the start, right at the instant, becomes that just after it; returns the number
  // of flips.
  long settle(Diagram& diagram) { return internal::settle(diagram, motion_, now(), stats_.tiers); }
  // i < j touch now. `lone`: the collision is the first event of the instant and tells its time.
  Impact collide(GenId i, GenId j, bool lone) {
    const Impact impact = motion_.collide(i, j, now_.dd.hi);
    after_collision(i, j, lone ? &impact.time_dd : nullptr);
    return impact;
  }
  RoundedState maneuver(GenId disk, const Rational& t, const Rational& vx, const Rational& vy) {
    return motion_.maneuver(disk, t, vx, vy);
  }
  // Repeats a turn of the leader (engine/led_turns.h): a collision, which tells the `time` of the
  // instant unless that is null, or a maneuver.
  void follow(const LedTurn& turn, const DdBall* time) {
    motion_.follow(turn.i, turn.first, turn.j, turn.second, turn.v_scale);
    if (turn.i != turn.j) after_collision(turn.i, turn.j, time);
  }

 private:
  void after_collision(GenId i, GenId j, const DdBall* time) {
    if (time != nullptr) now_.narrow_to(*time);
    now_.collided(i, j, motion_.state_id(j));
  }

  ComputedMotion& motion_;
  EngineStats& stats_;
  CollapseSearch collapses_;
  ContactSearch contacts_;
  PointCells points_;
  Chronology chronology_;
  Moment now_;
};

}  // namespace voroproof::internal
