// The engine over any arithmetic: a run from its start or from where it was kept.
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
#include "engine/instant_order.h"
#include "engine/kept_run.h"
#include "engine/meetings.h"
#include "engine/run.h"
#include "exact/patience.h"

namespace voroproof::internal {

// A run that finds its collisions along V-edges.
template <class Arithmetic>
class EngineOver : OwnMotion,
                   public Run<EngineOver<Arithmetic>, Arithmetic>,
                   Turning<EngineOver<Arithmetic>, Arithmetic> {
  using Base = Run<EngineOver, Arithmetic>;
  using Turns = Turning<EngineOver, Arithmetic>;

 public:
  EngineOver(MotionInput input, std::vector<ManeuverInput> maneuvers, EngineOptions options)
      : OwnMotion{ComputedMotion(std::move(input), options.motion)},
        Base(OwnMotion::motion_, std::move(maneuvers), options.profile, options.max_events),
        Turns(OwnMotion::motion_, arithmetic_, schedule_.due_turns(), stats_, options.profile),
        options_(std::move(options)),
        meetings_(OwnMotion::motion_) {}

  // Does what Engine::run() says.
  Outcome run(EventSink& sink) {
    return run_from(sink, [this] { start(); });
  }
  // Does what Engine::resume() says.
  template <class Tell>
  Outcome resume(const KeptRun& kept, const Tell& told, EventSink& sink) {
    return run_from(sink, [&] { take_up(kept, told); });
  }

  ComputedMotion& motion() { return motion_; }

 private:
  friend Base;
  friend Turns;
  using HalfEdge = Diagram::HalfEdge;
  using Base::arithmetic_, Base::diagram_, Base::flipping_, Base::instant_, Base::motion_;
  using Base::schedule_, Base::stats_, Base::ties_;
  using Turns::collapse_watch_, Turns::tells_time_;

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
      if (options_.keep && is_between_) keep_quietly([this] { keep(); });
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
    options_.mark();
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

  // ---- The start: t = 0. ----
  void start() {
    const Stopwatch watch(options_.profile, stats_.initial_seconds);
    this->construct(0);
    schedule_.start(first_window(motion_), motion_.size());
    for (int e = 0; e < schedule_.slots(); ++e) schedule_.search_contact(e);
    // Events of the motion at t = 0 come before the diagram at 0+.
    schedule_.make_first_maneuvers_due();
    process_turns();
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
    arithmetic_.begin({{Moment::at(kept.t0), 0}});
    flipping_.start();
    flipping_.begin();
    schedule_.start(first_window(motion_), motion_.size(), kept.t0);
    flipping_.search_all();
    search_contacts();
    if (schedule_.take_due_flip() || !schedule_.due_turns().contacts.empty()) {
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
    const int records = motion_.records();
    if (!Base::step()) return false;
    const double before = instant_.told_time();
    instant_.tell(*sink_);
    if (instant_.told_time() == before && motion_.records() > records)
      divisions_.push_back(records);
    for (const FoundEvent& event : ties_) {
      if (schedule_.is_horizon(event)) schedule_.pass_horizon();
    }
    is_between_ = true;
    return true;
  }

  // ---- What Run asks for. ----
  void begin_instant() {
    meetings_.require_none_until(ties_.front().hi);
    if ((++steps_ & 0x0f) == 0) look_up();
    is_between_ = false;
    tells_time_ = !ties_.front().tight;
  }
  bool tells_time() const { return tells_time_; }
  void process_turns() {
    this->process_due();
    this->settle_turns();
  }

  // ---- What Turning asks for. ----
  void tell_collision(GenId i, GenId j, const Impact& impact, bool lone) {
    if (lone) instant_.set_time(impact.t);
    instant_.add_collision(i, j, impact);
    ++(i == container_id ? stats_.wall_collisions : stats_.disk_collisions);
  }
  void tell_maneuver(GenId disk, const RoundedState& state) {
    instant_.add_maneuver(disk, state);
    ++stats_.maneuvers;
  }
  void look_around(GenId g) {
    this->note_turn(g);
    this->for_each_half_edge_of(g, [this](HalfEdge h) {
      const auto [i, j] = schedule_.pair_of(h / 2);
      if (!arithmetic_.certainly_apart(i, j)) schedule_.search_contact(h / 2);
    });
  }
  auto take_maneuvers() { return schedule_.take_maneuvers(); }
  double quiet_until() const { return schedule_.quiet_until(); }

  EngineOptions options_;
  Meetings meetings_;
  EventSink* sink_ = nullptr;
  bool begun_ = false;       // the sink has the first diagram
  bool is_between_ = false;  // all of the last instant is told, and nothing of the next is done
  bool wants_to_keep_ = false;
  std::vector<int> divisions_;  // see KeptRun
  std::uint64_t steps_ = 0;
};

}  // namespace voroproof::internal
