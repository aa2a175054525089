#include "filtered/motion.h"

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <limits>
#include <utility>

#include "exact/patience.h"

namespace voroproof {

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

bool is_double(const DdBall& b) { return b.lo == 0 && b.rad == 0; }

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

// Of exact arithmetic, which is slow far sooner than balls are.
constexpr std::size_t kMaxCoefficientBits = 1 << 16;

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

}  // namespace

Motion::Motion(MotionInput input, MotionOptions options)
    : input_(std::move(input)),
      options_(options),
      container_{input_.container_x, input_.container_y, input_.container_radius, 0, 0, 0} {
  horizon_ = round_up(input_.horizon);
  goal_bits_ = std::min(kInitialGoal, std::max(options_.max_bits - kHeadroom, 64));
  // A smaller or larger start is a larger or smaller first supply per time.
  const double supply = options_.start_bits - goal_bits_ - kHeadroom;
  slope_ = supply > 0 && horizon_ > 0 ? supply / horizon_ : 0;
  x_scale_ = exponent_of(input_.container_radius);
  far_scale_ =
      std::max({x_scale_, exponent_of(input_.container_x), exponent_of(input_.container_y)});
  const std::size_t n = input_.disks.size();
  state_.resize(n + 1);
  start_.assign(n, 0.0);
  given_.assign(n, nullptr);
  doubles_.resize(n + 1);
  seconds_.resize(n + 1);
  fixed_.resize(n + 1);
  balls_.resize(n + 1);
  set_radius(container_id, -dd_of(input_.container_radius));
  for (GenId g = 0; g < size(); ++g) set_radius(g, dd_of(input_.disks[g].radius));
  for (std::size_t g = 0; g <= n; ++g) state_[g] = -static_cast<int>(g);
  load_initial_states();
  v_scale_ = kNoExponent;
  reach_scale_ = x_scale_;
  for (GenId g = 0; g < size(); ++g) {
    const DoubleMotion& m = doubles(g);
    v_scale_ = std::max({v_scale_, exponent_of(m.vx), exponent_of(m.vy)});
    const CompactRational& radius = input_.disks[g].radius;
    if (sgn(radius) > 0) reach_scale_ = std::min(reach_scale_, exponent_of(m.r));
    const double rest = -doubles(container_id).r - m.r;
    if (rest > 0x1p-20 * m.r) {
      reach_scale_ = std::min(reach_scale_, exponent_of(rest));
    } else if (const Rational exact = input_.container_radius - radius.value(); sgn(exact) > 0) {
      reach_scale_ = std::min(reach_scale_, exponent_of(exact));
    }
  }
  plain_restitution_ = input_.restitution.get_d();
}

int Motion::bits_at(double t) const {
  const double ahead = std::max(0.0, horizon_ - t) * slope_;
  const double bits =
      std::min<double>(goal_bits_ + kHeadroom + ahead, static_cast<double>(options_.max_bits));
  // Whole limbs: the balls at hand keep their memory from one collision to the next.
  return (static_cast<int>(bits) + 63) / 64 * 64;
}

// Balls of the disks' states are made when they are asked for.
void Motion::load_initial_states() {
  const Ball::Precision bits = bits_at(0);
  for (GenId g = container_id; g < size(); ++g) {
    fixed_[g + 1].reset();
    balls_[g + 1].reset();
    doubles_[g + 1].t = g == container_id ? 0 : start_[g];
    refresh(g);
  }
  const Rational& e = input_.container_restitution;
  const bool whole = input_.whole_container_law;
  disk_law_ = dyadic_or_rounded(Rational(-(1 + input_.restitution)), bits);
  const Rational wall = whole ? Rational(-2 * e) : Rational(-(1 + e));
  wall_law_ = dyadic_or_rounded(wall, bits);
  wall_keep_ = dyadic_or_rounded(Rational(e - 1), bits);
}

Motion::BallState Motion::initial_balls(GenId g, Ball::Precision bits) const {
  const auto ball = [bits](const Rational& q) { return dyadic_or_rounded(q, bits); };
  if (g == container_id)
    return {ball(input_.container_x), ball(input_.container_y), Ball(2), Ball(2)};
  const DiskInput& d = initial_state(g);
  return {ball(d.x), ball(d.y), ball(d.vx), ball(d.vy)};
}

