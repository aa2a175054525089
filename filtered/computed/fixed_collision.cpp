#include "filtered/computed/fixed_collision.h"

#include <algorithm>
#include <cmath>

#include "filtered/motion/enclosures.h"

namespace voroproof::internal {

namespace {

// The exponent of an upper bound of a positive number.
std::int64_t exponent_above(const CompactRational& x) {
  const Rational* exact = x.exact();
  if (exact == nullptr) return 2 + std::ilogb(x.leading());
  return static_cast<std::int64_t>(mpz_sizeinbase(exact->get_num_mpz_t(), 2)) -
         static_cast<std::int64_t>(mpz_sizeinbase(exact->get_den_mpz_t(), 2)) + 1;
}

}  // namespace

DdBall dd_of(const FixedView& a, std::int64_t unit) {
  DdBall r;
  a.to_double_double(unit, r.hi, r.lo, r.rad);
  return r;
}

void FixedCollision::compute(const std::array<Side, 2>& sides, double t_ref, const Format& format,
                             const CollisionFactors& laws) {
  format_ = format;
  wall_ = sides[0].mass == nullptr;
  choose_unit_of_radii(sides);
  with_.set(now_, t_ref, time_scale());
  for (int k = 0; k < 2; ++k) load(k, sides[k]);
  find_contact(sides);
  find_change(sides, laws);
  if (wall_) {
    turn_disk();
  } else {
    turn_both();
  }
  with_.add(now_, now_, s_);
}

// The unit is that of the widest radius that comes in, or the last place where that is larger.
void FixedCollision::choose_unit_of_radii(const std::array<Side, 2>& sides) {
  std::int64_t exponent = -format_.bits;
  const auto look = [&](const Ball& ball, std::int64_t scale) {
    if (!ball.is_exact()) exponent = std::max(exponent, ball.radius().exponent() - scale);
  };
  for (const Side& side : sides) {
    if (side.fixed != nullptr) {
      for (std::size_t k = 0; k < 4; ++k) {
        const FixedView view = side.fixed->numbers.view(k);
        if (!view.is_exact()) exponent = std::max(exponent, view.exponent_of_radius());
      }
    } else if (side.balls != nullptr) {
      look(side.balls->x, format_.x_scale);
      look(side.balls->y, format_.x_scale);
      look(side.balls->vx, format_.v_scale);
      look(side.balls->vy, format_.v_scale);
    }
  }
  with_.set_format(format_.bits, format_.integer_limbs, exponent);
}

void FixedCollision::set(FixedBall& out, const CompactRational& x, std::int64_t unit) {
  if (const Rational* exact = x.exact()) {
    with_.set(out, dyadic_or_rounded(*exact, format_.given_bits), unit);
    return;
  }
  with_.set(out, x.leading(), unit);
  if (x.second() == 0) return;
  with_.set(term_, x.second(), unit);
  with_.add(out, out, term_);
}

// Centre and velocity at the reference time after the contact.
void FixedCollision::load(int k, const Side& side) {
  const std::int64_t xs = format_.x_scale, vs = format_.v_scale;
  if (side.fixed != nullptr) {
    std::size_t which = 0;
    for (FixedBall* b : {&x_[k], &y_[k], &vx_[k], &vy_[k]}) {
      with_.set(*b, side.fixed->numbers.view(which++));
    }
  } else if (side.given != nullptr) {
    set(x_[k], side.given->x, xs);
    set(y_[k], side.given->y, xs);
    set(vx_[k], side.given->vx, vs);
    set(vy_[k], side.given->vy, vs);
  } else {
    with_.set(x_[k], side.balls->x, xs);
    with_.set(y_[k], side.balls->y, xs);
    with_.set(vx_[k], side.balls->vx, vs);
    with_.set(vy_[k], side.balls->vy, vs);
  }
  if (side.mass == nullptr) return;  // the container is at rest
  with_.set(dt_, side.t_ref, time_scale());
  with_.sub(dt_, now_, dt_);
  with_.add_product(x_[k], x_[k], vx_[k], dt_);
  with_.add_product(y_[k], y_[k], vy_[k], dt_);
}

// a s^2 + 2 b s + c = 0 at the contact, s after the reference time; then the offset n = d + w s
// from the first to the second. w.n is -root at the contact of two disks, +root at the wall.
void FixedCollision::find_contact(const std::array<Side, 2>& sides) {
  with_.sub(dx_, x_[1], x_[0]);
  with_.sub(dy_, y_[1], y_[0]);
  with_.sub(wx_, vx_[1], vx_[0]);
  with_.sub(wy_, vy_[1], vy_[0]);
  set(reach_, *sides[1].radius, format_.x_scale);
  set(a_, *sides[0].radius, format_.x_scale);
  if (wall_) {
    with_.sub(reach_, reach_, a_);
  } else {
    with_.add(reach_, reach_, a_);
  }
  with_.sum_of_products(a_, wx_, wx_, wy_, wy_);
  with_.sum_of_products(b_, dx_, wx_, dy_, wy_);
  with_.sum_of_products(c_, dx_, dx_, dy_, dy_);
  with_.sub_product(c_, c_, reach_, reach_);
  with_.difference_of_products(root_, b_, b_, a_, c_);
  with_.sqrt(root_, root_);
  if (!wall_) {
    with_.sub(term_, root_, b_);  // b < 0: they approach
    with_.div(s_, c_, term_);
  } else if (with_.sign(b_) == Sign::positive) {
    with_.add(term_, b_, root_);
    with_.div(s_, c_, term_);
    with_.negate(s_);
  } else {
    with_.sub(term_, root_, b_);
    with_.div(s_, term_, a_);
  }
  with_.add_product(nx_, dx_, wx_, s_);
  with_.add_product(ny_, dy_, wy_, s_);
}

// The change of velocity but for the masses, k, and k s.
void FixedCollision::find_change(const std::array<Side, 2>& sides, const CollisionFactors& laws) {
  if (!wall_) {
    // The masses in units of the larger one.
    const CompactRational &mi = *sides[0].mass, &mj = *sides[1].mass;
    const std::int64_t ms = std::max(exponent_above(mi), exponent_above(mj));
    set(mass_[0], mi, ms);
    set(mass_[1], mj, ms);
  }
  // K = -(1 + e) root / (reach^2 (m_i + m_j)), at the wall without masses. One after the other the
  // quotients keep to the size of the numbers, and divisors are short.
  with_.div(k_, root_, reach_);
  if (!wall_) {
    with_.add(term_, mass_[0], mass_[1]);
    with_.mul(reach_, reach_, term_);
  }
  with_.div(k_, k_, reach_);
  with_.set(term_, wall_ ? laws.wall : laws.disks, 0);
  with_.mul(k_, k_, term_);
  with_.mul(kx_, k_, nx_);
  with_.mul(ky_, k_, ny_);
  if (wall_ && laws.whole_container_law) {
    with_.set(k_, laws.wall_keep, 0);
    with_.add_product(kx_, kx_, vx_[1], k_);
    with_.add_product(ky_, ky_, vy_[1], k_);
  }
  with_.mul(sx_, kx_, s_);
  with_.mul(sy_, ky_, s_);
}

// New velocity, v + change; then the centre that the new line had or will have at the reference
// time: x - change * s. At the wall the change is K n or, of the law of the whole velocity,
// (e - 1) v - 2 e (root / reach^2) n.
void FixedCollision::turn_disk() {
  with_.add(vx_[1], vx_[1], kx_);
  with_.add(vy_[1], vy_[1], ky_);
  with_.sub(x_[1], x_[1], sx_);
  with_.sub(y_[1], y_[1], sy_);
}

// Turns two disks as turn_disk() turns one: the change is m_j K n for i, -m_i K n for j.
void FixedCollision::turn_both() {
  with_.negate(mass_[0]);
  for (int side = 0; side < 2; ++side) {
    const FixedBall& mass = mass_[1 - side];
    with_.add_product(vx_[side], vx_[side], kx_, mass);
    with_.add_product(vy_[side], vy_[side], ky_, mass);
    with_.sub_product(x_[side], x_[side], sx_, mass);
    with_.sub_product(y_[side], y_[side], sy_, mass);
  }
}

void FixedCollision::store(int side, FixedState& out) const {
  with_.store(out.numbers, {&x_[side], &y_[side], &vx_[side], &vy_[side]});
  out.v_scale = format_.v_scale;
}

DdBall FixedCollision::time() const { return dd_of(with_.view(now_), time_scale()); }
DdBall FixedCollision::delay() const { return dd_of(with_.view(s_), time_scale()); }

Ball FixedCollision::ball_of(const FixedBall& time, Ball::Precision bits) const {
  return with_.view(time).ball(time_scale(), bits);
}

}  // namespace voroproof::internal
