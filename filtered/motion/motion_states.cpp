#include "filtered/motion/motion_states.h"

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "exact/patience.h"

namespace voroproof::internal {

namespace {

// The bits by which a state must be known below the scale of the scene: enough for
// the double-double filter to be limited by its own arithmetic.
constexpr int kInitialGoal = 112;
// Bits of the balls beyond the goal: what the last few collisions before the
// horizon may lose.
constexpr int kHeadroom = 48;

// Of zero.
constexpr std::int64_t kNoExponent = -1000;

std::int64_t exponent_of(double d) {
  return d == 0 ? kNoExponent : std::int64_t{std::ilogb(d)} + 1;
}
std::int64_t exponent_of(const Rational& q) { return exponent_of(round_nearest(q)); }

// Of a positive number: the exponent of a bound from above.
std::int64_t exponent_above(const CompactRational& x) {
  const Rational* exact = x.exact();
  if (exact == nullptr) return 2 + std::ilogb(x.leading());
  return static_cast<std::int64_t>(mpz_sizeinbase(exact->get_num_mpz_t(), 2)) -
         static_cast<std::int64_t>(mpz_sizeinbase(exact->get_den_mpz_t(), 2)) + 1;
}

// Whether q is held by its truncation `first` to binary64, by a test that numbers of few digits may
// fail.
bool is_held_by(double first, const Rational& q) {
  return mpz_popcount(q.get_den_mpz_t()) == 1 && mpz_sizeinbase(q.get_num_mpz_t(), 2) <= 53 &&
         std::fabs(first) >= DBL_MIN && std::isfinite(first);
}

DdBall dd_of(const Ball& b) {
  DdBall r;
  b.to_double_double(r.hi, r.lo, r.rad);
  return r;
}

DdBall dd_of(const FixedView& a, std::int64_t unit) {
  DdBall r;
  a.to_double_double(unit, r.hi, r.lo, r.rad);
  return r;
}

}  // namespace

// The nearest double below in magnitude, and what is left of it.
DdBall dd_of(const Rational& q) {
  if (sgn(q) == 0) return {};
  const double first = q.get_d();
  if (is_held_by(first, q)) return {first};
  if (!std::isfinite(first)) return {first, 0, std::numeric_limits<double>::infinity()};
  const Rational rest = q - to_rational(first);
  if (sgn(rest) == 0) return {first};
  const double second = rest.get_d();
  DdBall b;
  dd_detail::fast_two_sum(first, second, b.hi, b.lo);
  if (!is_held_by(second, rest)) b.rad = std::fabs(second) * 0x1p-52 + DBL_MIN;  // towards zero
  return b;
}

DdBall dd_of(const CompactRational& q) {
  if (const Rational* exact = q.exact()) return dd_of(*exact);
  return {q.leading(), q.second(), 0};
}

Ball dyadic_or_rounded(const Rational& q, Ball::Precision bits) {
  // A binary64 or a product of two is held exactly, whatever the working precision.
  const auto& den = q.get_den();
  if (mpz_popcount(den.get_mpz_t()) == 1) {
    const auto size = static_cast<Ball::Precision>(
        std::max<std::size_t>(mpz_sizeinbase(q.get_num_mpz_t(), 2), 2));
    if (size <= 256) return Ball(q, std::max<Ball::Precision>(size, 53));
  }
  return Ball(q, bits);
}

MotionStates::MotionStates(MotionInput input, const MotionOptions& options)
    : input_(std::move(input)),
      container_{input_.container_x, input_.container_y, input_.container_radius, 0, 0, 0},
      max_bits_(options.max_bits) {
  horizon_ = round_up(input_.horizon);
  goal_bits_ = std::min(kInitialGoal, std::max(max_bits_ - kHeadroom, 64));
  // A smaller or larger start is a larger or smaller first supply per time.
  const double supply = options.start_bits - goal_bits_ - kHeadroom;
  slope_ = supply > 0 && horizon_ > 0 ? supply / horizon_ : 0;
  x_scale_ = exponent_of(input_.container_radius);
  far_scale_ =
      std::max({x_scale_, exponent_of(input_.container_x), exponent_of(input_.container_y)});
  v_scale_ = kNoExponent;
  reach_scale_ = x_scale_;
  const double container = radius_dd(container_id).hi;
  for (GenId g = 0; g < size(); ++g) {
    const DiskInput& d = input_.disks[g];
    v_scale_ = std::max({v_scale_, exponent_of(dd_of(d.vx).hi), exponent_of(dd_of(d.vy).hi)});
    const double radius = dd_of(d.radius).hi;
    if (sgn(d.radius) > 0) reach_scale_ = std::min(reach_scale_, exponent_of(radius));
    const double rest = -container - radius;
    if (rest > 0x1p-20 * radius) {
      reach_scale_ = std::min(reach_scale_, exponent_of(rest));
    } else if (const Rational exact = input_.container_radius - d.radius.value(); sgn(exact) > 0) {
      reach_scale_ = std::min(reach_scale_, exponent_of(exact));
    }
  }
  const std::size_t n = input_.disks.size();
  start_.assign(n, 0.0);
  given_.assign(n, nullptr);
  fixed_.resize(n + 1);
  balls_.resize(n + 1);
  begin();
}

MotionStates::~MotionStates() = default;

int MotionStates::bits_at(double t) const {
  const double ahead = std::max(0.0, horizon_ - t) * slope_;
  const double bits =
      std::min<double>(goal_bits_ + kHeadroom + ahead, static_cast<double>(max_bits_));
  // Whole limbs: the balls at hand keep their memory from one collision to the next.
  return (static_cast<int>(bits) + 63) / 64 * 64;
}

// All generators in their initial states, of which balls are made when they are asked for.
void MotionStates::begin() {
  for (auto& state : fixed_) state.reset();
  for (auto& state : balls_) state.reset();
  const Ball::Precision bits = bits_at(0);
  const Rational& e = input_.container_restitution;
  const bool whole = input_.whole_container_law;
  disk_law_ = dyadic_or_rounded(Rational(-(1 + input_.restitution)), bits);
  const Rational wall = whole ? Rational(-2 * e) : Rational(-(1 + e));
  wall_law_ = dyadic_or_rounded(wall, bits);
  wall_keep_ = dyadic_or_rounded(Rational(e - 1), bits);
}

const DiskInput& MotionStates::initial_state(GenId g) const {
  DiskInput& d = input_.disks[g];
  // Nothing is written where nothing is to be taken over: the other thread may be here, too.
  if (given_[g] != nullptr) std::exchange(given_[g], nullptr)->state(g, d);
  return d;
}

void MotionStates::restart(GenId g, double t, const Rational& x, const Rational& y,
                           const Rational& vx, const Rational& vy) {
  wait();
  DiskInput& d = input_.disks[g];
  d.x = x;
  d.y = y;
  d.vx = vx;
  d.vy = vy;
  v_scale_ = std::max({v_scale_, exponent_of(vx), exponent_of(vy)});
  given_[g] = nullptr;
  start_[g] = t;
  balls_[g + 1].reset();
}

void MotionStates::restart(GenId g, double t, const GivenMotion& given) {
  wait();
  given_[g] = &given;
  start_[g] = t;
  balls_[g + 1].reset();
}

int MotionStates::append(Maneuver m) {
  v_scale_ = std::max({v_scale_, exponent_of(m.vx), exponent_of(m.vy)});
  maneuvers_.push_back(std::move(m));
  return static_cast<int>(maneuvers_.size()) - 1;
}

// For numbers in units of the scene: centres in 2^x_scale, velocities in 2^v_scale. Far away are
// coordinates where the container is not about the origin, times where they are late, and speeds
// divided by a short reach; disks may become faster than any is at first.
int MotionStates::integer_limbs() const {
  constexpr std::int64_t kFaster = 16;
  const std::int64_t last = horizon_ > 0 ? std::ilogb(horizon_) + 1 : kNoExponent;
  const std::int64_t largest =
      std::max({far_scale_ - x_scale_, last + v_scale_ - x_scale_, x_scale_ - reach_scale_});
  return static_cast<int>((largest + 2 + kFaster) / 64) + 1;
}

void MotionStates::set_fixed(FixedBall& out, const CompactRational& x, std::int64_t unit) {
  FixedArithmetic& with = workspace_.arithmetic;
  if (const Rational* exact = x.exact()) {
    with.set(out, dyadic_or_rounded(*exact, bits_at(0)), unit);
    return;
  }
  with.set(out, x.leading(), unit);
  if (x.second() == 0) return;
  with.set(workspace_.term, x.second(), unit);
  with.add(out, out, workspace_.term);
}

void MotionStates::respond(const Record& r) {
  const Ball::Precision bits = bits_at(r.t_ref);
  Workspace& m = workspace_;
  FixedArithmetic& with = m.arithmetic;
  const bool wall = r.i == container_id;
  const GenId ids[2] = {r.i, r.j};
  const std::int64_t xs = x_scale_, vs = v_scale_, ts = xs - vs;
  m.time_scale = ts;
  // A state that a collision left is taken as it is, if in these units; else from balls, or from
  // what was given at first.
  const FixedState* fixed[2];
  const State<Ball>* balls[2] = {};
  const DiskInput* first[2] = {};
  const double before[2] = {r.t_i, r.t_j};
  std::int64_t radius_exponent = -bits;
  for (int side = 0; side < 2; ++side) {
    fixed[side] = fixed_[ids[side] + 1].get();
    __builtin_prefetch(fixed[side]);
  }
  for (const FixedState* s : fixed) {
    if (s != nullptr) s->numbers.prefetch();
  }
  for (int side = 0; side < 2; ++side) {
    const GenId g = ids[side];
    if (fixed[side] == nullptr && balls_[g + 1] == nullptr) {
      first[side] = g == container_id ? &container_ : &initial_state(g);
      continue;
    }
    if (fixed[side] != nullptr && fixed[side]->v_scale != vs) fixed[side] = nullptr;
    const auto look = [&](const Magnitude& radius, std::int64_t scale) {
      if (!radius.is_zero()) radius_exponent = std::max(radius_exponent, radius.exponent() - scale);
    };
    if (fixed[side] != nullptr) {
      for (std::size_t k = 0; k < 4; ++k) look(fixed[side]->numbers.view(k).radius(), 0);
    } else {
      const State<Ball>& s = *(balls[side] = &this->balls(g, before[side]));
      look(s.x.radius(), xs);
      look(s.y.radius(), xs);
      look(s.vx.radius(), vs);
      look(s.vy.radius(), vs);
    }
  }
  with.set_format(bits, integer_limbs(), radius_exponent);
  with.set(m.now, r.t_ref, ts);
  // Centres and velocities at the reference time; with the container at rest, the offset runs from
  // it to the disk j.
  for (int k = 0; k < 2; ++k) {
    const GenId g = ids[k];
    if (fixed[k] != nullptr) {
      std::size_t which = 0;
      for (FixedBall* b : {&m.x[k], &m.y[k], &m.vx[k], &m.vy[k]}) {
        with.set(*b, fixed[k]->numbers.view(which++));
      }
    } else if (first[k] != nullptr) {
      set_fixed(m.x[k], first[k]->x, xs);
      set_fixed(m.y[k], first[k]->y, xs);
      set_fixed(m.vx[k], first[k]->vx, vs);
      set_fixed(m.vy[k], first[k]->vy, vs);
    } else {
      with.set(m.x[k], balls[k]->x, xs);
      with.set(m.y[k], balls[k]->y, xs);
      with.set(m.vx[k], balls[k]->vx, vs);
      with.set(m.vy[k], balls[k]->vy, vs);
    }
    if (g == container_id) continue;
    with.set(m.dt, before[k], ts);
    with.sub(m.dt, m.now, m.dt);
    with.add_product(m.x[k], m.x[k], m.vx[k], m.dt);
    with.add_product(m.y[k], m.y[k], m.vy[k], m.dt);
  }
  with.sub(m.dx, m.x[1], m.x[0]);
  with.sub(m.dy, m.y[1], m.y[0]);
  with.sub(m.wx, m.vx[1], m.vx[0]);
  with.sub(m.wy, m.vy[1], m.vy[0]);
  set_fixed(m.reach, input_.disks[r.j].radius, xs);
  if (wall) {
    set_fixed(m.a, container_.radius, xs);
    with.sub(m.reach, m.reach, m.a);
  } else {
    set_fixed(m.a, input_.disks[r.i].radius, xs);
    with.add(m.reach, m.reach, m.a);
  }
  // a s^2 + 2 b s + c = 0 at the contact, s after the reference time.
  with.sum_of_products(m.a, m.wx, m.wx, m.wy, m.wy);
  with.sum_of_products(m.b, m.dx, m.wx, m.dy, m.wy);
  with.sum_of_products(m.c, m.dx, m.dx, m.dy, m.dy);
  with.sub_product(m.c, m.c, m.reach, m.reach);
  with.difference_of_products(m.root, m.b, m.b, m.a, m.c);
  with.sqrt(m.root, m.root);
  if (!wall) {
    with.sub(m.term, m.root, m.b);  // b < 0: they approach
    with.div(m.s, m.c, m.term);
  } else if (with.sign(m.b) == Sign::positive) {
    with.add(m.term, m.b, m.root);
    with.div(m.s, m.c, m.term);
    with.negate(m.s);
  } else {
    with.sub(m.term, m.root, m.b);
    with.div(m.s, m.term, m.a);
  }
  // n = d + w s; w.n is -root at the contact of two disks, +root at the wall.
  with.add_product(m.nx, m.dx, m.wx, m.s);
  with.add_product(m.ny, m.dy, m.wy, m.s);
  if (!wall) {
    // The masses in units of the larger one.
    const CompactRational &mi = input_.disks[r.i].mass, &mj = input_.disks[r.j].mass;
    const std::int64_t ms = std::max(exponent_above(mi), exponent_above(mj));
    set_fixed(m.mass[0], mi, ms);
    set_fixed(m.mass[1], mj, ms);
  }
  // K = -(1 + e) root / (reach^2 (m_i + m_j)), at the wall without masses. One after the other the
  // quotients keep to the size of the numbers, and divisors are short.
  with.div(m.k, m.root, m.reach);
  if (!wall) {
    with.add(m.term, m.mass[0], m.mass[1]);
    with.mul(m.reach, m.reach, m.term);
  }
  with.div(m.k, m.k, m.reach);
  with.set(m.term, wall ? wall_law_ : disk_law_, 0);
  with.mul(m.k, m.k, m.term);
  with.mul(m.kx, m.k, m.nx);
  with.mul(m.ky, m.k, m.ny);
  if (wall && input_.whole_container_law) {
    with.set(m.k, wall_keep_, 0);
    with.add_product(m.kx, m.kx, m.vx[1], m.k);
    with.add_product(m.ky, m.ky, m.vy[1], m.k);
  }
  with.mul(m.sx, m.kx, m.s);
  with.mul(m.sy, m.ky, m.s);
  // New velocity, v + change; then the centre that the new line had or will have at the reference
  // time: x - change * s.
  if (wall) {
    // The change is K n or, of the law of the whole velocity, (e - 1) v - 2 e (root / reach^2) n.
    with.add(m.vx[1], m.vx[1], m.kx);
    with.add(m.vy[1], m.vy[1], m.ky);
    with.sub(m.x[1], m.x[1], m.sx);
    with.sub(m.y[1], m.y[1], m.sy);
  } else {
    // It is m_j K n for i, -m_i K n for j.
    with.negate(m.mass[0]);
    for (int side = 0; side < 2; ++side) {
      const FixedBall& mass = m.mass[1 - side];
      with.add_product(m.vx[side], m.vx[side], m.kx, mass);
      with.add_product(m.vy[side], m.vy[side], m.ky, mass);
      with.sub_product(m.x[side], m.x[side], m.sx, mass);
      with.sub_product(m.y[side], m.y[side], m.sy, mass);
    }
  }
  for (int side = wall ? 1 : 0; side < 2; ++side) {
    std::unique_ptr<FixedState>& state = fixed_[ids[side] + 1];
    if (!state) state = std::make_unique<FixedState>();
    with.store(state->numbers, {&m.x[side], &m.y[side], &m.vx[side], &m.vy[side]});
    state->v_scale = vs;
    balls_[ids[side] + 1].reset();
  }
  with.add(m.now, m.now, m.s);
}

void MotionStates::apply_maneuver(const Record& r) {
  const Ball::Precision bits = bits_at(r.t_ref);
  const Maneuver& m = maneuvers_[r.maneuver];
  const State<Ball>& s = balls(r.i, r.t_i);
  const Ball before(Rational(m.t - to_rational(r.t_i)), bits);
  const Ball after(Rational(m.t - to_rational(r.t_ref)), bits);
  const Ball vx = dyadic_or_rounded(m.vx, bits);
  const Ball vy = dyadic_or_rounded(m.vy, bits);
  balls_[r.i + 1] = std::make_unique<State<Ball>>(
      State<Ball>{s.x + s.vx * before - vx * after, s.y + s.vy * before - vy * after, vx, vy});
  fixed_[r.i + 1].reset();
}

void MotionStates::apply(const Record& r) {
  if (r.maneuver >= 0) {
    apply_maneuver(r);
  } else {
    respond(r);
  }
}

// Whether the states after a record are known to the bits of the goal.
bool MotionStates::is_accurate_enough(const Record& r) const {
  if (r.maneuver >= 0) return true;
  for (const GenId g : {r.i, r.j}) {
    if (g == container_id) continue;
    const FixedState& s = *fixed_[g + 1];
    for (std::size_t k = 0; k < 4; ++k) {
      const Magnitude radius = s.numbers.view(k).radius();
      if (!radius.is_zero() && -radius.exponent() < goal_bits_) return false;
    }
  }
  return true;
}

// Of the records applied so far.
void MotionStates::replay() {
  ++replays_;
  begin();
  for (std::size_t k = 0; k < applied_; ++k) {
    Patience::ask();
    apply(log_[k]);
  }
}

// Raises the supply of bits per time after a state at time t fell short of the goal, judging by
// what has been lost so far.
bool MotionStates::raise_for(double t) {
  const int before = bits_at(0);
  if (before >= max_bits_) return false;
  const double lost = before - goal_bits_;
  const double rate = t > 0 ? lost / t : 0;
  slope_ = std::max({1.1 * rate, 1.4 * slope_, horizon_ > 0 ? 32 / horizon_ : 0});
  return true;
}

void MotionStates::apply_log() {
  if (failure_) std::rethrow_exception(failure_);
  try {
    while (applied_ < log_.size()) {
      const Record& r = log_[applied_];
      apply(r);
      if (is_accurate_enough(r)) {
        ++applied_;
      } else if (raise_for(r.t_ref)) {
        replay();
      } else {
        throw Undecided("the state after the collision needs more than " +
                        std::to_string(max_bits_) + " bits");
      }
    }
  } catch (...) {
    failure_ = std::current_exception();
    throw;
  }
}

void MotionStates::take_over_rest() {
  log_.insert(log_.end(), rest_.begin(), rest_.end());
  rest_.clear();
}

void MotionStates::apply_rest() {
  wait();
  take_over_rest();
  apply_log();
}

void MotionStates::apply_rest_late() {
  wait();
  take_over_rest();
  before_job_ = {applied_, bits_at(0), replays_};
  if (!worker_) worker_ = std::make_unique<Worker>();
  worker_->start([this] { apply_log(); });
}

void MotionStates::wait() {
  if (is_working()) worker_->wait();
}

MotionStates::Progress MotionStates::progress() const {
  return is_working() ? before_job_ : Progress{applied_, bits_at(0), replays_};
}

bool MotionStates::raise_goal() {
  apply_rest();
  if (bits_at(horizon_) >= max_bits_) return false;
  goal_bits_ = std::min(2 * goal_bits_, max_bits_ - kHeadroom);
  replay();
  return true;
}

MotionStates::State<Ball> MotionStates::initial_balls(GenId g, Ball::Precision bits) const {
  const auto ball = [bits](const Rational& q) { return dyadic_or_rounded(q, bits); };
  if (g == container_id)
    return {ball(input_.container_x), ball(input_.container_y), Ball(2), Ball(2)};
  const DiskInput& d = initial_state(g);
  return {ball(d.x), ball(d.y), ball(d.vx), ball(d.vy)};
}

const MotionStates::State<Ball>& MotionStates::balls(GenId g, double t_ref) const {
  std::unique_ptr<State<Ball>>& balls = balls_[g + 1];
  if (balls) return *balls;
  const Ball::Precision bits = bits_at(t_ref);
  if (const FixedState* fixed = fixed_[g + 1].get()) {
    balls = std::make_unique<State<Ball>>();
    std::size_t k = 0;
    for (Ball* b : {&balls->x, &balls->y, &balls->vx, &balls->vy}) {
      fixed->numbers.view(k).get(*b, fixed->scale(k, x_scale_), bits);
      ++k;
    }
  } else {
    balls = std::make_unique<State<Ball>>(initial_balls(g, bits));
  }
  return *balls;
}

MotionStates::State<DdBall> MotionStates::double_doubles(GenId g) const {
  if (const FixedState* fixed = fixed_[g + 1].get()) {
    const auto at = [&](std::size_t k) {
      return dd_of(fixed->numbers.view(k), fixed->scale(k, x_scale_));
    };
    return {at(0), at(1), at(2), at(3)};
  }
  if (const State<Ball>* s = balls_[g + 1].get()) {
    return {dd_of(s->x), dd_of(s->y), dd_of(s->vx), dd_of(s->vy)};
  }
  if (g == container_id) return {dd_of(input_.container_x), dd_of(input_.container_y), {}, {}};
  const DiskInput& d = initial_state(g);
  return {dd_of(d.x), dd_of(d.y), dd_of(d.vx), dd_of(d.vy)};
}

DdBall MotionStates::radius_dd(GenId g) const {
  return g == container_id ? -dd_of(input_.container_radius) : dd_of(input_.disks[g].radius);
}

DdBall MotionStates::last_time() const {
  return dd_of(workspace_.arithmetic.view(workspace_.now), workspace_.time_scale);
}

DdBall MotionStates::last_delay() const {
  return dd_of(workspace_.arithmetic.view(workspace_.s), workspace_.time_scale);
}

Ball MotionStates::last_time_ball() const { return ball_of(workspace_.now); }
Ball MotionStates::last_delay_ball() const { return ball_of(workspace_.s); }

// A time of the last collision.
Ball MotionStates::ball_of(const FixedBall& time) const {
  Ball b;
  workspace_.arithmetic.view(time).get(b, workspace_.time_scale, bits_at(0));
  return b;
}

}  // namespace voroproof::internal
