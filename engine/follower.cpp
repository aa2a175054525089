#include "engine/follower.h"

#include <algorithm>
#include <cmath>

#include "engine/static_diagram.h"
#include "exact/patience.h"

namespace voroproof::internal {

namespace {

double mean_speed(const Motion& motion) {
  double sum = 0;
  for (GenId g = 0; g < motion.size(); ++g) {
    sum += std::hypot(motion.doubles(g).vx, motion.doubles(g).vy);
  }
  return sum / motion.size();
}

}  // namespace

Follower::Follower(ComputedMotion& motion, double begin, bool profile)
    : motion_(motion),
      begin_(begin),
      profile_(profile),
      diagram_(motion.size()),
      arithmetic_(motion, stats_),
      schedule_(diagram_, arithmetic_, stats_, profile, {}, motion.input().horizon),
      instant_(0),
      flipping_(diagram_, motion, arithmetic_, schedule_, instant_, stats_),
      fetch_(diagram_, motion),
      turn_(FoundEvent::Kind::contact, 0) {}

void Follower::construct() {
  const Stopwatch watch(profile_, stats_.initial_seconds);
  const Rational begin = to_rational(begin_);
  arithmetic_.is_at(begin);
  diagram_ = static_diagram(motion_, begin, stats_.tiers);
  flipping_.start();
}

void Follower::settle(const LedTurns& turns, const Rational& end) {
  turns_ = &turns;
  is_last_ = end == motion_.input().horizon;
  schedule_.end_at(end);
  // Long before a slice begins some disks may have become much faster than others.
  schedule_.start(window_at_speed(motion_, mean_speed(motion_)), motion_.size(), begin_);
  if (begin_ == 0) process_turns();
  stats_.settling_flips = arithmetic_.settle(diagram_);
}

// The schedule is told of the next instant that turns.
void Follower::announce() {
  if (next_ == turns_->size()) {
    schedule_.announce(nullptr);
    return;
  }
  const LedTurns::Instant& next = turns_->instant(next_);
  turn_ = FoundEvent(
      next.exactly == nullptr ? FoundEvent::Kind::contact : FoundEvent::Kind::maneuver, 0);
  turn_.exactly = next.exactly;
  if (next.exactly == nullptr) {
    const LedTurns::Contact& first = turns_->first_contact(next_);
    turn_.i = first.i;
    turn_.j = first.j;
    turn_.at = first.at;
  }
  schedule_.announce(&turn_);
}

// One instant; false if it is the end of the slice and has no event, or there is none.
bool Follower::step() {
  Patience::ask();
  if (at_horizon_ || !schedule_.next_instant(ties_)) return false;
  const TimedEvent first = ties_.front();
  if (first.event.exactly == nullptr && !schedule_.is_turn(first.event)) {
    fetch_.around_edge(first.event.item & ~1);
  }
  schedule_.fetch_ahead(fetch_);
  bool turns = false;
  for (const TimedEvent& timed : ties_) {
    turns |= schedule_.is_turn(timed.event);
    at_horizon_ |= timed.event.kind == FoundEvent::Kind::horizon;
  }
  // The leader has counted the tie of its turns with the horizon; a border is no event.
  if (at_horizon_ && ties_.size() > 1 && (turns || !is_last_)) --stats_.ties;
  if (turns) {
    // Add the contacts that the leader has proved simultaneous. The schedule does not know them.
    turns_->each_contact(next_, [&](const LedTurns::Contact& c) {
      if (c.i == turn_.i && c.j == turn_.j && turn_.is_contact()) return;
      FoundEvent contact(FoundEvent::Kind::contact, 0);
      contact.i = c.i;
      contact.j = c.j;
      contact.at = c.at;
      ties_.push_back(arithmetic_.rough(contact));
    });
  }
  arithmetic_.begin(ties_);
  if (!turns && ties_.size() == 1) {
    if (at_horizon_) return false;
    instant_.set_time(arithmetic_.rounded(first));
    flipping_.process(first.event.item / 2);
  } else {
    for (const TimedEvent& timed : ties_) {
      if (timed.event.is_flip()) schedule_.make_due(timed.event);
    }
    if (turns) {
      process_turns();
    } else {
      instant_.set_time(arithmetic_.rounded(first));
    }
  }
  while (const std::optional<int> edge = schedule_.take_due_flip()) flipping_.process(*edge);
  return true;
}

void Follower::process_turns() {
  const LedTurns::Instant& instant = turns_->instant(next_);
  instant_.set_time(instant.t);
  bool maneuvers = false;
  turns_->each_turn(next_, [&](const LedTurn& turn) {
    if (turn.i == turn.j) {
      if (!std::exchange(maneuvers, true)) arithmetic_.is_at(*instant.exactly);
      ++stats_.maneuvers;
      instant_.add_maneuver(turn.i, turn.rounded_first);
    } else {
      ++(turn.i == container_id ? stats_.wall_collisions : stats_.disk_collisions);
      instant_.add_collision(turn.i, turn.j, turn.rounded_first, turn.rounded_second);
    }
    arithmetic_.follow(turn, instant.tells_time ? &instant.time : nullptr);
    for (const GenId g : {turn.i, turn.j}) {
      if (g == container_id) continue;
      if (std::find(changed_.begin(), changed_.end(), g) == changed_.end()) changed_.push_back(g);
    }
  });
  arithmetic_.after_changes();
  flipping_.next_change();
  for (const GenId g : changed_) search_around(g);
  changed_.clear();
  ++next_;
  if (flipping_.begun()) announce();
}

void Follower::search_around(GenId g) {
  const Diagram::HalfEdge first = diagram_.anchor(g);
  if (first < 0) return;
  fetch_.around_cell(first);
  Diagram::HalfEdge h = first;
  do {
    flipping_.search_once(h / 2);
    flipping_.search_once(diagram_.next(h) / 2);
    h = diagram_.rotate(h);
  } while (h != first);
}

}  // namespace voroproof::internal
