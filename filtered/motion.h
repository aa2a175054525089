// The motion of the disks: piecewise linear, known at several precisions at once.
//
// Between its own collisions and maneuvers a disk moves on a line, so its motion is
// a state (centre and velocity at a reference time). The state is carried as
//   - doubles and double-doubles with error bounds, for the filters,
//   - balls of as many bits as the rest of the run needs,
//   - on demand, elements of a tower of quadratic fields (ExactMotion below).
// The log of collisions and maneuvers is the expression graph of every state: to
// get more bits the log is replayed at a higher precision; no search is repeated.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "exact/ball.h"
#include "exact/compact_rational.h"
#include "exact/fixed_ball.h"
#include "exact/generators.h"
#include "exact/predicates.h"
#include "exact/rational.h"
#include "exact/tower.h"
#include "filtered/dd_ball.h"
#include "filtered/double_ball.h"

namespace voroproof {

struct DiskInput {
  CompactRational x, y, radius, vx, vy, mass;
};

struct MotionInput {
  Rational container_x, container_y, container_radius;
  Rational restitution = 1;
  Rational container_restitution = 1;
  bool whole_container_law = false;  // scale the whole reflected velocity
  Rational horizon;                  // guides the choice of precision only
  std::vector<DiskInput> disks;
};

// A decision that needs more than the stated budget, and what it is about.
class Undecided : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  Undecided(const std::string& reason, const Quad& edge) : std::runtime_error(reason), flip(edge) {}
  Undecided(const std::string& reason, GenId i, GenId j)
      : std::runtime_error(reason), contact(std::pair(i, j)) {}

  std::optional<Quad> flip;
  std::optional<std::pair<GenId, GenId>> contact;
};

// Motion of one generator in doubles: centre (x, y) at time t, velocity, signed
// radius; the true centre at t is within ex of (x, y) in each coordinate, the true
// radius within ex of r, the true velocity within ev. One line of the caches: nearly
// everything that is decided begins with four of these.
struct alignas(64) DoubleMotion {
  double t = 0, x = 0, y = 0, vx = 0, vy = 0, r = 0;
  double ex = 0, ev = 0;
};

// What is left of the true values by those doubles, to make double-doubles of them:
// the true centre is within ex of (x, y) + (this x, y) and so on.
struct alignas(64) SecondMotion {
  double x = 0, y = 0, vx = 0, vy = 0, r = 0;
  double ex = 0, ev = 0, er = 0;
};

// The same in double-doubles.
struct DdMotion {
  DdBall x, y, vx, vy, r;
};

// A disk's state just after a collision or maneuver, rounded to nearest.
struct RoundedState {
  double px, py, vx, vy;
};

struct Impact {
  double t;         // the collision time, rounded to nearest
  DoubleBall time;  // enclosures of it
  DdBall time_dd;
  RoundedState first, second;  // second is unused for the container
};

struct MotionOptions {
  bool filters = true;  // false: no decision is taken in doubles or double-doubles
  int start_bits = 192;
  int max_bits = 32768;
  std::size_t max_radicals = 4;
};

class ExactMotion;

// Tells the exact states of disks whose motion is given and not computed.
class GivenMotion {
 public:
  virtual ~GivenMotion() = default;
  // Centre and velocity of disk g when it was last restarted: sets x, y, vx and vy.
  virtual void state(GenId g, DiskInput& disk) const = 0;
};

class Motion {
 public:
  Motion(MotionInput input, MotionOptions options);

  int size() const { return static_cast<int>(input_.disks.size()); }
  // Of disks whose motion is given, centres and velocities may be those of another time: see
  // initial_state().
  const MotionInput& input() const { return input_; }
  // Disk g with the centre and the velocity of its initial state, or of its last restart().
  const DiskInput& initial_state(GenId g) const;
  const MotionOptions& options() const { return options_; }

