// Motion that is given and not computed: each disk is on the line that it was put on last.
#pragma once

#include <memory>
#include <vector>

#include "filtered/motion/motion.h"

namespace voroproof::internal {

// Tells the exact states of disks whose motion is given.
class GivenStates {
 public:
  virtual ~GivenStates() = default;
  // Centre and velocity of disk g when it was last restarted: sets x, y, vx and vy.
  virtual void state(GenId g, DiskInput& disk) const = 0;
};

class GivenMotion final : public Motion {
 public:
  GivenMotion(MotionInput input, MotionOptions options);

  // From now on disk g moves as if it had been at (x, y) of the scene at time t, with that
  // velocity.
  void restart(GenId g, const Rational& t, const Rational& x, const Rational& y, const Rational& vx,
               const Rational& vy);
  // Restarts disk g from enclosures of x and y. The exact state is asked of `given` if it is ever
  // needed; `given` must be at hand until the disk is restarted.
  void restart(GenId g, double t, const DdBall& x, const DdBall& y, double vx, double vy,
               const GivenStates& given);
  // Asks for the memory of what restart() changes besides that of prefetch().
  [[gnu::always_inline]] void prefetch_restart(GenId g) const {
    internal::prefetch(&seconds_[g + 1]);
    internal::prefetch(&given_[g]);
    internal::prefetch(&balls_[g + 1]);
  }

  bool raise_precision() override;
  int goal_bits() const override { return bits_.goal; }
  int highest_bits() const override { return bits_.at(0); }
  const DiskInput& initial_state(GenId g) const override;
  double initial_time(GenId g) const override { return doubles(g).t; }
  // Whether there are more bits than at first.
  bool is_raised() const { return is_raised_; }

 private:
  const MotionState<Ball>& balls(GenId g) const override;

  BitSupply bits_;
  bool is_raised_ = false;
  // By disk: where its state is yet to be taken over from, or null.
  mutable std::vector<const GivenStates*> given_;
  mutable std::vector<std::unique_ptr<MotionState<Ball>>> balls_;  // those asked for
};

}  // namespace voroproof::internal
