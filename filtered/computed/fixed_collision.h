// The change of two motions at a contact, in fixed point: what a state of any number of bits costs.
#pragma once

#include <array>
#include <cstdint>

#include "exact/ball.h"
#include "exact/fixed_ball.h"
#include "exact/motion_input.h"
#include "filtered/motion/motion.h"
#include "filtered/numbers/dd_ball.h"

namespace voroproof::internal {

// A state as a computation left it: centres in units of 2^x_scale, velocities in 2^v_scale.
struct FixedState {
  FixedRow numbers;
  std::int64_t v_scale;
  std::int64_t scale(std::size_t k, std::int64_t x_scale) const {
    return k < 2 ? x_scale : v_scale;
  }
};

// Laws of collision (docs/formats.md, section 6) as factors: of the change -(1 + e) of two disks;
// at the wall -(1 + e), or of the whole velocity e - 1 and -2 e.
struct CollisionFactors {
  Ball disks, wall, wall_keep;
  bool whole_container_law = false;
};

// A fixed-point number times 2^unit as a double-double.
DdBall dd_of(const FixedView& a, std::int64_t unit);

// Computes one collision after the other, in memory of its own.
class FixedCollision {
 public:
  // One of the two generators before the contact. Exactly one of the three states is given; a fixed
  // one is in the units of the computation.
  struct Side {
    double t_ref = 0;
    const FixedState* fixed = nullptr;
    const MotionState<Ball>* balls = nullptr;
    const DiskInput* given = nullptr;
    const CompactRational* radius = nullptr;  // positive for the container, too
    const CompactRational* mass = nullptr;    // null for the container
  };
  // How numbers are held: units of 2^x_scale and 2^v_scale, bits after the point (a multiple of
  // 64), limbs before it.
  struct Format {
    std::int64_t x_scale, v_scale;
    Ball::Precision bits;
    int integer_limbs;
    // The precision of balls made of what is neither a binary64 nor the sum of two.
    Ball::Precision given_bits;
  };

  // sides[0] may be the container: then it has no mass. The contact is the next one after the
  // reference times, near t_ref; the states after it have t_ref as their reference time.
  void compute(const std::array<Side, 2>& sides, double t_ref, const Format& format,
               const CollisionFactors& laws);

  // ---- Of the last collision. ----
  void store(int side, FixedState& out) const;
  // The time of the contact, and its delay after the reference time.
  DdBall time() const;
  DdBall delay() const;
  Ball time_ball(Ball::Precision bits) const { return ball_of(now_, bits); }
  Ball delay_ball(Ball::Precision bits) const { return ball_of(s_, bits); }

 private:
  std::int64_t time_scale() const { return format_.x_scale - format_.v_scale; }
  void choose_unit_of_radii(const std::array<Side, 2>& sides);
  void load(int k, const Side& side);
  void find_contact(const std::array<Side, 2>& sides);
  void find_change(const std::array<Side, 2>& sides, const CollisionFactors& laws);
  void turn_disk();
  void turn_both();
  void set(FixedBall& out, const CompactRational& x, std::int64_t unit);
  Ball ball_of(const FixedBall& time, Ball::Precision bits) const;

  FixedArithmetic with_;
  Format format_{};
  bool wall_ = false;
  FixedBall now_, dt_, term_, x_[2], y_[2], vx_[2], vy_[2], dx_, dy_, wx_, wy_, mass_[2];
  FixedBall reach_, a_, b_, c_, root_, s_, nx_, ny_, k_, kx_, ky_, sx_, sy_;
};

}  // namespace voroproof::internal
