#include "filtered/motion/motion.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "exact/collision_response.h"
#include "filtered/motion/enclosures.h"
#include "filtered/motion/exact_motion.h"

namespace voroproof::internal {

namespace {

// The number of collisions that are handed to the second thread at a time: few enough for a disk to
// collide seldom more than a few times meanwhile, each of which costs some six bits.
constexpr std::size_t kLateBatch = 32;
// Double-doubles are good enough for a state, meanwhile, that they know to so many bits below the
// scale of the scene.
constexpr int kLateBits = 66;
// Where they do not know so many bits more, they are made anew as soon as better states are there.
constexpr int kSpareBits = 16;

bool is_double(const DdBall& b) { return b.lo == 0 && b.rad == 0; }

}  // namespace

Motion::Motion(MotionInput input, MotionOptions options, std::shared_ptr<MotionLog> log)
    : options_(options),
      states_(std::make_unique<MotionStates>(std::move(input), options, std::move(log))) {
  const std::size_t n = this->input().disks.size();
  state_.resize(n + 1);
  doubles_.resize(n + 1);
  seconds_.resize(n + 1);
  for (GenId g = container_id; g < size(); ++g) {
    state_[g + 1] = -1 - g;
    set_radius(g, states_->radius_dd(g));
    refresh(g);
  }
  const Rational& e = this->input().container_restitution;
  disk_law_ = dd_of(Rational(1 + this->input().restitution));
  wall_law_ = dd_of(this->input().whole_container_law ? e : Rational(1 + e));
  for (const int axis : {0, 1}) {
    origin_[axis] = dd_of(this->input().origin[axis]);
    moved_ = moved_ || sgn(this->input().origin[axis]) != 0;
  }
}

// Double-doubles may stay behind.
const MotionStates& Motion::full_states() const {
  states_->apply_rest();
  return *states_;
}

void Motion::settle() {
  states_->apply_rest();
  take_over();
}

Ball Motion::radius_ball(GenId g, Ball::Precision bits) const {
  const DdBall near = radius(g);
  if (is_double(near)) return Ball(near.hi, bits);
  return Ball(
      g == container_id ? Rational(-input().container_radius) : input().disks[g].radius.value(),
      bits);
}

// Makes double-doubles and doubles, with their error bounds, from the state in force.
void Motion::refresh(GenId g) {
  const MotionStates::State<DdBall> s = states_->double_doubles(g);
  set_state(g, s.x, s.y, s.vx, s.vy);
}

// Refreshes the states that collide_ahead() left and of which better ones are there by now.
// Precondition: the second thread has been waited for.
void Motion::take_over() {
  const double x_error = std::ldexp(error_of_length(), -kSpareBits);
  const double v_error = std::ldexp(error_of_speed(), -kSpareBits);
  for (; taken_over_ < states_->progress().applied; ++taken_over_) {
    const Record& r = states_->record(taken_over_);
    for (const GenId g : {r.i, r.j}) {
      if (state_[g + 1] != static_cast<int>(taken_over_) + 1) continue;
      if (seconds(g).ex > x_error || seconds(g).ev > v_error) refresh(g);
    }
  }
}

// How far a state in double-doubles may be off after collide_ahead().
double Motion::error_of_length() const {
  return std::ldexp(1.0, static_cast<int>(states_->x_scale()) - kLateBits);
}
double Motion::error_of_speed() const {
  return std::ldexp(1.0, static_cast<int>(states_->v_scale()) - kLateBits);
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
  radii_are_doubles_ = radii_are_doubles_ && r.lo == 0 && r.rad == 0;
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
  const MotionStates::State<Ball>& m = full_states().balls(g, doubles(g).t);
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
    const Record& r = states_->record(id - 1);
    if (r.maneuver < 0) return false;
    id = r.before_i;
  }
  return true;
}