const DiskInput& Motion::initial_state(GenId g) const {
  DiskInput& d = input_.disks[g];
  if (const GivenMotion* given = std::exchange(given_[g], nullptr)) given->state(g, d);
  return d;
}

const Motion::BallState& Motion::ball_state(GenId g) const {
  std::unique_ptr<BallState>& balls = balls_[g + 1];
  if (balls) return *balls;
  const Ball::Precision bits = bits_at(doubles(g).t);
  if (const FixedState* fixed = fixed_[g + 1].get()) {
    balls = std::make_unique<BallState>();
    std::size_t k = 0;
    for (Ball* b : {&balls->x, &balls->y, &balls->vx, &balls->vy}) {
      fixed->numbers.view(k).get(*b, fixed->scale(k, x_scale_), bits);
      ++k;
    }
  } else {
    balls = std::make_unique<BallState>(initial_balls(g, bits));
  }
  return *balls;
}

Ball Motion::radius_ball(GenId g, Ball::Precision bits) const {
  const DdBall near = radius(g);
  if (is_double(near)) return Ball(near.hi, bits);
  return Ball(
      g == container_id ? Rational(-input_.container_radius) : input_.disks[g].radius.value(),
      bits);
}

// Makes double-doubles and doubles, with their error bounds, from the state in force.
void Motion::refresh(GenId g) {
  if (const FixedState* fixed = fixed_[g + 1].get()) {
    const auto at = [&](std::size_t k) {
      return dd_of(fixed->numbers.view(k), fixed->scale(k, x_scale_));
    };
    set_state(g, at(0), at(1), at(2), at(3));
  } else if (const BallState* s = balls_[g + 1].get()) {
    set_state(g, dd_of(s->x), dd_of(s->y), dd_of(s->vx), dd_of(s->vy));
  } else if (g == container_id) {
    set_state(g, dd_of(input_.container_x), dd_of(input_.container_y), {}, {});
  } else {
    const DiskInput& d = initial_state(g);
    set_state(g, dd_of(d.x), dd_of(d.y), dd_of(d.vx), dd_of(d.vy));
  }
}

namespace {

// How far the leading double may be from the truth.
double error_of_leading(double second, double rad) {
  return (std::fabs(second) + rad) * (1 + 0x1p-50);
}

}  // namespace

void Motion::set_radius(GenId g, const DdBall& r) {
  doubles_[g + 1].r = r.hi;
  seconds_[g + 1].r = r.lo;
  seconds_[g + 1].er = r.rad;
}

void Motion::set_state(GenId g, const DdBall& x, const DdBall& y, const DdBall& vx,
                       const DdBall& vy) {
  DoubleMotion& m = doubles_[g + 1];
  SecondMotion& s = seconds_[g + 1];
  m.x = x.hi;
  m.y = y.hi;
  m.vx = vx.hi;
  m.vy = vy.hi;
  s.x = x.lo;
  s.y = y.lo;
  s.vx = vx.lo;
  s.vy = vy.lo;
  s.ex = std::max(x.rad, y.rad);
  s.ev = std::max(vx.rad, vy.rad);
  m.ex = std::max(
      {error_of_leading(x.lo, x.rad), error_of_leading(y.lo, y.rad), error_of_leading(s.r, s.er)});
  m.ev = std::max(error_of_leading(vx.lo, vx.rad), error_of_leading(vy.lo, vy.rad));
}

Site<DoubleBall> Motion::site(GenId g, const DoubleBall& t) const {
  const DoubleMotion& m = doubles_[g + 1];
  const DoubleBall dt = t - DoubleBall(m.t);
  return {DoubleBall(m.x, m.ex) + DoubleBall(m.vx, m.ev) * dt,
          DoubleBall(m.y, m.ex) + DoubleBall(m.vy, m.ev) * dt, DoubleBall(m.r, m.ex)};
}

Site<DdBall> Motion::site(GenId g, const DdBall& t) const {
  const DdMotion m = double_doubles(g);
  const DdBall dt = t - DdBall(doubles(g).t);
  return {m.x + m.vx * dt, m.y + m.vy * dt, m.r};
}

Site<Ball> Motion::site(GenId g, const Ball& t) const {
  const MovingSite<Ball> s = moving_site(g, t);
  return {s.x, s.y, s.r};
}

