// How one motion follows another: by its enclosures, by its states at some time, and by the log of
// what has changed them since. States beyond double-doubles are computed from these when they are
// asked for, which is seldom.
#include "filtered/computed/computed_motion.h"

namespace voroproof::internal {

MotionStates::Snapshot MotionStates::snapshot() {
  apply_rest();
  are_shared_ = true;
  return states_after(size_);
}

MotionStates::After MotionStates::after(GenId i, GenId j) {
  apply_rest();
  are_shared_ = true;
  const auto one = [this](GenId g) { return After::One{fixed_[g + 1], balls_[g + 1]}; };
  return {one(i), one(j), bits_.goal};
}

void MotionStates::follow(GenId i, GenId j, const After& states) {
  if (applied_ + 1 != size_ || states.goal_bits < bits_.goal) return;
  const auto take = [this](GenId g, const After::One& one) {
    if (g == container_id) return;
    // To count references would cost more than all else here.
    const std::shared_ptr<void> nobody;
    fixed_[g + 1] = {nobody, one.fixed.get()};
    balls_[g + 1] = {nobody, one.balls.get()};
  };
  take(i, states.first);
  take(j, states.second);
  ++applied_;
}

MotionStates::Snapshot MotionStates::states_after(std::size_t records) const {
  return {fixed_, balls_, records, bits_.goal, bits_.slope, bits_.reserve, v_scale_};
}

std::shared_ptr<MotionStates::LastingSnapshot> MotionStates::lasting_snapshot() {
  std::erase_if(lasting_, [](const auto& snapshot) { return snapshot.expired(); });
  const auto snapshot = std::make_shared<LastingSnapshot>(this->snapshot());
  lasting_.push_back(snapshot);
  return snapshot;
}

void MotionStates::follow(const Snapshot& then) {
  are_shared_ = true;
  fixed_ = then.fixed;
  balls_ = then.balls;
  size_ = applied_ = then.records;
  bits_.goal = then.goal_bits;
  bits_.slope = then.slope;
  bits_.reserve = then.reserve;
  v_scale_ = then.v_scale;
  failure_ = nullptr;
  set_laws();
}

MotionSnapshot ComputedMotion::snapshot() {
  return {state_, doubles_, seconds_, states_->snapshot()};
}

TurnedState ComputedMotion::turned(GenId g) const {
  const DoubleMotion& m = doubles(g);
  const SecondMotion& s = seconds(g);
  return {m.t, m.x, m.y, m.vx, m.vy, s.x, s.y, s.vx, s.vy, s.ex, s.ev};
}

LedTurn ComputedMotion::led(GenId i, GenId j, const RoundedState& first,
                            const RoundedState& second) const {
  return {i, j, turned(i), turned(j), first, second, v_scale()};
}

void ComputedMotion::follow(const MotionSnapshot& then) {
  state_ = then.states;
  doubles_ = then.doubles;
  seconds_ = then.seconds;
  states_->follow(then.full);
}

void ComputedMotion::believe(const MotionFacts& facts) {
  relations_ = facts.relations;
  rational_ = facts.rational;
}

void ComputedMotion::take(GenId g, const TurnedState& s) {
  state_[g + 1] = records();
  doubles_[g + 1].t = s.t;
  set_state(g, {{s.x, s.x2, s.ex}, {s.y, s.y2, s.ex}, {s.vx, s.vx2, s.ev}, {s.vy, s.vy2, s.ev}});
}

void ComputedMotion::follow(GenId i, const TurnedState& first, GenId j, const TurnedState& second,
                            std::int64_t v_scale) {
  states_->follow(v_scale);
  if (i != container_id) take(i, first);
  if (j != i) take(j, second);
}

}  // namespace voroproof::internal