Motion::Origin Motion::origin(GenId g, int id) const {
  const Record& r = states_->record(id - 1);
  if (r.maneuver >= 0) return {r.before_i, &states_->maneuver(r.maneuver), g, 0};
  if (g == r.i) return {r.before_i, nullptr, r.j, r.before_j};
  return {r.before_j, nullptr, r.i, r.before_i};
}

bool Motion::raise_precision() {
  settle();
  if (!states_->raise_goal()) return false;
  for (GenId g = container_id; g < size(); ++g) refresh(g);
  return true;
}

void Motion::append(const Record& r) {
  states_->append(r);
  for (const GenId g : {r.i, r.j}) {
    if (g == container_id) continue;
    state_[g + 1] = records();
    doubles_[g + 1].t = r.t_ref;
  }
}

Impact Motion::collide(GenId i, GenId j, double t_near) {
  const auto is_point = [&](GenId g) {
    return g != container_id && sgn(input().disks[g].radius) == 0;
  };
  if (is_point(i) && is_point(j)) {
    throw Undecided("two points meet: a contact without a normal, which the model does not cover",
                    i, j);
  }
  const Record r{i, j, state_[i + 1], state_[j + 1], doubles(i).t, doubles(j).t, t_near, -1};
  std::optional<Impact> impact = collide_ahead(r);
  if (!impact) impact = collide_now(r);
  double lo = 0, hi = 0;
  enclose(impact->time_dd, lo, hi);
  impact->time = DoubleBall::hull(lo, hi);
  return *impact;
}

// Collides by the states beyond double-doubles, once all of these are there.
Impact Motion::collide_now(const Record& r) {
  append(r);
  settle();
  if (r.i != container_id) refresh(r.i);
  refresh(r.j);
  const auto round_all = [&] {
    Impact out{};
    out.time_dd = states_->last_time();
    out.t = round_coordinate(out.time_dd, r.j, 4);
    const DdBall delay = states_->last_delay();
    const auto state = [&](GenId g) {
      const DdMotion m = double_doubles(g);
      return RoundedState{round_coordinate(m.x + m.vx * delay, g, 0),
                          round_coordinate(m.y + m.vy * delay, g, 1), round_coordinate(m.vx, g, 2),
                          round_coordinate(m.vy, g, 3)};
    };
    if (r.i != container_id) out.first = state(r.i);
    out.second = state(r.j);
    return out;
  };
  for (;;) {
    try {
      return round_all();
    } catch (const BudgetExceeded& budget) {
      // Not provably on a boundary: more bits will tell, up to the limit.
      if (!raise_precision()) {
        throw Undecided(std::string("a coordinate after the collision may lie on a rounding "
                                    "boundary: ") +
                        budget.what());
      }
    }
  }
}

