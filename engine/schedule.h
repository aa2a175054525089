// The future events: for every V-edge its next flip and the next contact of its pair, the next
// maneuver, the horizon; and what is due at the present instant.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "engine/engine_stats.h"
#include "engine/event.h"
#include "engine/fetch.h"
#include "engine/instant_order.h"
#include "engine/look_ahead.h"
#include "engine/maneuvers.h"
#include "engine/queue.h"
#include "exact/enclosure.h"
#include "exact/patience.h"
#include "exact/topology/diagram.h"
#include "filtered/search/collapse.h"
#include "filtered/search/contact.h"

namespace voroproof::internal {

// The queue holds two items for each edge, then one for the next maneuver and one for the
// horizon. The key of an item is a bound: its event is not before it. Searches look ahead only a
// short way, so most keys are no more than that; an item whose search has found an event is marked.
//
// `Arithmetic` is Certified (engine/certified.h) or a class with the same members.
template <class Arithmetic>
class Schedule {
 public:
  using HalfEdge = Diagram::HalfEdge;

  // All four must outlive the schedule. `profile`: whether the times of the searches are taken.
  Schedule(const Diagram& diagram, Arithmetic& arithmetic, EngineStats& stats, bool profile,
           std::vector<ManeuverInput> maneuvers, const Rational& horizon)
      : diagram_(diagram),
        arithmetic_(arithmetic),
        stats_(stats),
        profile_(profile),
        maneuvers_(std::move(maneuvers), horizon),
        horizon_(horizon),
        horizon_up_(round_up(horizon)),
        queue_(1) {}

  // Replaces the horizon given to the constructor. Call before start().
  void end_at(const Rational& horizon) {
    horizon_ = horizon;
    horizon_up_ = round_up(horizon);
  }
  // Begins anew for the diagram as it is, with nothing known but maneuvers and horizon. `window`:
  // how far the first searches look ahead. `since`: when they begin.
  void start(double window, int disks, double since = 0) {
    frontier_ = since;
    look_ahead_ = LookAhead(window, since, horizon_up_,
                            static_cast<std::uint64_t>(diagram_.edges()), stats_.flip_searches);
    // A lone disk has no V-edge but meets the container all the same: one slot.
    slots_ = disks == 1 ? 1 : diagram_.edges();
    queue_ = EventQueue(items());
    found_.assign(items(), 0);
    isolating_.assign(items(), {});
    found_[horizon_item()] = is_event;
    set_key(horizon_item(), round_down(horizon_));
    queue_maneuver();
  }
  // Edges, or 1 for a lone disk, whose pair with the container is that of edge 0.
  int slots() const { return slots_; }
  std::pair<GenId, GenId> pair_of(int edge) const {
    if (diagram_.edges() == 0) return {container_id, 0};
    return std::minmax(diagram_.org(2 * edge), diagram_.dest(2 * edge));
  }
  // No maneuver is to come before this time.
  double quiet_until() const { return quiet_until_; }
  // The horizon, rounded up.
  double horizon_up() const { return horizon_up_; }
  // Every event before this time has been taken, or is due.
  double frontier() const { return frontier_; }

  // In a run that is told its collisions and maneuvers: the next instant that has any is that of
  // `turn`, which outlives it; null if there is none.
  void announce(const Moment* turn) {
    turn_ = turn;
    const int item = maneuver_item();
    found_[item] = turn != nullptr ? is_event : 0;
    set_key(item, turn == nullptr ? infinity : turn->lo);
  }
  // The item of maneuvers, or of the turn that was announced: those before it are of edges.
  int maneuver_item() const { return 2 * slots_; }
  bool is_turn(const FoundEvent& event) const { return event.item == maneuver_item(); }
  bool is_horizon(const FoundEvent& event) const { return event.item == horizon_item(); }

