// The states of moving disks in as many bits as the rest of a run needs, and the log of what
// changed them.
//
// The log of collisions and maneuvers is the expression graph of every state: to get more bits it
// is applied anew at a higher precision; no search is repeated.
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "exact/ball.h"
#include "exact/generators.h"
#include "exact/rational.h"
#include "filtered/computed/fixed_collision.h"
#include "filtered/computed/motion_log.h"
#include "filtered/motion/motion.h"
#include "filtered/numbers/dd_ball.h"

namespace voroproof::internal {

// Records are appended, then applied to the states: at once, or in states that follow others when
// somebody asks. What tells of states is of the records applied so far.
class MotionStates {
 public:
  // `input`: about the container's centre; outlives these states. `log`: empty and nobody else's,
  // or that of other states of the same input, which these follow().
  MotionStates(const MotionInput& input, const MotionOptions& options,
               std::shared_ptr<MotionLog> log);
  MotionStates(const MotionStates&) = delete;
  MotionStates& operator=(const MotionStates&) = delete;

  using Maneuver = MotionLog::Maneuver;
  using Record = MotionLog::Record;
  // The records so far, oldest first.
  std::size_t size_of_log() const { return size_; }
  const Record& record(std::size_t k) const { return log_->record(k); }
  const Maneuver& maneuver(int index) const { return log_->maneuver(index); }
  const std::shared_ptr<MotionLog>& log() const { return log_; }

  void append(const Record& r) {
    log_->append(r);
    ++size_;
  }
  // The log has another record that is to be applied, made by others. `v_scale`: of their states.
  void follow(std::int64_t v_scale) {
    ++size_;
    v_scale_ = v_scale;
  }
  // The states of two generators that the last record has left.
  struct After;
  After after(GenId i, GenId j);
  // Where these states follow, and all before is applied: the record is applied, too, if what
  // after() told of it is as accurate as that makes it. `states` outlive these.
  void follow(GenId i, GenId j, const After& states);
  // All states after the records so far. They stay as they are: since then those that change are
  // made anew.
  struct Snapshot;
  Snapshot snapshot();
  // The same, and as accurate as these states, which may be used by one thread and this by another:
  // wherever all records are applied anew, it is made anew.
  class LastingSnapshot;
  std::shared_ptr<LastingSnapshot> lasting_snapshot();
  // These states, which follow() others, are as those were then.
  void follow(const Snapshot& then);
  // Adds the maneuver; returns its index, for a record.
  int append(Maneuver m);

  // Applies all records. Raises the supply of bits where the states after a collision are not
  // accurate enough. Throws Undecided where that would exceed the budget.
  void apply_rest();
  // Applies all records anew, for states known to twice as many bits. False when the budget is
  // exhausted.
  bool raise_goal();

  int highest_bits() const { return bits_at(0); }
  // How often all records have been applied anew.
  std::uint64_t replays() const { return replays_; }

  // The present goal: every state is known to at least this many bits below the scale of the
  // scene.
  int goal_bits() const { return bits_.goal; }
  int bits_at(double t) const { return bits_.at(t); }
  // The scales of lengths and of speeds are 2 to these powers.
  std::int64_t x_scale() const { return x_scale_; }
  std::int64_t v_scale() const { return v_scale_; }

  template <class T>
  using State = MotionState<T>;
  // The state of g, whose reference time is t_ref; its balls have the precision of that time.
  const State<Ball>& balls(GenId g, double t_ref) const;
  State<DdBall> double_doubles(GenId g) const;
  // The time of the collision applied last, and its delay after the reference time.
  DdBall last_time() const { return collision_.time(); }
  DdBall last_delay() const { return collision_.delay(); }
  Ball last_time_ball() const { return collision_.time_ball(bits_at(0)); }
  Ball last_delay_ball() const { return collision_.delay_ball(bits_at(0)); }

 private:
  int integer_limbs() const;
  void begin();
  void set_laws();
  const DiskInput& initial_state(GenId g) const {
    return g == container_id ? container_ : input_.disks[g];
  }
  FixedCollision::Side side_of(GenId g, double t_ref) const;
  void apply(const Record& r);
  void apply_maneuver(const Record& r);
  void respond(const Record& r);
  bool is_accurate_enough(const Record& r) const;
  void replay();
  Snapshot states_after(std::size_t records) const;
  bool raise_for(double t);

  const MotionInput& input_;
  DiskInput container_;  // at rest; its radius is positive here
  BitSupply bits_;
  std::int64_t x_scale_ = 0, v_scale_ = 0;  // exponents
  std::int64_t reach_scale_ = 0;            // exponent of the least reach
  std::uint64_t replays_ = 0;
  std::shared_ptr<MotionLog> log_;
  std::size_t size_ = 0;        // length of the log, as far as these states go
  std::size_t applied_ = 0;     // records
  std::exception_ptr failure_;  // from a state that could not be computed: none can be since
  // The states of generators whose last change was a collision; null of all others.
  std::vector<std::shared_ptr<FixedState>> fixed_;
  // States in balls: those after a maneuver, others from when they are asked for.
  mutable std::vector<std::shared_ptr<State<Ball>>> balls_;
  bool are_shared_ = false;                              // the states, with snapshots
  std::vector<std::weak_ptr<LastingSnapshot>> lasting_;  // oldest first
  CollisionFactors laws_;
  FixedCollision collision_;
};

// They are not changed any more.
struct MotionStates::After {
  struct One {
    std::shared_ptr<FixedState> fixed;
    std::shared_ptr<State<Ball>> balls;
  };
  One first, second;
  int goal_bits = 0;
};

struct MotionStates::Snapshot {
  std::vector<std::shared_ptr<FixedState>> fixed;
  std::vector<std::shared_ptr<State<Ball>>> balls;
  std::size_t records = 0;
  int goal_bits = 0;
  double slope = 0;
  int reserve = 0;
  std::int64_t v_scale = 0;
};

class MotionStates::LastingSnapshot {
 public:
  explicit LastingSnapshot(Snapshot then) : records_(then.records), then_(std::move(then)) {}
  Snapshot get() const {
    const std::lock_guard lock(mutex_);
    return then_;
  }

 private:
  friend MotionStates;
  void set(Snapshot then) {
    const std::lock_guard lock(mutex_);
    then_ = std::move(then);
  }

  const std::size_t records_;
  mutable std::mutex mutex_;
  Snapshot then_;
};

}  // namespace voroproof::internal
