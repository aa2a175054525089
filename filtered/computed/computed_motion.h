// Motion that is computed: collisions and maneuvers, of which each state is known to as many bits
// as the rest of a run needs, and exactly; or the same of another motion, followed.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "exact/rational.h"
#include "filtered/computed/collision_relations.h"
#include "filtered/computed/motion_states.h"
#include "filtered/motion/motion.h"

namespace voroproof::internal {

// A disk's state just after a collision or maneuver, rounded to nearest, in the coordinates of the
// scene.
struct RoundedState {
  double px, py, vx, vy;
};

// A disk's state after a collision or maneuver, as the one that computed it knows it: enclosures as
// those of DoubleMotion and SecondMotion, referred to t.
struct TurnedState {
  double t, x, y, vx, vy;
  double x2, y2, vx2, vy2;
  double ex, ev;
};

// A collision of i < j, or a maneuver of i = j, for motions that follow this one: the states after
// it, and these as a history says them. Nothing is said of the container's.
struct LedTurn {
  GenId i, j;
  TurnedState first, second;
  RoundedState rounded_first, rounded_second;
  std::int64_t v_scale;  // ComputedMotion::v_scale() after it
};

// An exact state that came about without a radical.
struct RationalState;

// Facts about the states of a motion so far that were expensive to find out.
struct MotionFacts {
  CollisionRelations relations;
  std::vector<std::shared_ptr<const RationalState>> rational;
};

// All states of a motion at some time.
struct MotionSnapshot {
  std::vector<int> states;  // Motion::state_id(), of all generators
  std::vector<DoubleMotion> doubles;
  std::vector<SecondMotion> seconds;
  MotionStates::Snapshot full;
};

struct Impact {
  double t;         // the collision time, rounded to nearest
  DoubleBall time;  // enclosures of it
  DdBall time_dd;
  RoundedState first, second;  // second is unused for the container
};

class ComputedMotion final : public Motion {
 public:
  ComputedMotion(MotionInput input, MotionOptions options)
      : ComputedMotion(std::move(input), options, std::make_shared<MotionLog>()) {}
  // A motion that follows another one of the same input, which it does not refer to: it takes its
  // collisions and maneuvers over, by follow(), in place of computing them, and reads their log.
  ComputedMotion(MotionInput input, MotionOptions options, std::shared_ptr<MotionLog> log);

  // Processes the contact of i and j (i < j, i may be the container) that lies
  // next to the double t_near and which the caller has proved to be their next
  // contact. Changes both states.
  Impact collide(GenId i, GenId j, double t_near);
  // Gives disk g a new velocity at an exact time; returns its rounded state.
  RoundedState maneuver(GenId g, const Rational& t, const Rational& vx, const Rational& vy);

  // The log and the snapshot that another motion needs to follow this one.
  const std::shared_ptr<MotionLog>& log() const { return states_->log(); }
  MotionSnapshot snapshot();
  std::shared_ptr<MotionStates::LastingSnapshot> lasting_states() {
    return states_->lasting_snapshot();
  }
  MotionFacts facts() const { return {relations_, rational_}; }
  TurnedState turned(GenId g) const;
  // The last turn, which left these rounded states; of a maneuver both are one.
  LedTurn led(GenId i, GenId j, const RoundedState& first, const RoundedState& second) const;
  // The states that the last turn has left, in all bits.
  MotionStates::After after(GenId i, GenId j) { return states_->after(i, j); }
  std::int64_t v_scale() const { return states_->v_scale(); }
  // This motion, which follows another, is as that one was then.
  void follow(const MotionSnapshot& then);
  // Believes the facts, which are of the other motion, of its states up to then.
  void believe(const MotionFacts& facts);
  // The next record of the other motion, after which i < j, or i alone if j = i, were in these
  // states. Nothing is said of the container's.
  void follow(GenId i, const TurnedState& first, GenId j, const TurnedState& second,
              std::int64_t v_scale);
  // The same; `states`, which outlive this motion: what after() has told of it.
  void follow(const LedTurn& turn, const MotionStates::After& states) {
    follow(turn.i, turn.first, turn.j, turn.second, turn.v_scale);
    states_->follow(turn.i, turn.j, states);
  }

  std::uint64_t replays() const { return states_->replays(); }

  // How the state of disk g with an id > 0 came about: from its state `before`, by a maneuver or
  // by a collision with the partner, whose state before that is given.
  struct Origin {
    int before;
    const MotionStates::Maneuver* maneuver;  // or null; valid until the motion changes
    GenId partner;
    int partner_before;
  };
  Origin origin(GenId g, int id) const;
  // The two generators of the collision with this id, the smaller first; a maneuver's disk twice.
  std::pair<GenId, GenId> generators_of(int id) const {
    const Record& r = states_->record(id - 1);
    return {r.i, r.j};
  }
  // The proved relations of the collisions so far.
  const CollisionRelations& relations() const { return relations_; }
  CollisionRelations& relations() { return relations_; }

  bool raise_precision() override;
  int goal_bits() const override { return states_->goal_bits(); }
  int highest_bits() const override { return states_->highest_bits(); }
  bool is_rational(GenId g) const override;
  void compute_exactly(int id, GenId g, ExactMotion& exact) const override;
  std::shared_ptr<const Symmetry> symmetry() const override;
  int records() const override { return static_cast<int>(states_->size_of_log()); }
  void note_relations(int records, double lo, double hi) override;

 private:
  using Record = MotionStates::Record;

  const MotionState<Ball>& balls(GenId g) const override {
    states_->apply_rest();
    return states_->balls(g, doubles(g).t);
  }
  void compute_exactly(int record, ExactMotion& exact) const;
  bool is_known(int id, GenId g, ExactMotion& exact) const;
  void remember(int id, GenId g, ExactMotion& exact) const;
  void refresh(GenId g) { set_state(g, states_->double_doubles(g)); }
  void take(GenId g, const TurnedState& s);
  void append(const Record& r);
  // A coordinate of a centre as the scene has it.
  DdBall in_scene(const DdBall& x, int axis) const { return moved_ ? x + origin_[axis] : x; }
  double round_coordinate(const DdBall& rough, GenId g, int which);

  std::unique_ptr<MotionStates> states_;
  CollisionRelations relations_;
  // The last exact state of each generator that was asked for and came about without a radical.
  mutable std::vector<std::shared_ptr<const RationalState>> rational_;
};

}  // namespace voroproof::internal
