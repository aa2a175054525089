// The motion of the disks: piecewise linear, known at several precisions at once.
//
// Between its own collisions and maneuvers a disk moves on a line, so its motion is
// a state (centre and velocity at a reference time). The state is carried as
//   - doubles and double-doubles with error bounds, for the filters,
//   - fixed-point numbers and balls of as many bits as the rest of the run needs (MotionStates),
//   - on demand, elements of a tower of quadratic fields (ExactMotion).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "exact/ball.h"
#include "exact/generators.h"
#include "exact/predicates.h"
#include "exact/prefetch.h"
#include "exact/rational.h"
#include "filtered/motion/collision_relations.h"
#include "filtered/motion/motion_states.h"
#include "filtered/motion/options.h"
#include "filtered/numbers/dd_ball.h"
#include "filtered/numbers/double_ball.h"

namespace voroproof::internal {

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

class Motion {
 public:
  Motion(MotionInput input, MotionOptions options)
      : Motion(std::move(input), options, std::make_shared<MotionLog>()) {}
  // A motion that follows another one of the same input, which it does not refer to: it takes its
  // collisions and maneuvers over, by follow(), in place of computing them, and reads their log.
  Motion(MotionInput input, MotionOptions options, std::shared_ptr<MotionLog> log);

  int size() const { return states_->size(); }
  // The input, about the container's centre, as all coordinates of a motion are but those of
  // RoundedState and restart(). Where the motion of a disk is given, its centre and velocity here
  // may be those of another time: see initial_state().
  const MotionInput& input() const { return states_->input(); }
  // Disk g with the centre and the velocity of its initial state, or of its last restart().
  const DiskInput& initial_state(GenId g) const { return states_->initial_state(g); }
  const MotionOptions& options() const { return options_; }

  const DoubleMotion& doubles(GenId g) const { return doubles_[g + 1]; }
  // Asks for the memory of doubles() and state_id().
  [[gnu::always_inline]] void prefetch(GenId g) const {
    internal::prefetch(&doubles_[g + 1]);
    internal::prefetch(&state_[g + 1]);
  }
  // Asks for the memory of what restart() changes besides.
  [[gnu::always_inline]] void prefetch_restart(GenId g) const {
    internal::prefetch(&seconds_[g + 1]);
    states_->prefetch_restart(g);
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

  // Processes the contact of i and j (i < j, i may be the container) that lies
  // next to the double t_near and which the caller has proved to be their next
  // contact. Changes both states.
  Impact collide(GenId i, GenId j, double t_near);
  // Gives disk g a new velocity at an exact time; returns its rounded state.
  RoundedState maneuver(GenId g, const Rational& t, const Rational& vx, const Rational& vy);

  // The log and the snapshot that another motion needs to follow this one.
  const std::shared_ptr<MotionLog>& log() const { return states_->log(); }
  MotionSnapshot snapshot();
  TurnedState turned(GenId g) const;
  std::int64_t v_scale() const { return states_->v_scale(); }
  // This motion, which follows another, is as that one was then.
  void follow(const MotionSnapshot& then);
  // The next record of the other motion, after which i < j, or i alone if j = i, were in these
  // states. Nothing is said of the container's.
  void follow(GenId i, const TurnedState& first, GenId j, const TurnedState& second,
              std::int64_t v_scale);

  // From now on disk g moves as if it had been at (x, y) of the scene at time t, with that
  // velocity: motion that is given and not computed. Precondition: no collide() or maneuver() of
  // the disk so far.
  void restart(GenId g, const Rational& t, const Rational& x, const Rational& y, const Rational& vx,
               const Rational& vy);
  // Restarts disk g from enclosures of x and y. The exact state is asked of `given` if it is ever
  // needed; `given` must be at hand until the disk is restarted.
  void restart(GenId g, double t, const DdBall& x, const DdBall& y, double vx, double vy,
               const GivenMotion& given);

  // Sets doubles(g) to m without any proof; nothing else here tells the motion of g any more. For
  // peers in plain doubles, to measure against.
  void overwrite(GenId g, const DoubleMotion& m) { doubles_[g + 1] = m; }

  // The changes of motion so far, in order of time.
  const MotionStates::Record& record(int k) const { return states_->record(k); }
  const MotionStates::Maneuver& maneuver(int index) const { return states_->maneuver(index); }
  // Asks for more bits in all states. False when the budget (max_bits) is exhausted.
  bool raise_precision();
  // The present goal: every state is known to at least this many bits below the
  // scale of the scene.
  int goal_bits() const { return states_->goal_bits(); }
  int highest_bits() const { return states_->highest_bits(); }
  std::uint64_t replays() const { return states_->replays(); }

  // Whether the present motion of g is rational for certain: no collision is in its past.
  bool is_rational(GenId g) const;

  // The state in force: -1 - g for the initial one, else one more than its record's index in
  // the log.
  int state_id(GenId g) const { return state_[g + 1]; }
  // The collisions and maneuvers so far.
  int records() const { return static_cast<int>(states_->size_of_log()); }

  // How the state of disk g with an id > 0 came about: from its state `before`, by a maneuver or
  // by a collision with the partner, whose state before that is given.
  struct Origin {
    int before;
    const MotionStates::Maneuver* maneuver;  // or null; valid until the Motion changes
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
  // When the initial state of a disk holds: 0 unless it was restarted.
  double initial_time(GenId g) const { return states_->initial_time(g); }

 private:
  using Record = MotionStates::Record;

  const MotionStates& full_states() const;
  Ball radius_ball(GenId g, Ball::Precision bits) const;
  void refresh(GenId g);
  void set_state(GenId g, const DdBall& x, const DdBall& y, const DdBall& vx, const DdBall& vy);
  void set_radius(GenId g, const DdBall& r);
  void take(GenId g, const TurnedState& s);
  void append(const Record& r);
  // A coordinate of a centre as the scene has it.
  DdBall in_scene(const DdBall& x, int axis) const { return moved_ ? x + origin_[axis] : x; }
  double round_coordinate(const DdBall& rough, GenId g, int which);

  MotionOptions options_;
  std::unique_ptr<MotionStates> states_;
  CollisionRelations relations_;
  std::vector<int> state_;  // per generator
  std::vector<DoubleMotion> doubles_;
  std::vector<SecondMotion> seconds_;
  bool radii_are_doubles_ = true;
  std::array<DdBall, 2> origin_;  // origin of the input
  bool moved_ = false;            // the origin is not that of the scene
};

}  // namespace voroproof::internal
