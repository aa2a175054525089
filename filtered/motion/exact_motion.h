// The motion of the disks, exactly.
#pragma once

#include <unordered_map>
#include <utility>

#include "exact/generators.h"
#include "exact/predicates.h"
#include "exact/rational.h"
#include "exact/tower.h"
#include "filtered/motion/motion.h"

namespace voroproof::internal {

// Exact states of the disks of a Motion as it stands, in a tower of quadratic
// fields over the rationals: what proves equalities. Throws BudgetExceeded where the tower would
// need more radicals or larger coefficients than the budget allows. Valid until the Motion changes.
class ExactMotion {
 public:
  struct State {
    Rational t_ref;
    Tower x, y, vx, vy;
  };
  explicit ExactMotion(const Motion& motion);

  // State in force of a generator (the container rests).
  const State& state(GenId g);
  // The state with a given id (Motion::state_id), of generator g.
  const State& state(int id, GenId g);
  // The time of the collision or maneuver at which a state began; 0 for an initial one.
  const Tower& start(int id, GenId g);
  Tower radius(GenId g) const;  // signed
  RadicalField& field() { return field_; }
  MovingSite<Tower> moving_site(GenId g, const Rational& t);
  Site<Tower> site(GenId g, const Tower& t);

  // For Motion::compute_exactly(): what is known, and another state.
  bool knows(int id, GenId g) const { return memo_.contains(key(id, g)); }
  void note(int id, GenId g, State state, Tower start) {
    memo_[key(id, g)] = {std::move(state), std::move(start)};
  }

 private:
  struct Entry {
    State state;
    Tower start;
  };
  long key(int id, GenId g) const;
  const Entry& entry(int id, GenId g);
  const Motion& motion_;
  RadicalField field_;
  std::unordered_map<long, Entry> memo_;
};

}  // namespace voroproof::internal
