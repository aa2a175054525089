// Balls for long chains of operations at one precision: the change of motion at a collision.
//
// Like a Ball, a midpoint with a radius; but exponents count limbs, not bits, so that nothing is
// shifted between operations, nothing is allocated once the numbers have their size, short numbers
// stay short, and results are truncated, not rounded. GMP's mpn functions do the work.
#pragma once

#include <gmp.h>

#include <cstdint>
#include <vector>

#include "exact/ball.h"

namespace voroproof {

class LimbBall {
 public:
  // Zero, exactly.
  LimbBall() = default;
  // The double x, or the same ball, exactly. Infinite and undefined midpoints of a Ball become zero
  // with an infinite radius.
  void set(double x);
  void set(const Ball& b);
  // An enclosure whose midpoint has `bits` of precision, a multiple of 64.
  void get(Ball& out, Ball::Precision bits) const;

  const Magnitude& radius() const { return radius_; }
  // unknown when the ball contains zero and more than zero.
  Sign sign() const;
  void negate() { negative_ = !negative_; }

 private:
  friend class LimbArithmetic;
  // Makes room for so many limbs; what they hold is lost.
  mp_limb_t* room(mp_size_t limbs);
  // Takes the number over that has been written to the first `size` limbs, of which the most
  // significant ends below 2^(64 top): drops zeros at both ends.
  void normalize(mp_size_t size, std::int64_t top);
  void set_unknown();
  // Bounds of |midpoint| from above and below; the midpoint is not zero.
  Magnitude upper() const;
  Magnitude lower() const;

  // The midpoint is the integer of limbs_[0..size_-1], least first, times 2^(64 (top_ - size_)),
  // negated if negative_. The last limb in use is not zero, nor is the first.
  std::vector<mp_limb_t> limbs_;
  mp_size_t size_ = 0;
  std::int64_t top_ = 0;
  bool negative_ = false;
  Magnitude radius_;
};

// Operations whose results have at most so many limbs. `out` may be an operand.
class LimbArithmetic {
 public:
  // Results are right to `bits` relative bits, before what the operands' radii add.
  void set_precision(Ball::Precision bits);

  void add(LimbBall& out, const LimbBall& a, const LimbBall& b);
  void sub(LimbBall& out, const LimbBall& a, const LimbBall& b);
  void mul(LimbBall& out, const LimbBall& a, const LimbBall& b);
  void sqr(LimbBall& out, const LimbBall& a) { mul(out, a, a); }
  // The radius is infinite where b contains zero.
  void div(LimbBall& out, const LimbBall& a, const LimbBall& b);
  // The radius is infinite where a contains zero and more, or is below it.
  void sqrt(LimbBall& out, const LimbBall& a);

 private:
  void add_signed(LimbBall& out, const LimbBall& a, const LimbBall& b, bool b_negative);
  void truncate(LimbBall& out, const mp_limb_t* limbs, mp_size_t size, std::int64_t top,
                const Magnitude& radius);
  mp_limb_t* scratch(mp_size_t limbs);

  mp_size_t limbs_ = 2;
  std::vector<mp_limb_t> scratch_;
};

}  // namespace voroproof