  const DoubleMotion& doubles(GenId g) const { return doubles_[g + 1]; }
  const SecondMotion& seconds(GenId g) const { return seconds_[g + 1]; }
  // Both together, referred to the time of doubles(g).
  DdMotion double_doubles(GenId g) const {
    const DoubleMotion& m = doubles(g);
    const SecondMotion& s = seconds(g);
    return {{m.x, s.x, s.ex}, {m.y, s.y, s.ex}, {m.vx, s.vx, s.ev}, {m.vy, s.vy, s.ev}, radius(g)};
  }
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

  // From now on disk g moves as if it had been at (x, y) at time t, with that velocity: motion that
  // is given and not computed. Precondition: no collide() or maneuver() of the disk so far.
  void restart(GenId g, const Rational& t, const Rational& x, const Rational& y, const Rational& vx,
               const Rational& vy);
  // The same from enclosures of x and y. The exact state is asked of `given` if it is ever needed,
  // and must be at hand until the disk is restarted.
  void restart(GenId g, double t, const DdBall& x, const DdBall& y, double vx, double vy,
               const GivenMotion& given);

  // The same in plain doubles, without certificates: for comparison only.
  Impact collide_in_doubles(GenId i, GenId j, double t);
  RoundedState maneuver_in_doubles(GenId g, double t, double vx, double vy);

  // Asks for more bits in all states: replays the log with a higher goal. False
  // when the budget (max_bits) is exhausted.
  bool raise_precision();
  // The present goal: every state is known to at least this many bits below the
  // scale of the scene.
  int goal_bits() const { return goal_bits_; }
  int highest_bits() const { return bits_at(0); }
  std::uint64_t replays() const { return replays_; }

  // Whether the present motion of g is rational for certain: no collision is in its past.
  bool is_rational(GenId g) const;

  // The state in force: -1 - g for the initial one, else one more than its record's index in
  // the log.
  int state_id(GenId g) const { return state_[g + 1]; }
  // The collisions and maneuvers so far.
  int records() const { return static_cast<int>(log_.size()); }

  struct ManeuverRecord {
    Rational t, vx, vy;
  };
  // How the state of disk g with an id > 0 came about: from its state `before`, by a maneuver or
  // by a collision with the partner, whose state before that is given.
  struct Origin {
    int before;
    const ManeuverRecord* maneuver;  // or null; valid until the Motion changes
    GenId partner;
    int partner_before;
  };
  Origin origin(GenId g, int id) const;
  // The two generators of the collision with this id, the smaller first; a maneuver's disk twice.
  std::pair<GenId, GenId> generators_of(int id) const { return {log_[id - 1].i, log_[id - 1].j}; }
  // Two collisions of one disk at one instant with normals at right angles: 1 where that of id b,
  // seen from the disk, is to the left of that of a, -1 to the right, 0 where nothing was noted.
  int right_angle(int a, int b) const;
  // Three disks of one mass in a row, and three elastic collisions of theirs at one instant: of an
  // end and the middle, of the middle and the other end, and again of the first two. Together they
  // exchange the velocities of the ends along the row and leave the middle as it was.
  struct Cradle {
    GenId end, middle, far_end;
    std::array<int, 3> ids;
  };
  // The one that the collision with this id belongs to, or null; valid until another is noted.
  const Cradle* cradle(int id) const;
  // Notes what the caller has proved. Precondition: none of its collisions belongs to another.
  void note_cradle(const Cradle& c);
  void note_right_angle(int a, int b, int turn);
  // When the initial state of a disk holds: 0 unless it was restarted.
  double initial_time(GenId g) const { return start_[g]; }

 private:
  friend class ExactMotion;

