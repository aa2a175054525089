// Balls for long chains of operations on numbers of known size: the change of motion at a
// collision.
//
// A midpoint is a fixed-point number in two's complement: `integer_limbs` limbs before the point,
// `bits` after it, the same for all numbers of a computation. So nothing is aligned, normalized or
// allocated between operations, sums are sums of limbs and products are cut out of their places;
// GMP's mpn functions do the work. Radii are doubles in a unit that the computation chooses, so
// that they neither overflow nor vanish however many bits there are.
#pragma once

#include <gmp.h>

#include <cstdint>
#include <vector>

#include "exact/ball.h"

namespace voroproof {

// A number of a FixedArithmetic, in whose format it is read and written.
class FixedBall {
 private:
  friend class FixedArithmetic;
  std::vector<mp_limb_t> limbs_;  // least first
  double radius_ = 0;             // infinite: nothing is known
};

// Operations and conversions in one format. `out` may be an operand. Numbers written in another
// format must not be read. What does not fit before the point has an infinite radius.
class FixedArithmetic {
 public:
  // `bits`, a multiple of 64, after the point. The unit of radii is 2^radius_exponent, or one in
  // the last place if that is more.
  void set_format(Ball::Precision bits, int integer_limbs, std::int64_t radius_exponent);

  // x / 2^unit.
  void set(FixedBall& out, double x, std::int64_t unit);
  void set(FixedBall& out, const Ball& x, std::int64_t unit);
  // An enclosure of a 2^unit whose midpoint has `bits` of precision, a multiple of 64.
  void get(Ball& out, const FixedBall& a, std::int64_t unit, Ball::Precision bits);

  // unknown when the ball contains zero and more than zero.
  Sign sign(const FixedBall& a) const;
  void negate(FixedBall& a) const;
  void add(FixedBall& out, const FixedBall& a, const FixedBall& b) const;
  void sub(FixedBall& out, const FixedBall& a, const FixedBall& b) const;
  void mul(FixedBall& out, const FixedBall& a, const FixedBall& b);
  void sqr(FixedBall& out, const FixedBall& a) { mul(out, a, a); }
  // The radius is infinite where b contains zero.
  void div(FixedBall& out, const FixedBall& a, const FixedBall& b);
  // The radius is infinite where a contains zero and more, or is below it.
  void sqrt(FixedBall& out, const FixedBall& a);

 private:
  bool is_negative(const FixedBall& a) const { return (a.limbs_[size_ - 1] >> 63) != 0; }
  mp_limb_t* room(FixedBall& a) const;
  mp_limb_t* scratch(mp_size_t limbs);
  mp_size_t magnitude(mp_limb_t* to, const FixedBall& a) const;
  double upper(const FixedBall& a) const;
  double lower(const FixedBall& a) const;
  void place(FixedBall& out, const mp_limb_t* from, mp_size_t size, std::int64_t exponent,
             bool negative);
  void finish(FixedBall& out, double radius) const;

  mp_size_t size_ = 2, fraction_ = 1;  // limbs in all, after the point
  std::int64_t radius_exponent_ = -64;
  double last_place_ = 1;   // in units of radii
  double radius_unit_ = 1;  // above 2^radius_exponent
  std::vector<mp_limb_t> scratch_;
};

}  // namespace voroproof
