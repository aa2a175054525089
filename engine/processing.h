// The engine over any arithmetic: what is done at each instant.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engine/engine.h"
#include "engine/fetch.h"
#include "engine/flipping.h"
#include "engine/inelastic_collapse.h"
#include "engine/instant_record.h"
#include "engine/kept_run.h"
#include "engine/meetings.h"
#include "engine/schedule.h"
#include "engine/static_diagram.h"
#include "exact/patience.h"

namespace voroproof::internal {

// The paper's Algorithm 2. `Arithmetic` is Certified (engine/certified.h) or a class with the same
// members.
template <class Arithmetic>
class EngineOver {
 public:
  EngineOver(MotionInput input, std::vector<ManeuverInput> maneuvers, EngineOptions options)
      : options_(std::move(options)),
        motion_(std::move(input), options_.motion),
        diagram_(motion_.size()),
        arithmetic_(motion_, stats_),
        schedule_(diagram_, arithmetic_, stats_, options_.profile, std::move(maneuvers),
                  motion_.input().horizon),
        instant_(options_.max_events),
        flipping_(diagram_, motion_, arithmetic_, schedule_, instant_, stats_),
        collapse_watch_(motion_),
        meetings_(motion_),
        fetch_(diagram_, motion_) {}
  EngineOver(const EngineOver&) = delete;
  EngineOver& operator=(const EngineOver&) = delete;

  // Does what Engine::run() says.
  Outcome run(EventSink& sink) {
    return run_from(sink, [this] { start(); });
  }
  // Does what Engine::resume() says.
  template <class Tell>
  Outcome resume(const KeptRun& kept, const Tell& told, EventSink& sink) {
    return run_from(sink, [&] { take_up(kept, told); });
  }

  const EngineStats& stats() const { return stats_; }
  const Diagram& diagram() const { return diagram_; }
  ComputedMotion& motion() { return motion_; }

 private:
  using HalfEdge = Diagram::HalfEdge;

  template <class Start>
  Outcome run_from(EventSink& sink, const Start& start) {
    sink_ = &sink;
    Outcome outcome;
    std::optional<Patience> patience;
    if (options_.monitor) patience.emplace([this] { return goes_on(); });
    try {
      start();
      is_between_ = true;
      while (step()) {
      }
      outcome.t = round_nearest(motion_.input().horizon);
    } catch (const GivenUp&) {
      if (!begun_) sink_->begin({});
      keep_quietly();
      outcome.kind = Outcome::Kind::interrupted;
      outcome.t = instant_.told_time();
      outcome.reason = "interrupted";
    } catch (const Undecided& u) {
      if (!begun_) sink_->begin({});
      outcome.kind = Outcome::Kind::stopped;
      outcome.t = instant_.right_before(std::min(schedule_.frontier(), meetings_.before()));
      outcome.reason = u.what();
      if (u.flip) outcome.events.emplace_back(*u.flip);
      if (u.contact) outcome.events.emplace_back(*u.contact);
    }
    stats_.end = outcome.t;
    stats_.replays = motion_.replays();
    stats_.highest_bits = motion_.highest_bits();
    stats_.goal_bits = motion_.goal_bits();
    return outcome;
  }

  // Between two instants, once the next one is found.
  void look_up() {
    if (options_.keep && (wants_to_keep_ || options_.is_to_keep())) wants_to_keep_ = !keep();
    if (options_.monitor && !goes_on()) throw GivenUp();
  }
  bool goes_on() const { return options_.monitor(arithmetic_.now().lo, instant_.told()); }

  // Tells what there is to go on with from a time between the last instant and the next; false if
  // no double is between them.
  bool keep() {
    const double last = arithmetic_.now().hi, next = schedule_.frontier();
    const double t0 = last + 0.5 * (next - last);
    if (!(last < t0 && t0 < next)) return false;
    try {
      keep_at(t0);
    } catch (const std::bad_alloc&) {
      // The run needs no such memory: another time there may be some.
    }
    return true;
  }
  void keep_at(double t0) {
    KeptRun kept;
    kept.t0 = t0;
    kept.events = instant_.told();
    kept.last = instant_.told_time();
    kept.stats = stats_;
    kept.diagram = diagram_.quads();
    kept.divisions = divisions_;
    kept.collapses = collapse_watch_.pasts();
    keep_motion(motion_, kept);
    options_.keep(std::move(kept));
  }
  // The same for a run that was given up; it need not be possible, and may not take long: whoever
  // gave it up waits.
  void keep_quietly() {
    if (!options_.keep || !is_between_) return;
    using Clock = std::chrono::steady_clock;
    const Clock::time_point until = Clock::now() + std::chrono::milliseconds(400);
    const Patience patience([until] { return Clock::now() < until; });
    try {
      keep();
    } catch (const GivenUp&) {
    } catch (const Undecided&) {
    }
  }