  // ---- Searches. The edge's state of knowledge is replaced. ----
  void search_flip_from_now(int edge) {
    const Stopwatch watch(profile_, stats_.flip_seconds);
    count_search();
    record(edge, arithmetic_.collapse_from_now(quad_of(edge), look_ahead_.end(now())));
  }
  // Searches as CollapseSearch::after() does.
  void search_flip_after(int edge, double start, const RootInterval* fine) {
    const Stopwatch watch(profile_, stats_.flip_seconds);
    count_search();
    record(edge, arithmetic_.collapse_after(quad_of(edge), start, look_ahead_.end(start), fine));
  }
  void search_contact(int edge) {
    const Stopwatch watch(profile_, stats_.collision_seconds);
    ++stats_.contact_searches;
    const auto [i, j] = pair_of(edge);
    record_contact(edge, arithmetic_.contact_from_now(i, j, horizon_up_));
  }

  // ---- The next instant: what next_instant() (engine/instant_order.h) asks of a source. ----
  // Works on until the head of the queue is an event; false if there is none.
  bool advance() {
    for (;;) {
      const int item = queue_.top();
      if (queue_.key(item) == infinity) return false;
      frontier_ = queue_.key(item);
      Patience::ask();
      if (is(is_event, item)) return true;
      extend(item);
    }
  }
  bool is_near(double bound) { return queue_.key(queue_.top()) <= bound; }
  std::optional<FoundEvent> take() {
    const int item = queue_.top();
    if (!is(is_event, item)) {
      extend(item);
      return std::nullopt;
    }
    queue_.set(item, infinity);
    return event_of(item);
  }
  void put_back(const FoundEvent& event) { queue_.set(event.item, event.lo); }
  // The horizon itself is over once its events are.
  void pass_horizon() { set_key(horizon_item(), horizon_up_); }

  // ---- What is due at the present instant. ----
  DueTurns& due_turns() { return due_turns_; }
  void make_due(const FoundEvent& event) {
    if (event.item >= maneuver_item()) {
      due_turns_.maneuvers |= !is_horizon(event);
      return;
    }
    if (event.is_flip()) {
      // Kept with its isolating interval: what follows the flip starts beyond it.
      found_[event.item] |= is_due;
      due_flips_.insert({canonical(event.quad), event.item / 2});
    } else {
      due_turns_.contacts.insert({event.i, event.j});
    }
    queue_.set(event.item, infinity);
  }
  void make_first_maneuvers_due() {
    due_turns_.maneuvers = maneuvers_.has_next() && sgn(maneuvers_.next_time()) == 0;
  }
  // The maneuvers of one instant, in the order of their disks. Precondition: they are due.
  std::vector<ManeuverInput> take_maneuvers() {
    std::vector<ManeuverInput> together = maneuvers_.take();
    queue_maneuver();
    return together;
  }
  // The next ones, of a run that goes on after them.
  std::vector<ManeuverInput> pass_maneuvers() {
    return maneuvers_.has_next() ? maneuvers_.take() : std::vector<ManeuverInput>();
  }
  // The edge with the smallest quadruplet.
  std::optional<int> take_due_flip() {
    if (due_flips_.empty()) return std::nullopt;
    return due_flips_.extract(due_flips_.begin()).value().second;
  }
  // The edge's flip may be due no more: it is to be searched anew.
  void forget_flip_of(int edge) {
    if (!is(is_due, flip_item(edge))) return;
    std::erase_if(due_flips_, [&](const auto& due) { return due.second == edge; });
    found_[flip_item(edge)] &= static_cast<std::uint8_t>(~is_due);
  }

  // The result of the search for this edge's flip, which is now dealt with.
  struct Root {
    bool isolated;  // if not, the flip was found due
    double hi;
    std::shared_ptr<const RootInterval> fine;
  };
  Root take_root(int edge) {
    const int item = flip_item(edge);
    Root root{is(is_event, item), isolating_[item].hi, fine_of(item)};
    found_[item] &= static_cast<std::uint8_t>(~is_due);
    return root;
  }