MovingSite<DoubleBall> Motion::moving_site(GenId g, const DoubleBall& t) const {
  const DoubleMotion& m = doubles_[g + 1];
  const Site<DoubleBall> s = site(g, t);
  return {s.x, s.y, DoubleBall(m.vx, m.ev), DoubleBall(m.vy, m.ev), s.r};
}

MovingSite<DdBall> Motion::moving_site(GenId g, const DdBall& t) const {
  const DdMotion m = double_doubles(g);
  const Site<DdBall> s = site(g, t);
  return {s.x, s.y, m.vx, m.vy, s.r};
}

MovingSite<Ball> Motion::moving_site(GenId g, const Ball& t) const {
  const BallState& m = ball_state(g);
  // Short exact numbers are held in few bits: everything at the precision of the time.
  const auto bits = t.precision();
  const Ball dt = t - Ball(doubles(g).t, bits);
  return {m.x + m.vx * dt, m.y + m.vy * dt, m.vx.at_precision(bits), m.vy.at_precision(bits),
          radius_ball(g, bits)};
}

bool Motion::same_velocity(GenId a, GenId b) const {
  // The leading parts differ nearly always.
  if (doubles_[a + 1].vx != doubles_[b + 1].vx || doubles_[a + 1].vy != doubles_[b + 1].vy) {
    return false;
  }
  const SecondMotion& m = seconds(a);
  const SecondMotion& o = seconds(b);
  return m.ev == 0 && o.ev == 0 && m.vx == o.vx && m.vy == o.vy;
}

bool Motion::is_rational(GenId g) const {
  int id = state_[g + 1];
  while (id > 0) {
    const Record& r = log_[id - 1];
    if (r.maneuver < 0) return false;
    id = r.before_i;
  }
  return true;
}

Motion::Origin Motion::origin(GenId g, int id) const {
  const Record& r = log_[id - 1];
  if (r.maneuver >= 0) return {r.before_i, &maneuvers_[r.maneuver], g, 0};
  if (g == r.i) return {r.before_i, nullptr, r.j, r.before_j};
  return {r.before_j, nullptr, r.i, r.before_i};
}

int Motion::right_angle(int a, int b) const {
  const auto it = right_angles_.find(std::minmax(a, b));
  if (it == right_angles_.end()) return 0;
  return a < b ? it->second : -it->second;
}

void Motion::note_right_angle(int a, int b, int turn) {
  right_angles_[std::minmax(a, b)] = a < b ? turn : -turn;
}

const Motion::Cradle* Motion::cradle(int id) const {
  const auto it = cradle_.find(id);
  return it == cradle_.end() ? nullptr : &cradles_[it->second];
}

void Motion::note_cradle(const Cradle& c) {
  for (const int id : c.ids) cradle_[id] = static_cast<int>(cradles_.size());
  cradles_.push_back(c);
}

// For numbers in units of the scene: centres in 2^x_scale, velocities in 2^v_scale. Far away are
// coordinates where the container is not about the origin, times where they are late, and speeds
// divided by a short reach; disks may become faster than any is at first.
int Motion::integer_limbs() const {
  constexpr std::int64_t kFaster = 16;
  const std::int64_t last = horizon_ > 0 ? std::ilogb(horizon_) + 1 : kNoExponent;
  const std::int64_t largest =
      std::max({far_scale_ - x_scale_, last + v_scale_ - x_scale_, x_scale_ - reach_scale_});
  return static_cast<int>((largest + 2 + kFaster) / 64) + 1;
}

void Motion::set_fixed(FixedBall& out, const CompactRational& x, std::int64_t unit) {
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

void Motion::respond(const Record& r) {
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
  const BallState* balls[2] = {};
  const DiskInput* first[2] = {};
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
      const BallState& s = *(balls[side] = &ball_state(g));
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
    with.set(m.dt, doubles(g).t, ts);
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
    doubles_[ids[side] + 1].t = r.t_ref;
  }
  with.add(m.now, m.now, m.s);
}

void Motion::apply_maneuver(const Record& r) {
  const Ball::Precision bits = bits_at(r.t_ref);
  const ManeuverRecord& m = maneuvers_[r.maneuver];
  const BallState& s = ball_state(r.i);
  const Ball before(Rational(m.t - to_rational(doubles(r.i).t)), bits);
  const Ball after(Rational(m.t - to_rational(r.t_ref)), bits);
  const Ball vx = dyadic_or_rounded(m.vx, bits);
  const Ball vy = dyadic_or_rounded(m.vy, bits);
  balls_[r.i + 1] = std::make_unique<BallState>(
      BallState{s.x + s.vx * before - vx * after, s.y + s.vy * before - vy * after, vx, vy});
  fixed_[r.i + 1].reset();
  doubles_[r.i + 1].t = r.t_ref;
}