  // ---- The start: t = 0. ----
  void start() {
    const Stopwatch watch(options_.profile, stats_.initial_seconds);
    arithmetic_.is_at(0);
    diagram_ = static_diagram(motion_, 0, stats_.tiers);
    flipping_.start();
    schedule_.start(first_window(motion_), motion_.size());
    for (int e = 0; e < schedule_.slots(); ++e) schedule_.search_contact(e);
    // Events of the motion at t = 0 come before the diagram at 0+.
    schedule_.make_first_maneuvers_due();
    process_motion_events();
    stats_.settling_flips = arithmetic_.settle(diagram_);
    sink_->begin(diagram_.quads());
    begun_ = true;
    flipping_.begin();
    flipping_.search_all();
    // Flips make new pairs, and points may meet at a disk.
    if (stats_.settling_flips > 0 || arithmetic_.has_points()) search_contacts();
    instant_.tell(*sink_);
  }

  // ---- The start at t0, after all that is told. ----
  template <class Tell>
  void take_up(const KeptRun& kept, const Tell& told) {
    begun_ = true;
    instant_.go_on_after(kept.events, kept.last);
    if (motion_.size() > 1 || !kept.diagram.empty()) {
      try {
        diagram_ = diagram_of(motion_.size(), kept.diagram);
      } catch (const std::invalid_argument& e) {
        throw OtherRun(std::string("the diagram that was kept is none: ") + e.what());
      }
    }
    schedule_.start(0, motion_.size());
    ReturnOfMotion motion(motion_, kept, [this] { return schedule_.pass_maneuvers(); });
    told(motion);
    motion.finish();
    stats_.add(kept.stats);
    stats_.settling_flips = kept.stats.settling_flips;
    divisions_ = kept.divisions;
    if (kept.collapses.size() != collapse_watch_.pasts().size()) {
      throw OtherRun("the last collisions are not those of each disk");
    }
    collapse_watch_.go_on_with(kept.collapses);
    resumed_at_ = to_rational(kept.t0);
    FoundEvent here(FoundEvent::Kind::maneuver, 0);
    here.exactly = &resumed_at_;
    arithmetic_.begin({arithmetic_.tight(here)});
    flipping_.start();
    flipping_.begin();
    schedule_.start(first_window(motion_), motion_.size(), round_down(resumed_at_));
    flipping_.search_all();
    search_contacts();
    if (schedule_.take_due_flip() || schedule_.take_due_contact()) {
      throw OtherRun("something that is not told happens before the run can go on");
    }
  }

  void search_contacts() {
    for (int e = 0; e < schedule_.slots(); ++e) search_contact(e);
  }

  // Looks also for points that meet at a disk which they do not collide with.
  void search_contact(int edge) {
    schedule_.search_contact(edge);
    if (!arithmetic_.has_points()) return;
    const auto [i, j] = schedule_.pair_of(edge);
    if (i == container_id || arithmetic_.is_point(i) == arithmetic_.is_point(j)) return;
    const GenId point = arithmetic_.is_point(i) ? i : j;
    for (const GenId g : diagram_.neighbours(point == i ? j : i)) {
      if (g == point || g == container_id || !arithmetic_.is_point(g)) continue;
      const auto [a, b] = std::minmax(point, g);
      meetings_.note(a, b, arithmetic_.contact_from_now(a, b, schedule_.horizon_up()));
    }
  }

  // ---- One instant; false if it is the horizon and has no event, or there is none. ----
  bool step() {
    if (!schedule_.next_instant(ties_)) return false;
    const TimedEvent& first = ties_.front();
    meetings_.require_none_until(first.hi);
    if ((++steps_ & 0x0f) == 0) look_up();
    is_between_ = false;
    if (diagram_.edges() > 0) {
      if (first.event.exactly == nullptr) fetch_.around_edge(first.event.item & ~1);
      schedule_.fetch_ahead(fetch_);
    }
    const int records = motion_.records();
    arithmetic_.begin(ties_);
    bool horizon = false;
    if (!first.tight) {
      process_contact(first.event.i, first.event.j, true);
    } else {
      instant_.set_time(arithmetic_.rounded(first));
      horizon = process_simultaneous();
      if (horizon && ties_.size() == 1) return false;
    }
    process_motion_events();
    while (const std::optional<int> edge = schedule_.take_due_flip()) process_flip(*edge);
    const double before = instant_.told_time();
    instant_.tell(*sink_);
    if (instant_.told_time() == before && motion_.records() > records)
      divisions_.push_back(records);
    if (horizon) schedule_.pass_horizon();
    is_between_ = true;
    return true;
  }

