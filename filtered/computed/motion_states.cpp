#include "filtered/computed/motion_states.h"

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "exact/patience.h"
#include "filtered/motion/enclosures.h"

namespace voroproof::internal {

namespace {

// The exponent of zero.
constexpr std::int64_t kNoExponent = -1000;

std::int64_t exponent_of(double d) {
  return d == 0 ? kNoExponent : std::int64_t{std::ilogb(d)} + 1;
}
std::int64_t exponent_of(const Rational& q) { return exponent_of(round_nearest(q)); }

}  // namespace

MotionStates::MotionStates(const MotionInput& input, const MotionOptions& options,
                           std::shared_ptr<MotionLog> log)
    : input_(input),
      container_{0, 0, input_.container_radius, 0, 0, 0},
      bits_(options, round_up(input_.horizon)),
      log_(std::move(log)) {
  x_scale_ = exponent_of(input_.container_radius);
  v_scale_ = kNoExponent;
  reach_scale_ = x_scale_;
  const double container = dd_of(input_.container_radius).hi;
  for (const DiskInput& d : input_.disks) {
    v_scale_ = std::max({v_scale_, exponent_of(dd_of(d.vx).hi), exponent_of(dd_of(d.vy).hi)});
    const double radius = dd_of(d.radius).hi;
    if (sgn(d.radius) > 0) reach_scale_ = std::min(reach_scale_, exponent_of(radius));
    const double rest = container - radius;
    if (rest > 0x1p-20 * radius) {
      reach_scale_ = std::min(reach_scale_, exponent_of(rest));
    } else if (const Rational exact = input_.container_radius - d.radius.value(); sgn(exact) > 0) {
      reach_scale_ = std::min(reach_scale_, exponent_of(exact));
    }
  }
  const std::size_t n = input_.disks.size();
  fixed_.resize(n + 1);
  balls_.resize(n + 1);
  begin();
}

// All generators in their initial states, of which balls are made when they are asked for.
void MotionStates::begin() {
  for (auto& state : fixed_) state.reset();
  for (auto& state : balls_) state.reset();
  set_laws();
}

void MotionStates::set_laws() {
  const Ball::Precision bits = bits_at(0);
  const Rational& e = input_.container_restitution;
  const bool whole = input_.whole_container_law;
  const Rational wall = whole ? Rational(-2 * e) : Rational(-(1 + e));
  laws_ = {dyadic_or_rounded(Rational(-(1 + input_.restitution)), bits),
           dyadic_or_rounded(wall, bits), dyadic_or_rounded(Rational(e - 1), bits), whole};
}

int MotionStates::append(Maneuver m) {
  v_scale_ = std::max({v_scale_, exponent_of(m.vx), exponent_of(m.vy)});
  return log_->append(std::move(m));
}

// The limbs before the point of numbers in units of the scene: centres in 2^x_scale, velocities in
// 2^v_scale. Times are large where they are late, and speeds divided by a short reach; disks may
// become faster than any is at first.
int MotionStates::integer_limbs() const {
  constexpr std::int64_t kFaster = 16;
  const std::int64_t last = bits_.horizon > 0 ? std::ilogb(bits_.horizon) + 1 : kNoExponent;
  const std::int64_t largest =
      std::max({last + v_scale_ - x_scale_, x_scale_ - reach_scale_, std::int64_t{0}});
  return static_cast<int>((largest + 2 + kFaster) / 64) + 1;
}

// A state that a collision left is taken as it is, if in these units; else from balls, or from what
// was given at first.
FixedCollision::Side MotionStates::side_of(GenId g, double t_ref) const {
  FixedCollision::Side side;
  side.t_ref = t_ref;
  const DiskInput& d = initial_state(g);
  side.radius = &d.radius;
  if (g != container_id) side.mass = &d.mass;
  const FixedState* fixed = fixed_[g + 1].get();
  if (fixed == nullptr && balls_[g + 1] == nullptr) {
    side.given = &d;
  } else if (fixed != nullptr && fixed->v_scale == v_scale_) {
    side.fixed = fixed;
  } else {
    side.balls = &balls(g, t_ref);
  }
  return side;
}

void MotionStates::respond(const Record& r) {
  const GenId ids[2] = {r.i, r.j};
  for (const GenId g : ids) __builtin_prefetch(fixed_[g + 1].get());
  for (const GenId g : ids) {
    if (const FixedState* s = fixed_[g + 1].get()) s->numbers.prefetch();
  }
  collision_.compute({side_of(r.i, r.t_i), side_of(r.j, r.t_j)}, r.t_ref,
                     {x_scale_, v_scale_, bits_at(r.t_ref), integer_limbs(), bits_at(0)}, laws_);
  for (int side = r.i == container_id ? 1 : 0; side < 2; ++side) {
    std::shared_ptr<FixedState>& state = fixed_[ids[side] + 1];
    if (!state || are_shared_) state = std::make_shared<FixedState>();
    collision_.store(side, *state);
    balls_[ids[side] + 1].reset();
  }
}

void MotionStates::apply_maneuver(const Record& r) {
  const Ball::Precision bits = bits_at(r.t_ref);
  const Maneuver& m = log_->maneuver(r.maneuver);
  const State<Ball>& s = balls(r.i, r.t_i);
  const Ball before(Rational(m.t - to_rational(r.t_i)), bits);
  const Ball after(Rational(m.t - to_rational(r.t_ref)), bits);
  const Ball vx = dyadic_or_rounded(m.vx, bits);
  const Ball vy = dyadic_or_rounded(m.vy, bits);
  balls_[r.i + 1] = std::make_shared<State<Ball>>(
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
      const FixedView view = s.numbers.view(k);
      if (!view.is_exact() && -view.exponent_of_radius() < bits_.goal) return false;
    }
  }
  return true;
}