  struct BallState {
    Ball x, y, vx, vy;
  };
  // x, y, vx, vy after a collision, as the computation left them: in units of 2^x_scale_ and of
  // 2^v_scale.
  struct FixedState {
    FixedRow numbers;
    std::int64_t v_scale;
    std::int64_t scale(std::size_t k, std::int64_t x_scale) const {
      return k < 2 ? x_scale : v_scale;
    }
  };
  struct Record {
    GenId i, j;  // collision of i < j; a maneuver of i has j = i
    int before_i, before_j;
    double t_ref;  // reference time of the states after it
    int maneuver;  // index into maneuvers_, or -1
  };
  // What a collision computes with, kept so that no memory is allocated for it.
  struct Workspace {
    FixedArithmetic arithmetic;
    FixedBall now, dt, term, x[2], y[2], vx[2], vy[2], dx, dy, wx, wy, mass[2];
    FixedBall reach, a, b, c, root, s, nx, ny, k, kx, ky, sx, sy;
    std::int64_t time_scale = 0;  // of `s`, the delay of the collision after `now`
  };

  int bits_at(double t) const;
  int integer_limbs() const;
  void load_initial_states();
  BallState initial_balls(GenId g, Ball::Precision bits) const;
  const BallState& ball_state(GenId g) const;
  Ball radius_ball(GenId g, Ball::Precision bits) const;
  void refresh(GenId g);
  void set_state(GenId g, const DdBall& x, const DdBall& y, const DdBall& vx, const DdBall& vy);
  void set_radius(GenId g, const DdBall& r);
  void set_fixed(FixedBall& out, const CompactRational& x, std::int64_t unit);
  void respond(const Record& r);
  void apply_maneuver(const Record& r);
  bool accurate_enough(GenId g) const;
  void replay();
  bool raise_for(double t);
  double round_coordinate(const DdBall& rough, GenId g, int which);

  // Where `given_` is set for a disk, its state is yet to be taken over from there.
  mutable MotionInput input_;
  mutable std::vector<const GivenMotion*> given_;
  MotionOptions options_;
  DiskInput container_;  // at rest; its radius is positive here
  int goal_bits_;
  double slope_ = 0;  // further bits per unit of time before the horizon
  double horizon_ = 0;
  std::int64_t x_scale_ = 0, v_scale_ = 0;        // exponents
  std::int64_t far_scale_ = 0, reach_scale_ = 0;  // of the farthest coordinate, the least reach
  std::uint64_t replays_ = 0;
  std::vector<Record> log_;
  std::vector<ManeuverRecord> maneuvers_;
  std::map<std::pair<int, int>, int> right_angles_;
  std::vector<Cradle> cradles_;
  std::map<int, int> cradle_;  // by the ids of their collisions: which
  std::vector<int> state_;     // per generator
  std::vector<double> start_;  // per disk: when its initial state holds
  std::vector<DoubleMotion> doubles_;
  std::vector<SecondMotion> seconds_;
  // The states of generators whose last change was a collision; null of all others.
  std::vector<std::unique_ptr<FixedState>> fixed_;
  // States in balls: those after a maneuver, others from when they are asked for.
  mutable std::vector<std::unique_ptr<BallState>> balls_;
  Ball disk_law_, wall_law_, wall_keep_;  // factors of the laws of collision
  Workspace workspace_;
  // Of the uncertified instance.
  double plain_restitution_ = 1;
  std::int64_t plain_collisions_ = 0;
};

// Exact states of the disks of a Motion as it stands, in a tower of quadratic
// fields over the rationals: what proves equalities. Follows a disk's causal past
// through the log; throws BudgetExceeded where the tower would need more radicals
// or larger coefficients than the budget allows. Valid until the Motion changes.
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

 private:
  struct Entry {
    State state;
    Tower start;
  };
  const Entry& entry(int id, GenId g);
  void compute(int record);
  const Motion& motion_;
  RadicalField field_;
  std::unordered_map<long, Entry> memo_;
};

// The exact time, within the tower, of the next contact of two moving sites given
// at time t (see Contact): the root at which they begin to overlap, or the exit of
// a disk from the container. Precondition: that root exists.
Tower contact_delay(const Contact<Tower>& contact, bool with_container, RadicalField& field);

// The binary64 nearest to an element, ties to even.
double round_nearest(const Tower& x);

}  // namespace voroproof
