#include "filtered/motion.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace voroproof {

namespace {

// The bits by which a state must be known below the scale of the scene: enough for
// the double-double filter to be limited by its own arithmetic.
constexpr int kInitialGoal = 112;
// Bits of the balls beyond the goal: what the last few collisions before the
// horizon may lose.
constexpr int kHeadroom = 48;

std::int64_t exponent_of(const Rational& q) {
  const double d = std::fabs(round_nearest(q));
  return d == 0 ? -1000 : std::ilogb(d) + 1;
}

// The nearest double below in magnitude, and what is left of it.
DdBall dd_of(const Rational& q) {
  const double first = q.get_d();
  const Rational rest = q - to_rational(first);
  if (sgn(rest) == 0) return {first};
  const double second = rest.get_d();
  DdBall b;
  dd_detail::fast_two_sum(first, second, b.hi, b.lo);
  b.rad = std::fabs(second) * 0x1p-52 + DBL_MIN;  // get_d() rounds towards zero
  return b;
}

// Of exact arithmetic, which is slow far sooner than balls are.
constexpr std::size_t kMaxCoefficientBits = 1 << 16;

DdBall dd_of(const Ball& b) {
  DdBall r;
  b.to_double_double(r.hi, r.lo, r.rad);
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
    : input_(std::move(input)), options_(options) {
  horizon_ = round_up(input_.horizon);
  goal_bits_ = std::min(kInitialGoal, std::max(options_.max_bits - kHeadroom, 64));
  // A smaller or larger start is a larger or smaller first supply per time.
  const double supply = options_.start_bits - goal_bits_ - kHeadroom;
  slope_ = supply > 0 && horizon_ > 0 ? supply / horizon_ : 0;
  x_scale_ = exponent_of(input_.container_radius);
  v_scale_ = -1000;
  for (const DiskInput& d : input_.disks) {
    v_scale_ = std::max({v_scale_, exponent_of(d.vx), exponent_of(d.vy)});
  }
  const std::size_t n = input_.disks.size();
  state_.resize(n + 1);
  t_ref_.assign(n + 1, 0.0);
  start_.assign(n, 0.0);
  given_.assign(n, nullptr);
  doubles_.resize(n + 1);
  dds_.resize(n + 1);
  balls_.resize(n + 1);
  stale_.assign(n + 1, 0);
  radius_.resize(n + 1);
  mass_.resize(n + 1);
  for (std::size_t g = 0; g <= n; ++g) state_[g] = -static_cast<int>(g);
  load_initial_states();
  for (std::size_t g = 0; g <= n; ++g) refresh(static_cast<GenId>(g) - 1);
  plain_restitution_ = input_.restitution.get_d();
  for (const DiskInput& d : input_.disks) plain_mass_.push_back(d.mass.get_d());
}

int Motion::bits_at(double t) const {
  const double ahead = std::max(0.0, horizon_ - t) * slope_;
  const double bits =
      std::min<double>(goal_bits_ + kHeadroom + ahead, static_cast<double>(options_.max_bits));
  // Whole limbs: the balls at hand keep their memory from one collision to the next.
  return (static_cast<int>(bits) + 63) / 64 * 64;
}

void Motion::load_initial_states() {
  const Ball::Precision bits = bits_at(0);
  for (GenId g = container_id; g < size(); ++g) load_initial_state(g, bits);
}

void Motion::load_initial_state(GenId g, Ball::Precision bits) {
  balls_[g + 1] = initial_balls(g, bits);
  stale_[g + 1] = 0;
  if (g == container_id) {
    t_ref_[0] = 0;
    radius_[0] = dyadic_or_rounded(Rational(-input_.container_radius), bits);
  } else {
    const DiskInput& d = initial_state(g);
    t_ref_[g + 1] = start_[g];
    radius_[g + 1] = dyadic_or_rounded(d.radius, bits);
    mass_[g + 1] = dyadic_or_rounded(d.mass, bits);
  }
  dds_[g + 1].r = dd_of(radius_[g + 1]);
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
  if (stale_[g + 1] != 0) {
    balls_[g + 1] = initial_balls(g, bits_at(start_[g]));
    stale_[g + 1] = 0;
  }
  return balls_[g + 1];
}

// Makes double-doubles and doubles, with their error bounds, from the balls.
void Motion::refresh(GenId g) {
  const BallState& s = balls_[g + 1];
  DdMotion& dd = dds_[g + 1];
  dd = {dd_of(s.x), dd_of(s.y), dd_of(s.vx), dd_of(s.vy), dd.r};
  refresh_doubles(g);
}

void Motion::refresh_doubles(GenId g) {
  const DdMotion& dd = dds_[g + 1];
  DoubleMotion& m = doubles_[g + 1];
  m.t = t_ref_[g + 1];
  m.x = dd.x.hi;
  m.y = dd.y.hi;
  m.vx = dd.vx.hi;
  m.vy = dd.vy.hi;
  m.r = dd.r.hi;
  const auto error = [](const DdBall& b) { return (std::fabs(b.lo) + b.rad) * (1 + 0x1p-50); };
  m.ex = std::fmax(error(dd.x), error(dd.y));
  m.ev = std::fmax(error(dd.vx), error(dd.vy));
  m.er = error(dd.r);
}

Site<DoubleBall> Motion::site(GenId g, const DoubleBall& t) const {
  const DoubleMotion& m = doubles_[g + 1];
  const DoubleBall dt = t - DoubleBall(m.t);
  return {DoubleBall(m.x, m.ex) + DoubleBall(m.vx, m.ev) * dt,
          DoubleBall(m.y, m.ex) + DoubleBall(m.vy, m.ev) * dt, DoubleBall(m.r, m.er)};
}

Site<DdBall> Motion::site(GenId g, const DdBall& t) const {
  const DdMotion& m = dds_[g + 1];
  const DdBall dt = t - DdBall(t_ref_[g + 1]);
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
  const DdMotion& m = dds_[g + 1];
  const Site<DdBall> s = site(g, t);
  return {s.x, s.y, m.vx, m.vy, s.r};
}

MovingSite<Ball> Motion::moving_site(GenId g, const Ball& t) const {
  const BallState& m = ball_state(g);
  // Short exact numbers are held in few bits: everything at the precision of the time.
  const auto bits = t.precision();
  const Ball dt = t - Ball(t_ref_[g + 1], bits);
  return {m.x + m.vx * dt, m.y + m.vy * dt, m.vx.at_precision(bits), m.vy.at_precision(bits),
          radius_[g + 1].at_precision(bits)};
}

bool Motion::same_velocity(GenId a, GenId b) const {
  // The leading parts differ nearly always.
  if (doubles_[a + 1].vx != doubles_[b + 1].vx || doubles_[a + 1].vy != doubles_[b + 1].vy) {
    return false;
  }
  const DdMotion& m = dds_[a + 1];
  const DdMotion& o = dds_[b + 1];
  const auto same = [](const DdBall& p, const DdBall& q) {
    return p.rad == 0 && q.rad == 0 && p.hi == q.hi && p.lo == q.lo;
  };
  return same(m.vx, o.vx) && same(m.vy, o.vy);
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

const Motion::Response& Motion::respond(const Record& r) {
  const Ball::Precision bits = bits_at(r.t_ref);
  Workspace& m = workspace_;
  Response& out = m.out;
  Ball &dt = m.balls[0], &term = m.balls[1], &dx = m.balls[2], &dy = m.balls[3], &wx = m.balls[4],
       &wy = m.balls[5], &a = m.balls[6], &b = m.balls[7], &c = m.balls[8], &root = m.balls[9],
       &s = m.balls[10], &reach = m.balls[11], &reach2 = m.balls[12], &nx = m.balls[13],
       &ny = m.balls[14], &k = m.balls[15], &kx = m.balls[16], &ky = m.balls[17], &ix = m.balls[18],
       &iy = m.balls[19];
  auto& x = m.x;
  auto& y = m.y;
  const bool wall = r.i == container_id;
  Ball::set(m.now, r.t_ref);
  // Centres and velocities at the reference time; with the container at rest,
  // the offset runs from it to the disk j.
  for (int k = 0; k < 2; ++k) {
    const GenId g = k == 0 ? r.i : r.j;
    const BallState& s = balls_[g + 1];
    if (g == container_id) {
      x[k] = s.x;
      y[k] = s.y;
      continue;
    }
    Ball::set(m.then, t_ref_[g + 1]);
    Ball::sub(dt, m.now, m.then, bits);
    Ball::mul(term, s.vx, dt, bits);
    Ball::add(x[k], s.x, term, bits);
    Ball::mul(term, s.vy, dt, bits);
    Ball::add(y[k], s.y, term, bits);
  }
  BallState& si = balls_[r.i + 1];
  BallState& sj = balls_[r.j + 1];
  Ball::sub(dx, x[1], x[0], bits);
  Ball::sub(dy, y[1], y[0], bits);
  Ball::sub(wx, sj.vx, si.vx, bits);
  Ball::sub(wy, sj.vy, si.vy, bits);
  Ball::add(reach, radius_[r.i + 1], radius_[r.j + 1], bits);
  Ball::sqr(reach2, reach, bits);
  Ball::sqr(a, wx, bits);
  Ball::sqr(term, wy, bits);
  Ball::add(a, a, term, bits);
  Ball::mul(b, dx, wx, bits);
  Ball::mul(term, dy, wy, bits);
  Ball::add(b, b, term, bits);
  Ball::sqr(c, dx, bits);
  Ball::sqr(term, dy, bits);
  Ball::add(c, c, term, bits);
  Ball::sub(c, c, reach2, bits);
  Ball::sqr(root, b, bits);
  Ball::mul(term, a, c, bits);
  Ball::sub(root, root, term, bits);
  Ball::sqrt(root, root, bits);
  if (!wall) {
    Ball::sub(term, root, b, bits);  // b < 0: they approach
    Ball::div(s, c, term, bits);
  } else if (b.sign() == Sign::positive) {
    Ball::add(term, b, root, bits);
    Ball::div(s, c, term, bits);
    Ball::neg(s, s);
  } else {
    Ball::sub(term, root, b, bits);
    Ball::div(s, term, a, bits);
  }
  Ball::add(out.time, m.now, s, bits);
  // n = d + w s; w.n is -root at the contact of two disks, +root at the wall.
  Ball::mul(term, wx, s, bits);
  Ball::add(nx, dx, term, bits);
  Ball::mul(term, wy, s, bits);
  Ball::add(ny, dy, term, bits);
  const auto position = [&](int side, const BallState& state) {
    Ball::mul(term, state.vx, s, bits);
    Ball::add(out.px[side], x[side], term, bits);
    Ball::mul(term, state.vy, s, bits);
    Ball::add(out.py[side], y[side], term, bits);
  };
  // New velocity (state += (kx, ky)), then the centre that the new line had or will
  // have at the reference time: x_ref - change * s.
  const auto restart = [&](int side, BallState& state, const Ball& cx, const Ball& cy) {
    Ball::add(state.vx, state.vx, cx, bits);
    Ball::add(state.vy, state.vy, cy, bits);
    Ball::mul(term, cx, s, bits);
    Ball::sub(state.x, x[side], term, bits);
    Ball::mul(term, cy, s, bits);
    Ball::sub(state.y, y[side], term, bits);
  };
  if (wall) {
    position(1, sj);
    const Rational& e = input_.container_restitution;
    if (input_.whole_container_law) {
      // v' - v = (e - 1) v - 2 e (root / reach^2) n
      Ball::div(k, root, reach2, bits);
      Ball::mul(k, k, Ball(Rational(2 * e), bits), bits);
      const Ball keep(Rational(e - 1), bits);
      Ball::mul(kx, sj.vx, keep, bits);
      Ball::mul(ky, sj.vy, keep, bits);
      Ball::mul(term, k, nx, bits);
      Ball::sub(kx, kx, term, bits);
      Ball::mul(term, k, ny, bits);
      Ball::sub(ky, ky, term, bits);
    } else {
      Ball::div(k, root, reach2, bits);
      Ball::mul(k, k, Ball(Rational(-(1 + e)), bits), bits);
      Ball::mul(kx, k, nx, bits);
      Ball::mul(ky, k, ny, bits);
    }
    restart(1, sj, kx, ky);
  } else {
    position(0, si);
    Ball::add(out.px[1], out.px[0], nx, bits);
    Ball::add(out.py[1], out.py[0], ny, bits);
    // v_i += m_j K n, v_j -= m_i K n, K = -(1 + sigma) root / ((m_i + m_j) reach^2).
    Ball::add(term, mass_[r.i + 1], mass_[r.j + 1], bits);
    Ball::mul(term, term, reach2, bits);
    Ball::div(k, root, term, bits);
    const Rational law = -(1 + input_.restitution);
    Ball::mul(k, k, Ball(law, law == -2 ? 2 : bits), bits);
    Ball::mul(nx, k, nx, bits);
    Ball::mul(ny, k, ny, bits);
    Ball::mul(ix, mass_[r.j + 1], nx, bits);
    Ball::mul(iy, mass_[r.j + 1], ny, bits);
    Ball::mul(kx, mass_[r.i + 1], nx, bits);
    Ball::mul(ky, mass_[r.i + 1], ny, bits);
    Ball::neg(kx, kx);
    Ball::neg(ky, ky);
    restart(0, si, ix, iy);
    restart(1, sj, kx, ky);
    t_ref_[r.i + 1] = r.t_ref;
  }
  t_ref_[r.j + 1] = r.t_ref;
  return out;
}

void Motion::apply_maneuver(const Record& r) {
  const Ball::Precision bits = bits_at(r.t_ref);
  const ManeuverRecord& m = maneuvers_[r.maneuver];
  BallState& s = balls_[r.i + 1];
  const Ball before(Rational(m.t - to_rational(t_ref_[r.i + 1])), bits);
  const Ball after(Rational(m.t - to_rational(r.t_ref)), bits);
  const Ball vx = dyadic_or_rounded(m.vx, bits);
  const Ball vy = dyadic_or_rounded(m.vy, bits);
  s.x = s.x + s.vx * before - vx * after;
  s.y = s.y + s.vy * before - vy * after;
  s.vx = vx;
  s.vy = vy;
  t_ref_[r.i + 1] = r.t_ref;
}

bool Motion::accurate_enough(GenId g) const {
  if (g == container_id) return true;
  const BallState& s = balls_[g + 1];
  const auto fine = [this](const Ball& b, std::int64_t scale) {
    return b.is_exact() || scale - b.radius().exponent() >= goal_bits_;
  };
  return fine(s.x, x_scale_) && fine(s.y, x_scale_) && fine(s.vx, v_scale_) && fine(s.vy, v_scale_);
}

void Motion::replay() {
  ++replays_;
  load_initial_states();
  for (const Record& r : log_) {
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
  slope_ = std::max({1.3 * rate, 1.4 * slope_, horizon_ > 0 ? 32 / horizon_ : 0});
  return true;
}

bool Motion::raise_precision() {
  if (bits_at(horizon_) >= options_.max_bits) return false;
  goal_bits_ = std::min(2 * goal_bits_, options_.max_bits - kHeadroom);
  replay();
  return true;
}

double Motion::round_coordinate(const Ball& value, GenId g, int which) {
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
  if (radius_[i + 1].sign() == Sign::zero && radius_[j + 1].sign() == Sign::zero) {
    throw Undecided("two points meet: a contact without a normal, which the model does not cover",
                    i, j);
  }
  const Record record{i, j, state_[i + 1], state_[j + 1], t_near, -1};
  const int id = static_cast<int>(log_.size());
  log_.push_back(record);
  const Response& response = respond(record);
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
    out.t = round_coordinate(response.time, j, 4);
    const auto state = [&](GenId g, int side) {
      const BallState& s = balls_[g + 1];
      return RoundedState{round_coordinate(response.px[side], g, 0),
                          round_coordinate(response.py[side], g, 1), round_coordinate(s.vx, g, 2),
                          round_coordinate(s.vy, g, 3)};
    };
    if (i != container_id) out.first = state(i, 0);
    out.second = state(j, 1);
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
  response.time.to_interval(lo, hi);
  out.time = DoubleBall::hull(lo, hi);
  out.time_dd = dd_of(response.time);
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
  t_ref_[g + 1] = start_[g];
  DdMotion& dd = dds_[g + 1];
  dd = {dd_of(d.x), dd_of(d.y), dd_of(d.vx), dd_of(d.vy), dd.r};
  stale_[g + 1] = 1;
  refresh_doubles(g);
}

void Motion::restart(GenId g, double t, const DdBall& x, const DdBall& y, double vx, double vy,
                     const GivenMotion& given) {
  if (state_[g + 1] > 0) throw std::logic_error("restart after a computed motion");
  given_[g] = &given;
  start_[g] = t_ref_[g + 1] = t;
  DdMotion& dd = dds_[g + 1];
  dd = {x, y, DdBall(vx), DdBall(vy), dd.r};
  stale_[g + 1] = 1;
  refresh_doubles(g);
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
    const double mi = plain_mass_[i], mj = plain_mass_[j];
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
  return g == container_id ? Tower(Rational(-in.container_radius)) : Tower(in.disks[g].radius);
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
      e.state = {start, Tower(d.x), Tower(d.y), Tower(d.vx), Tower(d.vy)};
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
  const Rational& m1 = in.disks[r.i].mass;
  const Rational& m2 = in.disks[r.j].mass;
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