// Computes the states anew from all records applied so far.
void MotionStates::replay() {
  ++replays_;
  begin();
  // States of very many bits take long.
  const unsigned steps = 1 + static_cast<unsigned>(bits_at(0)) / 4096;
  auto next = lasting_.begin();
  for (std::size_t k = 0;; ++k) {
    for (; next != lasting_.end(); ++next) {
      const std::shared_ptr<LastingSnapshot> snapshot = next->lock();
      if (!snapshot) continue;
      if (snapshot->records_ != k) break;
      snapshot->set(states_after(k));
    }
    if (k == applied_) break;
    Patience::ask(steps);
    apply(log_->record(k));
  }
}

// Raises the supply of bits after a state at time t fell short of the goal: that per time, judging
// by what has been lost so far, and where this gives little, near the horizon, that at all times.
bool MotionStates::raise_for(double t) {
  const int before = bits_at(0);
  if (before >= bits_.most) return false;
  const double lost = before - bits_.goal;
  const double rate = t > 0 ? lost / t : 0;
  if (bits_.horizon > 0) {
    bits_.slope = std::max({1.1 * rate, 1.4 * bits_.slope, 32 / bits_.horizon});
  }
  if ((bits_.horizon - t) * bits_.slope < BitSupply::headroom) {
    bits_.reserve = std::max(2 * bits_.reserve, 64);
  }
  return true;
}

void MotionStates::apply_rest() {
  if (failure_) std::rethrow_exception(failure_);
  try {
    while (applied_ < size_) {
      const Record& r = log_->record(applied_);
      apply(r);
      if (is_accurate_enough(r)) {
        ++applied_;
      } else if (raise_for(r.t_ref)) {
        replay();
      } else {
        throw Undecided("the state after the collision needs more than " +
                        std::to_string(bits_.most) + " bits");
      }
    }
  } catch (...) {
    failure_ = std::current_exception();
    throw;
  }
}

bool MotionStates::raise_goal() {
  apply_rest();
  if (!bits_.raise_goal()) return false;
  replay();
  return true;
}

const MotionStates::State<Ball>& MotionStates::balls(GenId g, double t_ref) const {
  std::shared_ptr<State<Ball>>& balls = balls_[g + 1];
  if (balls) return *balls;
  const Ball::Precision bits = bits_at(t_ref);
  if (const FixedState* fixed = fixed_[g + 1].get()) {
    const auto at = [&](std::size_t k) {
      return fixed->numbers.view(k).ball(fixed->scale(k, x_scale_), bits);
    };
    balls = std::make_shared<State<Ball>>(State<Ball>{at(0), at(1), at(2), at(3)});
  } else {
    const DiskInput& d = initial_state(g);
    const auto ball = [bits](const Rational& q) { return dyadic_or_rounded(q, bits); };
    balls =
        std::make_shared<State<Ball>>(State<Ball>{ball(d.x), ball(d.y), ball(d.vx), ball(d.vy)});
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
  const DiskInput& d = initial_state(g);
  return {dd_of(d.x), dd_of(d.y), dd_of(d.vx), dd_of(d.vy)};
}

}  // namespace voroproof::internal