  [[gnu::always_inline]] void fetch_ahead(const Fetch& fetch) const {
    fetch.ahead(queue_, isolating_.data(), maneuver_item());
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // The result of the search for an item: bits of found_. Without is_event the item's key is only a
  // bound.
  static constexpr std::uint8_t is_event = 1;  // at a time that isolating_ isolates
  static constexpr std::uint8_t is_due = 2;    // a flip of the present instant: see due_flips_
  static constexpr std::uint8_t is_fine = 4;   // fine_ has the isolating interval
  bool is(std::uint8_t bit, int item) const { return (found_[item] & bit) != 0; }

  static int flip_item(int edge) { return 2 * edge; }
  static int contact_item(int edge) { return 2 * edge + 1; }
  int horizon_item() const { return 2 * slots_ + 1; }
  int items() const { return 2 * slots_ + 2; }

  double now() const { return arithmetic_.now().lo; }
  Quad quad_of(int edge) const { return diagram_.quad(2 * edge); }
  std::shared_ptr<const RootInterval> fine_of(int item) const {
    return is(is_fine, item) ? fine_.at(item / 2) : nullptr;
  }

  FoundEvent event_of(int item) const {
    if (item == horizon_item()) return {Moment::at(horizon_), item};
    if (item == maneuver_item()) {
      return {turn_ != nullptr ? *turn_ : Moment::at(maneuvers_.next_time()), item};
    }
    const auto [lo, hi] = isolating_[item];
    if ((item & 1) == 0) return {Moment::of(quad_of(item / 2), lo, hi, fine_of(item)), item};
    const auto [i, j] = pair_of(item / 2);
    return {Moment::of(i, j, lo, hi), item};
  }

  void set_key(int item, double key) {
    const Stopwatch watch(profile_, stats_.queue_seconds);
    queue_.set(item, key);
  }
  void queue_maneuver() {
    found_[maneuver_item()] = maneuvers_.has_next() ? is_event : 0;
    quiet_until_ = maneuvers_.next_down();
    set_key(maneuver_item(), quiet_until_);
  }

  void record(int edge, const Collapse& c) {
    const int item = flip_item(edge);
    if (is(is_fine, item)) fine_.erase(edge);
    found_[item] = 0;
    switch (c.kind) {
      case Collapse::Kind::none:
        set_key(item, c.lo >= horizon_up_ ? infinity : c.lo);
        break;
      case Collapse::Kind::root:
        ++stats_.predicted_flips;
        isolating_[item] = {c.lo, c.hi};
        found_[item] = c.fine ? is_event | is_fine : is_event;
        if (c.fine) fine_[edge] = c.fine;
        set_key(item, c.lo);
        break;
      case Collapse::Kind::now:
        ++stats_.predicted_flips;
        found_[item] = is_due;
        due_flips_.insert({canonical(quad_of(edge)), edge});
        set_key(item, infinity);
        break;
    }
  }
  void record_contact(int edge, const NextContact& c) {
    const int item = contact_item(edge);
    found_[item] = 0;
    switch (c.kind) {
      case NextContact::Kind::none:
        set_key(item, infinity);
        break;
      case NextContact::Kind::at:
        ++stats_.predicted_collisions;
        isolating_[item] = {c.lo, c.hi};
        found_[item] = is_event;
        set_key(item, c.lo);
        break;
      case NextContact::Kind::now:
        ++stats_.predicted_collisions;
        due_turns_.contacts.insert(pair_of(edge));
        set_key(item, infinity);
        break;
    }
  }

  void count_search() { look_ahead_.count(++stats_.flip_searches, frontier_); }

  // Looks further ahead for an item of which only a bound is known.
  void extend(int item) { search_flip_after(item / 2, queue_.key(item), nullptr); }

  const Diagram& diagram_;
  Arithmetic& arithmetic_;
  EngineStats& stats_;
  bool profile_;
  Maneuvers maneuvers_;
  Rational horizon_;
  double horizon_up_;
  EventQueue queue_;
  const Moment* turn_ = nullptr;  // see announce()
  int slots_ = 0;
  std::vector<std::uint8_t> found_;   // by item
  std::vector<Enclosure> isolating_;  // for flips and contacts that were found
  std::unordered_map<int, std::shared_ptr<const RootInterval>> fine_;  // by edge
  double quiet_until_ = 0;
  LookAhead look_ahead_;
  double frontier_ = 0;
  std::set<std::pair<Quad, int>> due_flips_;
  DueTurns due_turns_;
};

}  // namespace voroproof::internal
