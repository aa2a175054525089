// A run that was begun is taken up: what its history tells is done again without any search for
// what comes next.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "exact/patience.h"
#include "filtered/numbers/next_double.h"
#include "kinetic/engine.h"
#include "kinetic/flip_kind.h"
#include "kinetic/inelastic_collapse.h"
#include "kinetic/instant_record.h"
#include "kinetic/schedule.h"

namespace voroproof::internal {

// Does to the engine's parts what is told to it, and passes it on to the sink, which has the same
// history then as after a run to that time. Which collisions and maneuvers are simultaneous is
// decided as in a run: proofs by symmetry rest on it later. Throws OtherRun.
template <class Arithmetic>
class Resumption final : public EventSink {
 public:
  // Of the engine, as they are before t = 0; all outlive this. `begin`: what else is to be done
  // once the diagram is there.
  struct Parts {
    Motion& motion;
    Diagram& diagram;
    Degrees& degrees;  // of no diagram before `begin`
    Arithmetic& arithmetic;
    Schedule<Arithmetic>& schedule;
    InstantRecord& instant;
    InelasticCollapse& collapse_watch;
    EngineStats& stats;
    EventSink& sink;
    std::function<void()> begin;
  };
  explicit Resumption(Parts parts) : p_(std::move(parts)) {}

  void begin(const std::vector<Quad>& initial) override {
    if (p_.motion.size() > 1 || !initial.empty()) {
      try {
        p_.diagram = diagram_of(p_.motion.size(), initial);
      } catch (const std::invalid_argument& e) {
        throw OtherRun(std::string("the initial diagram is none: ") + e.what());
      }
    }
    p_.arithmetic.is_at(0);
    p_.begin();
    p_.sink.begin(initial);
  }

  void flip(double t, const Quad& edge) override {
    Patience::ask();
    const Diagram::HalfEdge h = find_edge(p_.diagram, edge);
    if (h < 0 || edge.s == edge.e) throw OtherRun("there is no such edge to flip");
    ++p_.stats.flips[static_cast<int>(p_.degrees.kind_of_flip(p_.diagram, edge))];
    p_.diagram.flip(h);
    p_.degrees.flip(edge);
    p_.instant.set_time(t);
    p_.instant.add_flip(edge);
    p_.instant.tell(p_.sink);
  }

  void collide(double t, GenId i, GenId j, const RoundedState& first,
               const RoundedState& second) override {
    Patience::ask();
    // At the instant of what was told last, unless that is proved to be over.
    const bool lone = t != t_ || contact(i, j, t).kind != NextContact::Kind::now;
    if (lone) begin_with_contact(t, i, j);
    const Impact impact = p_.arithmetic.collide(i, j, lone);
    if (lone && impact.t != t) throw OtherRun("the collision is at another time");
    if (i != container_id) require_same(impact.first, first);
    require_same(impact.second, second);
    p_.instant.set_time(t);
    p_.instant.add_collision(i, j, impact);
    ++(i == container_id ? p_.stats.wall_collisions : p_.stats.disk_collisions);
    p_.collapse_watch.after_collision(i, j, p_.arithmetic.now(), p_.schedule.quiet_until());
    p_.instant.tell(p_.sink);
  }

  void maneuver(double t, GenId disk, const RoundedState& state) override {
    Patience::ask();
    if (together_.empty()) begin_maneuvers(t);
    const ManeuverInput next = together_.front();
    together_.erase(together_.begin());
    if (next.disk != disk || t != t_) throw OtherRun("another maneuver is next");
    const RoundedState computed = p_.arithmetic.maneuver(disk, next.t, next.vx, next.vy);
    require_same(computed, state);
    p_.instant.set_time(t);
    p_.instant.add_maneuver(disk, computed);
    ++p_.stats.maneuvers;
    p_.instant.tell(p_.sink);
  }

  // All is told; the run goes on at t0, at which nothing happens.
  void finish(const Rational& t0) {
    if (!together_.empty()) throw OtherRun("not all maneuvers of an instant are told");
    p_.arithmetic.after_changes();
    Event here(Event::Kind::maneuver, 0);
    here.exactly = &t0;
    p_.arithmetic.begin({p_.arithmetic.tight(here)});
  }

 private:
  static void require_same(const RoundedState& a, const RoundedState& b) {
    if (a.px != b.px || a.py != b.py) throw OtherRun("a disk turns at another place");
    if (a.vx != b.vx || a.vy != b.vy) throw OtherRun("a disk has another velocity");
  }

  // The next contact of the pair, if it is at a time that may be rounded to t, or before.
  NextContact contact(GenId i, GenId j, double t) {
    return p_.arithmetic.contact_from_now(i, j, next_above(t));
  }

  // A new instant, which begins with this collision.
  void begin_with_contact(double t, GenId i, GenId j) {
    leave(t);
    const NextContact found = contact(i, j, t);
    if (found.kind != NextContact::Kind::at) throw OtherRun("the two do not collide then");
    Event event(Event::Kind::contact, 0);
    std::tie(event.i, event.j) = std::pair(i, j);
    event.at = {found.lo, found.hi};
    std::vector<TimedEvent> ties{p_.arithmetic.rough(event)};
    if (const auto maneuvers = p_.schedule.maneuvers_at(t)) {
      const TimedEvent timed = p_.arithmetic.tight(*maneuvers);
      ties.front() = p_.arithmetic.tight(event);
      if (p_.arithmetic.order(ties.front(), timed) == 0) {
        ties.push_back(timed);
        with_maneuvers_ = true;
      }
    }
    p_.arithmetic.begin(ties);
  }
  void begin_maneuvers(double t) {
    const auto event = p_.schedule.maneuvers_at(t);
    if (!event) throw OtherRun("no maneuver is next at that time");
    // Those at 0 are at the instant at which the run begins.
    if (!with_maneuvers_ && sgn(*event->exactly) != 0) {
      leave(t);
      p_.arithmetic.begin({p_.arithmetic.tight(*event)});
    }
    with_maneuvers_ = false;
    p_.schedule.make_due(*event);
    together_ = p_.schedule.take_due_maneuvers();
    p_.arithmetic.is_at(together_.front().t);
  }
  // The instant of what was told last is over.
  void leave(double t) {
    if (!together_.empty()) throw OtherRun("not all maneuvers of an instant are told");
    if (with_maneuvers_) throw OtherRun("the maneuvers of an instant are not told");
    p_.arithmetic.after_changes();
    t_ = t;
  }

  Parts p_;
  double t_ = 0;                         // of the last collision or maneuver
  std::vector<ManeuverInput> together_;  // of this instant, not told yet
  bool with_maneuvers_ = false;          // the instant has maneuvers, none told yet
};

}  // namespace voroproof::internal
