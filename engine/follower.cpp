#include "engine/follower.h"

#include <cmath>

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

void Follower::construct() {
  const Stopwatch watch(profile_, stats_.initial_seconds);
  Run::construct(begin_);
}

void Follower::settle(const LedTurns& turns, const Rational& end) {
  turns_ = &turns;
  is_last_ = end == motion_.input().horizon;
  schedule_.end_at(end);
  // Long before a slice begins some disks may have become much faster than others.
  schedule_.start(window_at_speed(motion_, mean_speed(motion_)), motion_.size(), begin_);
  if (begin_ == 0) follow_turns();
  stats_.settling_flips = arithmetic_.settle(diagram_);
}

// The schedule is told of the next instant that turns.
void Follower::announce() {
  if (next_ == turns_->size()) {
    schedule_.announce(nullptr);
    return;
  }
  const LedTurns::Instant& next = turns_->instant(next_);
  turn_ =
      next.exactly != nullptr ? Moment::at(*next.exactly) : turns_->first_contact(next_).moment();
  schedule_.announce(&turn_);
}

void Follower::begin_instant() {
  turns_now_ = false;
  for (const FoundEvent& event : ties_) {
    turns_now_ |= schedule_.is_turn(event);
    at_horizon_ |= schedule_.is_horizon(event);
  }
  // The leader has counted the tie of its turns with the horizon; a border is no event.
  if (at_horizon_ && ties_.size() > 1 && (turns_now_ || !is_last_)) --stats_.ties;
  if (!turns_now_) return;
  // Add the contacts that the leader has proved simultaneous. The schedule does not know them.
  turns_->each_contact(next_, [&](const LedTurns::Contact& c) {
    if (c.i == turn_.i && c.j == turn_.j && turn_.is_contact()) return;
    ties_.emplace_back(c.moment(), schedule_.maneuver_item());
  });
}

void Follower::follow_turns() {
  const LedTurns::Instant& instant = turns_->instant(next_);
  instant_.set_time(instant.t);
  bool maneuvers = false;
  turns_->each_turn(next_, [&](const LedTurn& turn) {
    if (turn.i == turn.j) {
      if (!std::exchange(maneuvers, true)) arithmetic_.is_at(Moment::at(*instant.exactly));
      ++stats_.maneuvers;
      instant_.add_maneuver(turn.i, turn.rounded_first);
    } else {
      ++(turn.i == container_id ? stats_.wall_collisions : stats_.disk_collisions);
      instant_.add_collision(turn.i, turn.j, turn.rounded_first, turn.rounded_second);
    }
    arithmetic_.follow(turn, instant.tells_time ? &instant.time : nullptr);
    note_turn(turn.i);
    note_turn(turn.j);
  });
  settle_turns();
  ++next_;
  if (flipping_.begun()) announce();
}

}  // namespace voroproof::internal
