// The motion of the disks: piecewise linear, known at several precisions at once.
//
// Between its turns a disk moves on a line, so its motion is a state (centre and velocity at a
// reference time). All know it as doubles and double-doubles with error bounds, for the filters.
// Where it comes from is the subject of two others: GivenMotion is told it, ComputedMotion
// (filtered/computed/) makes collisions and maneuvers. These have balls and exact states, too.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "exact/ball.h"
#include "exact/generators.h"
#include "exact/predicates.h"
#include "exact/prefetch.h"
#include "exact/rational.h"
#include "filtered/motion/options.h"
#include "filtered/numbers/dd_ball.h"
#include "filtered/numbers/double_ball.h"

namespace voroproof::internal {

class ExactMotion;
class Symmetry;

// Motion of one generator in doubles: centre (x, y) at time t, velocity, signed
// radius; the true centre at t is within ex of (x, y) in each coordinate, the true
// radius within ex of r, the true velocity within ev. One line of the caches: nearly
// everything that is decided begins with four of these.
struct alignas(64) DoubleMotion {
  double t = 0, x = 0, y = 0, vx = 0, vy = 0, r = 0;
  double ex = 0, ev = 0;
};

// The differences of the true values from those doubles, to make double-doubles of them: the true
// centre is within ex of (x, y) + (this x, y) and so on.
struct alignas(64) SecondMotion {
  double x = 0, y = 0, vx = 0, vy = 0, r = 0;
  double ex = 0, ev = 0, er = 0;
};

// A disk's motion in double-doubles.
struct DdMotion {
  DdBall x, y, vx, vy, r;
};

// Centre and velocity at a reference time that is known from elsewhere.
template <class T>
struct MotionState {
  T x, y, vx, vy;
};

class Motion {
 public:
  virtual ~Motion() = default;

  int size() const { return static_cast<int>(input_->disks.size()); }
  // The input, about the container's centre, as all coordinates of a motion are but those of a
  // RoundedState and of what is given. Where the motion of a disk is given, its centre and velocity
  // here may be those of another time: see initial_state().
  const MotionInput& input() const { return *input_; }
  const MotionOptions& options() const { return options_; }

  const DoubleMotion& doubles(GenId g) const { return doubles_[g + 1]; }
  // Asks for the memory of doubles() and state_id().
  [[gnu::always_inline]] void prefetch(GenId g) const {
    internal::prefetch(&doubles_[g + 1]);
    internal::prefetch(&state_[g + 1]);
  }
  const SecondMotion& seconds(GenId g) const { return seconds_[g + 1]; }
  // doubles(g) and seconds(g) together, referred to the time of doubles(g).
  DdMotion double_doubles(GenId g) const {
    const DoubleMotion& m = doubles(g);
    const SecondMotion& s = seconds(g);
    return {{m.x, s.x, s.ex}, {m.y, s.y, s.ex}, {m.vx, s.vx, s.ev}, {m.vy, s.vy, s.ev}, radius(g)};
  }
  // Whether every radius is a binary64.
  bool radii_are_doubles() const { return radii_are_doubles_; }
  DdBall radius(GenId g) const { return {doubles(g).r, seconds(g).r, seconds(g).er}; }
  // Position at a time in the current motion of the generator.
  Site<DoubleBall> site(GenId g, const DoubleBall& t) const;
  Site<DdBall> site(GenId g, const DdBall& t) const;
  Site<Ball> site(GenId g, const Ball& t) const;
  MovingSite<DoubleBall> moving_site(GenId g, const DoubleBall& t) const;
  MovingSite<DdBall> moving_site(GenId g, const DdBall& t) const;
  MovingSite<Ball> moving_site(GenId g, const Ball& t) const;

  // Whether two generators certainly have the same velocity (identical exact
  // values), so that their offset never changes.
  bool same_velocity(GenId a, GenId b) const;

  // The state in force: -1 - g for the initial one or a given one, else one more than its record's
  // index in the log of collisions and maneuvers.
  int state_id(GenId g) const { return state_[g + 1]; }

  // ---- Seldom asked for. ----
  // Asks for more bits in all states. False when the budget (max_bits) is exhausted.
  virtual bool raise_precision() = 0;
  // The present goal: every state is known to at least this many bits below the
  // scale of the scene.
  virtual int goal_bits() const = 0;
  virtual int highest_bits() const = 0;
  // Whether the present motion of g is rational for certain: no collision is in its past.
  virtual bool is_rational(GenId) const { return true; }
  // Disk g with the centre and the velocity of its initial state, or as it was given last; and the
  // time of that.
  virtual const DiskInput& initial_state(GenId g) const { return input_->disks[g]; }
  virtual double initial_time(GenId) const { return 0; }
  // Notes in `exact` the state of g with an id > 0, and those that it comes of.
  virtual void compute_exactly(int, GenId, ExactMotion&) const {}
  // Proofs of equality by the pasts of disks (filtered/search/symmetry.h); null where these
  // have none.
  virtual std::shared_ptr<const Symmetry> symmetry() const { return nullptr; }
  // The collisions and maneuvers so far.
  virtual int records() const { return 0; }
  // Looks at those after the first `records`, all of one instant between lo and hi, for what they
  // have to do with each other.
  virtual void note_relations(int, double, double) {}

 protected:
  Motion(MotionInput input, MotionOptions options);
  Motion(Motion&&) = default;
  Motion& operator=(Motion&&) = default;

  // The state in force in balls of the precision of its time.
  virtual const MotionState<Ball>& balls(GenId g) const = 0;

  void set_state(GenId g, const MotionState<DdBall>& s);
  void set_initial_state(GenId g);

  std::unique_ptr<MotionInput> input_;
  MotionOptions options_;
  std::vector<int> state_;  // per generator
  std::vector<DoubleMotion> doubles_;
  std::vector<SecondMotion> seconds_;
  std::array<DdBall, 2> origin_;  // origin of the input
  bool moved_ = false;            // the origin is not that of the scene

 private:
  Ball radius_ball(GenId g, Ball::Precision bits) const;
  void set_radius(GenId g, const DdBall& r);

  bool radii_are_doubles_ = true;
};

// The bits of balls. States are known to a goal, and held with headroom, which the last few turns
// before the horizon may use up; those of earlier ones have a supply for what is to come.
struct BitSupply {
  BitSupply(const MotionOptions& options, double horizon);
  int at(double t) const;
  // Twice the goal. False when the budget is exhausted.
  bool raise_goal();

  static constexpr int headroom = 48;
  int most;
  int goal;
  double slope = 0;  // further bits per unit of time before the horizon
  int reserve = 0;   // further bits at all times
  double horizon;
};

}  // namespace voroproof::internal
