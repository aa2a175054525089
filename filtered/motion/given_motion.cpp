#include "filtered/motion/given_motion.h"

#include <utility>

#include "filtered/motion/enclosures.h"

namespace voroproof::internal {

GivenMotion::GivenMotion(MotionInput input, MotionOptions options)
    : Motion(std::move(input), options),
      bits_(options, round_up(this->input().horizon)),
      given_(this->input().disks.size()),
      balls_(given_.size() + 1) {}

void GivenMotion::restart(GenId g, const Rational& t, const Rational& x, const Rational& y,
                          const Rational& vx, const Rational& vy) {
  const double start = round_nearest(t);
  const Rational ahead = to_rational(start) - t;
  DiskInput& d = input_->disks[g];
  d.x = Rational(x + vx * ahead - input().origin[0]);
  d.y = Rational(y + vy * ahead - input().origin[1]);
  d.vx = vx;
  d.vy = vy;
  given_[g] = nullptr;
  balls_[g + 1].reset();
  doubles_[g + 1].t = start;
  set_initial_state(g);
}

void GivenMotion::restart(GenId g, double t, const DdBall& x, const DdBall& y, double vx, double vy,
                          const GivenStates& given) {
  given_[g] = &given;
  balls_[g + 1].reset();
  doubles_[g + 1].t = t;
  if (moved_) {
    set_state(g, {x - origin_[0], y - origin_[1], DdBall(vx), DdBall(vy)});
  } else {
    set_state(g, {x, y, DdBall(vx), DdBall(vy)});
  }
}

bool GivenMotion::raise_precision() {
  if (!bits_.raise_goal()) return false;
  is_raised_ = true;
  for (auto& state : balls_) state.reset();
  for (GenId g = container_id; g < size(); ++g) set_initial_state(g);
  return true;
}

const DiskInput& GivenMotion::initial_state(GenId g) const {
  DiskInput& d = input_->disks[g];
  if (given_[g] != nullptr) {
    std::exchange(given_[g], nullptr)->state(g, d);
    d.x = Rational(d.x.value() - input().origin[0]);
    d.y = Rational(d.y.value() - input().origin[1]);
  }
  return d;
}

const MotionState<Ball>& GivenMotion::balls(GenId g) const {
  auto& state = balls_[g + 1];
  if (state) return *state;
  state = std::make_unique<MotionState<Ball>>();
  if (g != container_id) {
    const DiskInput& d = initial_state(g);
    const auto ball = [bits = bits_.at(doubles(g).t)](const Rational& q) {
      return dyadic_or_rounded(q, bits);
    };
    *state = {ball(d.x), ball(d.y), ball(d.vx), ball(d.vy)};
  }
  return *state;
}

}  // namespace voroproof::internal