  // The events of ties_: a single flip or contact at once, all else in its order. Returns whether
  // the horizon is one of them.
  bool process_simultaneous() {
    const FoundEvent& first = ties_.front().event;
    if (ties_.size() == 1 && first.is_flip()) {
      process_flip(first.item / 2);
      return false;
    }
    if (ties_.size() == 1 && first.is_contact()) {
      process_contact(first.i, first.j, false);
      return false;
    }
    bool horizon = false;
    for (const TimedEvent& timed : ties_) {
      schedule_.make_due(timed.event);
      horizon |= timed.event.kind == FoundEvent::Kind::horizon;
    }
    return horizon;
  }

  // Collisions, then maneuvers, then collisions again.
  void process_motion_events() {
    for (;;) {
      if (const auto pair = schedule_.take_due_contact()) {
        process_contact(pair->first, pair->second, false);
        continue;
      }
      const std::vector<ManeuverInput> together = schedule_.take_due_maneuvers();
      if (together.empty()) break;
      process_maneuvers(together);
    }
    arithmetic_.after_changes();
    if (arithmetic_.has_points()) {
      for (const GenId g : changed_) require_areas(g);
    }
    // The searches are made only now: with some of the instant's velocities most would be for
    // nothing, and harder than those that count.
    flipping_.next_change();
    for (const GenId g : changed_) search_around(g);
    changed_.clear();
  }

  // `lone`: nothing else is at the instant, and the collision tells its time.
  void process_contact(GenId i, GenId j, bool lone) {
    Impact impact;
    {
      const Stopwatch watch(options_.profile, stats_.move_seconds);
      impact = arithmetic_.collide(i, j, lone);
    }
    if (lone) instant_.set_time(impact.t);
    instant_.add_collision(i, j, impact);
    ++(i == container_id ? stats_.wall_collisions : stats_.disk_collisions);
    collapse_watch_.after_collision(i, j, arithmetic_.now(), schedule_.quiet_until());
    change(i);
    change(j);
  }

  // All of one instant.
  void process_maneuvers(const std::vector<ManeuverInput>& together) {
    arithmetic_.is_at(together.front().t);
    for (const ManeuverInput& m : together) {
      const Stopwatch watch(options_.profile, stats_.move_seconds);
      instant_.add_maneuver(m.disk, arithmetic_.maneuver(m.disk, m.t, m.vx, m.vy));
      ++stats_.maneuvers;
    }
    for (const ManeuverInput& m : together) change(m.disk);
  }

  // A disk has a new velocity: which of its neighbours does it touch and approach now?
  void change(GenId g) {
    if (g == container_id) return;
    schedule_.forget_contacts_of(g);
    if (std::find(changed_.begin(), changed_.end(), g) == changed_.end()) changed_.push_back(g);
    for_each_half_edge_of(g, [this](HalfEdge h) {
      const auto [i, j] = schedule_.pair_of(h / 2);
      if (!arithmetic_.certainly_apart(i, j)) schedule_.search_contact(h / 2);
    });
  }

  // The cells of the disk, if it is a point, and of its neighbours that are points.
  void require_areas(GenId g) const {
    const std::vector<GenId> near = diagram_.neighbours(g);
    arithmetic_.require_area(g, near);
    for (const GenId n : near) arithmetic_.require_area(n, diagram_.neighbours(n));
  }

  // The disk's motion and that of its neighbours is settled for the instant.
  void search_around(GenId g) {
    const HalfEdge first = diagram_.anchor(g);
    if (first >= 0) fetch_.around_cell(first);
    for_each_half_edge_of(g, [&](HalfEdge h) {
      search_contact(h / 2);
      if (first < 0) return;
      flipping_.search_once(h / 2);
      flipping_.search_once(diagram_.next(h) / 2);
    });
  }
  // The half-edges of the disk's cell, counterclockwise; half-edge 0 for a lone disk.
  template <class Visit>
  void for_each_half_edge_of(GenId g, Visit&& visit) const {
    const HalfEdge first = diagram_.anchor(g);
    if (first < 0) return visit(0);
    HalfEdge h = first;
    do {
      visit(h);
      h = diagram_.rotate(h);
    } while (h != first);
  }

  void process_flip(int edge) {
    flipping_.process(edge);
    search_contact(edge);
  }

  EngineStats stats_;
  EngineOptions options_;
  ComputedMotion motion_;
  Diagram diagram_;
  Arithmetic arithmetic_;
  Schedule<Arithmetic> schedule_;
  InstantRecord instant_;
  Flipping<Arithmetic> flipping_;
  InelasticCollapse collapse_watch_;
  Meetings meetings_;
  Fetch fetch_;
  EventSink* sink_ = nullptr;
  bool begun_ = false;       // the sink has the first diagram
  bool is_between_ = false;  // all of the last instant is told, and nothing of the next is done
  bool wants_to_keep_ = false;
  Rational resumed_at_;           // time at which the run was taken up
  std::vector<int> divisions_;    // see KeptRun
  std::vector<GenId> changed_;    // disks with new velocities at the present instant
  std::vector<TimedEvent> ties_;  // the events of the present instant
  std::uint64_t steps_ = 0;
};

}  // namespace voroproof::internal