// Of a disk after a collision.
bool Motion::accurate_enough(GenId g) const {
  if (g == container_id) return true;
  const FixedState& s = *fixed_[g + 1];
  for (std::size_t k = 0; k < 4; ++k) {
    const Magnitude radius = s.numbers.view(k).radius();
    if (!radius.is_zero() && -radius.exponent() < goal_bits_) return false;
  }
  return true;
}

void Motion::replay() {
  ++replays_;
  load_initial_states();
  for (const Record& r : log_) {
    Patience::ask();
    if (r.maneuver >= 0) {
      apply_maneuver(r);
    } else {
      respond(r);
    }
  }
  for (GenId g = -1; g < size(); ++g) refresh(g);
}

// Raises the supply of bits per time after a state at time t fell short of the
// goal, judging by what has been lost so far.
bool Motion::raise_for(double t) {
  const int before = bits_at(0);
  if (before >= options_.max_bits) return false;
  const double lost = before - goal_bits_;
  const double rate = t > 0 ? lost / t : 0;
  slope_ = std::max({1.1 * rate, 1.4 * slope_, horizon_ > 0 ? 32 / horizon_ : 0});
  return true;
}

bool Motion::raise_precision() {
  if (bits_at(horizon_) >= options_.max_bits) return false;
  goal_bits_ = std::min(2 * goal_bits_, options_.max_bits - kHeadroom);
  replay();
  return true;
}

// A coordinate of disk g just after its collision, known roughly: 0 and 1 its centre, 2 and 3 its
// velocity, 4 the time.
double Motion::round_coordinate(const DdBall& rough, GenId g, int which) {
  if (options_.filters && rounds_to_leading(rough)) return rough.hi;
  const auto of_last = [this](const FixedBall& a) {
    Ball b;
    workspace_.arithmetic.view(a).get(b, workspace_.time_scale, bits_at(0));
    return b;
  };
  const BallState& b = ball_state(g);
  const Ball value = which == 0   ? b.x + b.vx * of_last(workspace_.s)
                     : which == 1 ? b.y + b.vy * of_last(workspace_.s)
                     : which == 2 ? b.vx
                     : which == 3 ? b.vy
                                  : of_last(workspace_.now);
  double out = 0;
  if (value.round_to_double(out)) return out;
  // Either a number on a rounding boundary (zero and short dyadic numbers are), or
  // not enough bits: ask the exact state first, it is the only proof of a tie.
  ExactMotion exact(*this);
  const int id = state_[g + 1];
  const ExactMotion::State& s = exact.state(id, g);
  const Tower& start = exact.start(id, g);
  const Tower dt = start - Tower(s.t_ref);
  switch (which) {
    case 0:
      return round_nearest(s.x + s.vx * dt);
    case 1:
      return round_nearest(s.y + s.vy * dt);
    case 2:
      return round_nearest(s.vx);
    case 3:
      return round_nearest(s.vy);
    default:
      return round_nearest(start);
  }
}