// Collides by double-doubles; returns nothing where these do not tell enough. How many collisions
// the other states stay behind does not depend on how fast the threads are, so all that follows is
// the same each time.
std::optional<Impact> Motion::collide_ahead(const Record& r) {
  // Where bits run out a run stops at the collision that needs them, not some collisions later.
  if (!options_.late_states || !options_.filters || !states_->has_spare_bits()) return std::nullopt;
  const bool wall = r.i == container_id;
  const MovingSite<DdBall> i = moving_site(r.i, DdBall(r.t_ref));
  const MovingSite<DdBall> j = moving_site(r.j, DdBall(r.t_ref));
  const Contact<DdBall> contact(i, j);
  const DdBall root = sqrt(contact.b * contact.b - contact.a * contact.c);
  const DdBall delay = !wall              ? contact.c / (root - contact.b)
                       : contact.b.hi > 0 ? -contact.c / (contact.b + root)
                                          : (root - contact.b) / contact.a;
  const CollisionResponse<DdBall> response(i, j, contact, delay);
  MovingSite<DdBall> after[2];
  if (!wall) {
    const DdBall mi = dd_of(input().disks[r.i].mass), mj = dd_of(input().disks[r.j].mass);
    const DdBall share = disk_law_ / (mi + mj);
    after[0] = response.pushed(i, share * mj);
    after[1] = response.pushed(j, -(share * mi));
  } else {
    after[1] = input().whole_container_law ? response.reflected(j, wall_law_)
                                           : response.pushed(j, -wall_law_);
  }

  Impact out{};
  out.time_dd = DdBall(r.t_ref) + delay;
  out.t = out.time_dd.hi;
  bool enough = rounds_to_leading(out.time_dd);
  const double x_error = error_of_length(), v_error = error_of_speed();
  for (int side = wall ? 1 : 0; side < 2; ++side) {
    const MovingSite<DdBall>& m = after[side];
    const DdBall x = in_scene(m.x + m.vx * delay, 0), y = in_scene(m.y + m.vy * delay, 1);
    for (const DdBall* b : {&x, &y}) enough = enough && b->rad <= x_error && rounds_to_leading(*b);
    for (const DdBall* b : {&m.vx, &m.vy}) {
      enough = enough && b->rad <= v_error && rounds_to_leading(*b);
    }
    (side == 0 ? out.first : out.second) = {x.hi, y.hi, m.vx.hi, m.vy.hi};
  }
  if (!enough) return std::nullopt;

  append(r);
  if (!wall) set_state(r.i, after[0].x, after[0].y, after[0].vx, after[0].vy);
  set_state(r.j, after[1].x, after[1].y, after[1].vx, after[1].vy);
  if (states_->rest() >= kLateBatch) {
    states_->wait();
    take_over();
    states_->apply_rest_late();
  }
  return out;
}

RoundedState Motion::maneuver(GenId g, const Rational& t, const Rational& vx, const Rational& vy) {
  settle();
  const double t_ref = round_nearest(t);
  const int maneuver = states_->append({t, vx, vy});
  RoundedState out{0, 0, round_nearest(vx), round_nearest(vy)};
  for (;;) {
    const Ball::Precision bits = states_->bits_at(t_ref);
    const Site<Ball> at = site(g, Ball(t, bits));
    const std::array<Rational, 2>& o = input().origin;
    if ((at.x + Ball(o[0], bits)).round_to_double(out.px) &&
        (at.y + Ball(o[1], bits)).round_to_double(out.py)) {
      break;
    }
    try {
      ExactMotion exact(*this);
      const Site<Tower> s = exact.site(g, Tower(t));
      out.px = round_nearest(s.x + Tower(o[0]));
      out.py = round_nearest(s.y + Tower(o[1]));
      break;
    } catch (const BudgetExceeded& budget) {
      if (!raise_precision()) {
        throw Undecided(std::string("the position at the maneuver may lie on a rounding "
                                    "boundary: ") +
                        budget.what());
      }
    }
  }
  append({g, g, state_[g + 1], state_[g + 1], doubles(g).t, doubles(g).t, t_ref, maneuver});
  settle();
  refresh(g);
  return out;
}

void Motion::restart(GenId g, const Rational& t, const Rational& x, const Rational& y,
                     const Rational& vx, const Rational& vy) {
  if (state_[g + 1] > 0) throw std::logic_error("restart after a computed motion");
  const double start = round_nearest(t);
  const Rational ahead = to_rational(start) - t;
  if (sgn(ahead) == 0) {
    states_->restart(g, start, x, y, vx, vy);
  } else {
    states_->restart(g, start, x + vx * ahead, y + vy * ahead, vx, vy);
  }
  doubles_[g + 1].t = start;
  refresh(g);
}

void Motion::restart(GenId g, double t, const DdBall& x, const DdBall& y, double vx, double vy,
                     const GivenMotion& given) {
  if (state_[g + 1] > 0) throw std::logic_error("restart after a computed motion");
  states_->restart(g, t, given);
  doubles_[g + 1].t = t;
  if (moved_) {
    set_state(g, x - origin_[0], y - origin_[1], DdBall(vx), DdBall(vy));
  } else {
    set_state(g, x, y, DdBall(vx), DdBall(vy));
  }
}

}  // namespace voroproof::internal
