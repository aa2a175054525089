#include "filtered/motion/motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "filtered/motion/enclosures.h"

namespace voroproof::internal {

namespace {

// The bits by which a state must be known below the scale of the scene: enough for
// the double-double filter to be limited by its own arithmetic.
constexpr int kInitialGoal = 112;

bool is_double(const DdBall& b) { return b.lo == 0 && b.rad == 0; }

// How far the leading double may be from the truth.
double error_of_leading(double second, double rad) {
  return (std::fabs(second) + rad) * (1 + 0x1p-50);
}

}  // namespace

Motion::Motion(MotionInput input, MotionOptions options)
    : input_(std::make_unique<MotionInput>(about_center(std::move(input)))), options_(options) {
  const std::size_t n = input_->disks.size();
  state_.resize(n + 1);
  doubles_.resize(n + 1);
  seconds_.resize(n + 1);
  for (GenId g = container_id; g < size(); ++g) {
    state_[g + 1] = -1 - g;
    set_radius(
        g, g == container_id ? -dd_of(input_->container_radius) : dd_of(input_->disks[g].radius));
    Motion::set_initial_state(g);
  }
  for (const int axis : {0, 1}) {
    origin_[axis] = dd_of(input_->origin[axis]);
    moved_ = moved_ || sgn(input_->origin[axis]) != 0;
  }
}

Ball Motion::radius_ball(GenId g, Ball::Precision bits) const {
  const DdBall near = radius(g);
  if (is_double(near)) return Ball(near.hi, bits);
  return Ball(
      g == container_id ? Rational(-input().container_radius) : input().disks[g].radius.value(),
      bits);
}

void Motion::set_initial_state(GenId g) {
  if (g == container_id) {
    set_state(g, {});
  } else {
    const DiskInput& d = initial_state(g);
    set_state(g, {dd_of(d.x), dd_of(d.y), dd_of(d.vx), dd_of(d.vy)});
  }
}

void Motion::set_radius(GenId g, const DdBall& r) {
  doubles_[g + 1].r = r.hi;
  seconds_[g + 1].r = r.lo;
  seconds_[g + 1].er = r.rad;
  radii_are_doubles_ = radii_are_doubles_ && r.lo == 0 && r.rad == 0;
}

void Motion::set_state(GenId g, const MotionState<DdBall>& of) {
  const auto& [x, y, vx, vy] = of;
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
  const MotionState<Ball>& m = balls(g);
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

BitSupply::BitSupply(const MotionOptions& options, double horizon)
    : most(options.max_bits),
      goal(std::min(kInitialGoal, std::max(options.max_bits - headroom, 64))),
      horizon(horizon) {
  // A smaller or larger start is a larger or smaller first supply per time.
  const double supply = options.start_bits - goal - headroom;
  if (supply > 0 && horizon > 0) slope = supply / horizon;
}

int BitSupply::at(double t) const {
  const double ahead = std::max(0.0, horizon - t) * slope + reserve;
  const double bits = std::min<double>(goal + headroom + ahead, static_cast<double>(most));
  // Whole limbs: the balls at hand keep their memory from one collision to the next.
  return (static_cast<int>(bits) + 63) / 64 * 64;
}

bool BitSupply::raise_goal() {
  if (at(horizon) >= most) return false;
  goal = std::min(2 * goal, most - headroom);
  return true;
}

}  // namespace voroproof::internal