Impact Motion::collide(GenId i, GenId j, double t_near) {
  if (i != container_id && sgn(input_.disks[i].radius) == 0 && sgn(input_.disks[j].radius) == 0) {
    throw Undecided("two points meet: a contact without a normal, which the model does not cover",
                    i, j);
  }
  const Record record{i, j, state_[i + 1], state_[j + 1], t_near, -1};
  const int id = static_cast<int>(log_.size());
  log_.push_back(record);
  respond(record);
  // Two disks of one record are told apart by the sign of the generator's slot.
  if (i != container_id) state_[i + 1] = id + 1;
  state_[j + 1] = id + 1;
  while (!accurate_enough(i) || !accurate_enough(j)) {
    if (!raise_for(t_near)) {
      throw Undecided("the state after the collision needs more than " +
                      std::to_string(options_.max_bits) + " bits");
    }
    log_.pop_back();
    replay();
    log_.push_back(record);
    respond(record);
  }
  if (i != container_id) refresh(i);
  refresh(j);
  Impact out{};
  const auto round_all = [&] {
    const Workspace& w = workspace_;
    out.time_dd = dd_of(w.arithmetic.view(w.now), w.time_scale);
    out.t = round_coordinate(out.time_dd, j, 4);
    const DdBall delay = dd_of(w.arithmetic.view(w.s), w.time_scale);
    const auto state = [&](GenId g) {
      const DdMotion m = double_doubles(g);
      return RoundedState{round_coordinate(m.x + m.vx * delay, g, 0),
                          round_coordinate(m.y + m.vy * delay, g, 1), round_coordinate(m.vx, g, 2),
                          round_coordinate(m.vy, g, 3)};
    };
    if (i != container_id) out.first = state(i);
    out.second = state(j);
  };
  for (;;) {
    try {
      round_all();
      break;
    } catch (const BudgetExceeded& budget) {
      // Not provably on a boundary: more bits will tell, up to the limit.
      if (bits_at(horizon_) >= options_.max_bits) {
        throw Undecided(std::string("a coordinate after the collision may lie on a rounding "
                                    "boundary: ") +
                        budget.what());
      }
      goal_bits_ = std::min(2 * goal_bits_, options_.max_bits - kHeadroom);
      log_.pop_back();
      replay();
      log_.push_back(record);
      respond(record);
      if (i != container_id) refresh(i);
      refresh(j);
    }
  }
  double lo = 0, hi = 0;
  enclose(out.time_dd, lo, hi);
  out.time = DoubleBall::hull(lo, hi);
  return out;
}

RoundedState Motion::maneuver(GenId g, const Rational& t, const Rational& vx, const Rational& vy) {
  const double t_ref = round_nearest(t);
  maneuvers_.push_back({t, vx, vy});
  v_scale_ = std::max({v_scale_, exponent_of(vx), exponent_of(vy)});
  const Record record{
      g, g, state_[g + 1], state_[g + 1], t_ref, static_cast<int>(maneuvers_.size()) - 1};
  RoundedState out{0, 0, round_nearest(vx), round_nearest(vy)};
  for (;;) {
    const Ball::Precision bits = bits_at(t_ref);
    const Site<Ball> at = site(g, Ball(t, bits));
    if (at.x.round_to_double(out.px) && at.y.round_to_double(out.py)) break;
    try {
      ExactMotion exact(*this);
      const Site<Tower> s = exact.site(g, Tower(t));
      out.px = round_nearest(s.x);
      out.py = round_nearest(s.y);
      break;
    } catch (const BudgetExceeded& budget) {
      if (!raise_precision()) {
        throw Undecided(std::string("the position at the maneuver may lie on a rounding "
                                    "boundary: ") +
                        budget.what());
      }
    }
  }
  const int id = static_cast<int>(log_.size());
  log_.push_back(record);
  apply_maneuver(record);
  state_[g + 1] = id + 1;
  refresh(g);
  return out;
}

void Motion::restart(GenId g, const Rational& t, const Rational& x, const Rational& y,
                     const Rational& vx, const Rational& vy) {
  if (state_[g + 1] > 0) throw std::logic_error("restart after a computed motion");
  DiskInput& d = input_.disks[g];
  given_[g] = nullptr;
  start_[g] = round_nearest(t);
  const Rational ahead = to_rational(start_[g]) - t;
  const bool at_once = sgn(ahead) == 0;
  d.x = at_once ? x : Rational(x + vx * ahead);
  d.y = at_once ? y : Rational(y + vy * ahead);
  d.vx = vx;
  d.vy = vy;
  v_scale_ = std::max({v_scale_, exponent_of(vx), exponent_of(vy)});
  doubles_[g + 1].t = start_[g];
  balls_[g + 1].reset();
  set_state(g, dd_of(d.x), dd_of(d.y), dd_of(d.vx), dd_of(d.vy));
}

void Motion::restart(GenId g, double t, const DdBall& x, const DdBall& y, double vx, double vy,
                     const GivenMotion& given) {
  if (state_[g + 1] > 0) throw std::logic_error("restart after a computed motion");
  given_[g] = &given;
  start_[g] = doubles_[g + 1].t = t;
  balls_[g + 1].reset();
  set_state(g, x, y, DdBall(vx), DdBall(vy));
}

Impact Motion::collide_in_doubles(GenId i, GenId j, double t) {
  DoubleMotion& a = doubles_[i + 1];
  DoubleMotion& b = doubles_[j + 1];
  for (DoubleMotion* m : {&a, &b}) {
    if (m == &a && i == container_id) continue;
    m->x += m->vx * (t - m->t);
    m->y += m->vy * (t - m->t);
    m->t = t;
  }
  const double nx = b.x - a.x, ny = b.y - a.y;
  const double reach = a.r + b.r;
  const double q = ((b.vx - a.vx) * nx + (b.vy - a.vy) * ny) / (reach * reach);
  const int id = static_cast<int>(++plain_collisions_);
  if (i == container_id) {
    const double e = input_.container_restitution.get_d();
    if (input_.whole_container_law) {
      b.vx = e * (b.vx - 2 * q * nx);
      b.vy = e * (b.vy - 2 * q * ny);
    } else {
      b.vx -= (1 + e) * q * nx;
      b.vy -= (1 + e) * q * ny;
    }
  } else {
    const double mi = round_nearest(input_.disks[i].mass), mj = round_nearest(input_.disks[j].mass);
    const double k = (1 + plain_restitution_) * q / (mi + mj);
    a.vx += k * mj * nx;
    a.vy += k * mj * ny;
    b.vx -= k * mi * nx;
    b.vy -= k * mi * ny;
    state_[i + 1] = id;
  }
  state_[j + 1] = id;
  return {t, DoubleBall(t), DdBall(t), {a.x, a.y, a.vx, a.vy}, {b.x, b.y, b.vx, b.vy}};
}

RoundedState Motion::maneuver_in_doubles(GenId g, double t, double vx, double vy) {
  DoubleMotion& m = doubles_[g + 1];
  m.x += m.vx * (t - m.t);
  m.y += m.vy * (t - m.t);
  m.t = t;
  m.vx = vx;
  m.vy = vy;
  state_[g + 1] = static_cast<int>(++plain_collisions_);
  return {m.x, m.y, vx, vy};
}

ExactMotion::ExactMotion(const Motion& motion)
    : motion_(motion),
      field_(RadicalField::Budget{
          motion.options().max_radicals,
          std::min(kMaxCoefficientBits, static_cast<std::size_t>(motion.options().max_bits) * 4)}) {
}

const ExactMotion::State& ExactMotion::state(GenId g) {
  return entry(motion_.state_id(g), g).state;
}
const ExactMotion::State& ExactMotion::state(int id, GenId g) { return entry(id, g).state; }
const Tower& ExactMotion::start(int id, GenId g) { return entry(id, g).start; }

Tower ExactMotion::radius(GenId g) const {
  const MotionInput& in = motion_.input();
  return g == container_id ? Tower(Rational(-in.container_radius))
                           : Tower(Rational(in.disks[g].radius));
}

const ExactMotion::Entry& ExactMotion::entry(int id, GenId g) {
  const long key = static_cast<long>(id) * (motion_.size() + 1) + (g + 1);
  if (const auto it = memo_.find(key); it != memo_.end()) return it->second;
  const MotionInput& in = motion_.input();
  if (id <= 0) {
    Entry e;
    if (g == container_id) {
      e.state = {0, Tower(in.container_x), Tower(in.container_y), 0, 0};
    } else {
      const DiskInput& d = motion_.initial_state(g);
      const Rational start = to_rational(motion_.start_[g]);
      e.state = {start, Tower(d.x.value()), Tower(d.y.value()), Tower(d.vx.value()),
                 Tower(d.vy.value())};
      e.start = Tower(start);
    }
    return memo_[key] = e;
  }
  // The records of the causal past that are not known yet, oldest first, found
  // without recursion: a past can be long.
  std::vector<int> pending{id - 1};
  std::vector<int> order;
  std::unordered_map<int, bool> seen{{id - 1, true}};
  while (!pending.empty()) {
    const int record = pending.back();
    pending.pop_back();
    order.push_back(record);
    const Motion::Record& r = motion_.log_[record];
    for (const int before : {r.before_i, r.before_j}) {
      if (before > 0 && seen.emplace(before - 1, true).second) pending.push_back(before - 1);
    }
  }
  std::sort(order.begin(), order.end());
  for (const int record : order) {
    const Motion::Record& r = motion_.log_[record];
    const long done = static_cast<long>(record + 1) * (motion_.size() + 1) + (r.j + 1);
    if (!memo_.contains(done)) compute(record);
  }
  return memo_.at(key);
}

void ExactMotion::compute(int record) {
  const Motion::Record& r = motion_.log_[record];
  const MotionInput& in = motion_.input();
  const long slots = motion_.size() + 1;
  const long base = static_cast<long>(record + 1) * slots;
  const Rational t_ref = to_rational(r.t_ref);
  if (r.maneuver >= 0) {
    const Motion::ManeuverRecord& m = motion_.maneuvers_[r.maneuver];
    const State before = entry(r.before_i, r.i).state;
    const Tower back = Tower(Rational(m.t - before.t_ref));
    const Tower ahead = Tower(Rational(m.t - t_ref));
    const Tower vx(m.vx), vy(m.vy);
    memo_[base + r.i + 1] = {{t_ref, before.x + before.vx * back - vx * ahead,
                              before.y + before.vy * back - vy * ahead, vx, vy},
                             Tower(m.t)};
    return;
  }
  const bool wall = r.i == container_id;
  const State bi = entry(r.before_i, r.i).state;
  const State bj = entry(r.before_j, r.j).state;
  const auto at = [&](const State& s, GenId g) {
    const Tower dt(Rational(t_ref - s.t_ref));
    return MovingSite<Tower>{s.x + s.vx * dt, s.y + s.vy * dt, s.vx, s.vy, radius(g)};
  };
  const MovingSite<Tower> mi = at(bi, r.i);
  const MovingSite<Tower> mj = at(bj, r.j);
  const Contact<Tower> contact(mi, mj);
  const Tower s = contact_delay(contact, wall, field_);
  const Tower nx = mj.x - mi.x + (mj.vx - mi.vx) * s;
  const Tower ny = mj.y - mi.y + (mj.vy - mi.vy) * s;
  const Tower reach = mi.r + mj.r;
  // w.n = b + a s.
  const Tower q = (contact.b + contact.a * s) / (reach * reach);
  const auto restart = [&](const MovingSite<Tower>& m, GenId g, const Tower& vx, const Tower& vy) {
    memo_[base + g + 1] = {{t_ref, m.x + (m.vx - vx) * s, m.y + (m.vy - vy) * s, vx, vy},
                           Tower(t_ref) + s};
  };
  if (wall) {
    const Rational& e = in.container_restitution;
    if (in.whole_container_law) {
      const Tower scale(e);
      restart(mj, r.j, scale * (mj.vx - (q + q) * nx), scale * (mj.vy - (q + q) * ny));
    } else {
      const Tower k = q * Tower(Rational(1 + e));
      restart(mj, r.j, mj.vx - k * nx, mj.vy - k * ny);
    }
    return;
  }
  const Rational m1 = in.disks[r.i].mass;
  const Rational m2 = in.disks[r.j].mass;
  const Tower k1 = q * Tower(Rational((1 + in.restitution) * m2 / (m1 + m2)));
  const Tower k2 = q * Tower(Rational((1 + in.restitution) * m1 / (m1 + m2)));
  restart(mi, r.i, mi.vx + k1 * nx, mi.vy + k1 * ny);
  restart(mj, r.j, mj.vx - k2 * nx, mj.vy - k2 * ny);
}

MovingSite<Tower> ExactMotion::moving_site(GenId g, const Rational& t) {
  const State& s = state(g);
  const Tower dt(Rational(t - s.t_ref));
  return {s.x + s.vx * dt, s.y + s.vy * dt, s.vx, s.vy, radius(g)};
}

Site<Tower> ExactMotion::site(GenId g, const Tower& t) {
  const State& s = state(g);
  const Tower dt = t - Tower(s.t_ref);
  return {s.x + s.vx * dt, s.y + s.vy * dt, radius(g)};
}

Tower contact_delay(const Contact<Tower>& contact, bool with_container, RadicalField& field) {
  const Tower root = field.sqrt(contact.b * contact.b - contact.a * contact.c);
  if (with_container) return (root - contact.b) / contact.a;
  return contact.c / (root - contact.b);
}

double round_nearest(const Tower& x) {
  if (x.is_rational()) return round_nearest(x.rational());
  const auto [lo, hi] = double_interval(x);
  if (lo == hi) return lo;
  const Rational middle = (to_rational(lo) + to_rational(hi)) / 2;
  const Sign side = sign(x - Tower(middle));
  if (side == Sign::negative) return lo;
  if (side == Sign::positive) return hi;
  return round_nearest(middle);
}

}  // namespace voroproof
