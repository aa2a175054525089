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

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "exact/ball.h"

namespace voroproof::internal {

// A number of a FixedArithmetic, in whose format it is read and written.
class FixedBall {
 private:
  friend class FixedArithmetic;
  std::vector<mp_limb_t> limbs_;  // least first
  double radius_ = 0;             // infinite: nothing is known
};

// A number with its format, to be read while it is there and nobody writes it.
class FixedView {
 public:
  // An enclosure of the number times 2^unit, with a midpoint of `bits` of precision.
  Ball ball(std::int64_t unit, Ball::Precision bits) const;
  // The number times 2^unit as hi + lo within err, which is 0 only where that is exact.
  void to_double_double(std::int64_t unit, double& hi, double& lo, double& err) const;
  bool is_exact() const { return radius_ == 0; }
  // floor(log2) of the radius of a number that is not exact; 2^62 where nothing is known.
  std::int64_t exponent_of_radius() const;

 private:
  friend class FixedArithmetic;
  friend class FixedRow;
  FixedView(const mp_limb_t* limbs, mp_size_t size, mp_size_t fraction, double radius,
            std::int64_t radius_exponent)
      : limbs_(limbs),
        size_(size),
        fraction_(fraction),
        radius_(radius),
        radius_exponent_(radius_exponent) {}
  bool is_negative() const { return (limbs_[size_ - 1] >> 63) != 0; }

  const mp_limb_t* limbs_;
  mp_size_t size_, fraction_;
  double radius_;
  std::int64_t radius_exponent_;
};

// Four numbers at rest between two computations, in one piece of memory and in the format of the
// one that stored them.
class FixedRow {
 public:
  FixedView view(std::size_t k) const {
    return {limbs_.data() + static_cast<mp_size_t>(k) * size_, size_, fraction_, radii_[k],
            radius_exponent_};
  }
  // Asks for the memory of the numbers, which are soon to be read.
  void prefetch() const {
    constexpr std::size_t line = 64 / sizeof(mp_limb_t);
    for (std::size_t k = 0; k < limbs_.size(); k += line) __builtin_prefetch(&limbs_[k]);
  }

 private:
  friend class FixedArithmetic;
  std::vector<mp_limb_t> limbs_;
  mp_size_t size_ = 0, fraction_ = 0;
  std::int64_t radius_exponent_ = 0;
  std::array<double, 4> radii_{};
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
  // A number in its own format. Where that has more limbs after the point they are cut off.
  void set(FixedBall& out, const FixedView& x) const;
  FixedView view(const FixedBall& a) const {
    return {a.limbs_.data(), size_, fraction_, a.radius_, radius_exponent_};
  }
  void store(FixedRow& row, const std::array<const FixedBall*, 4>& numbers) const;

  // unknown when the ball contains zero and more than zero.
  Sign sign(const FixedBall& a) const;
  void negate(FixedBall& a) const;
  void add(FixedBall& out, const FixedBall& a, const FixedBall& b) const;
  void sub(FixedBall& out, const FixedBall& a, const FixedBall& b) const;
  void mul(FixedBall& out, const FixedBall& a, const FixedBall& b);
  void sqr(FixedBall& out, const FixedBall& a) { mul(out, a, a); }
  // x + a b and x - a b; a b + c d and a b - c d.
  void add_product(FixedBall& out, const FixedBall& x, const FixedBall& a, const FixedBall& b);
  void sub_product(FixedBall& out, const FixedBall& x, const FixedBall& a, const FixedBall& b);
  void sum_of_products(FixedBall& out, const FixedBall& a, const FixedBall& b, const FixedBall& c,
                       const FixedBall& d);
  void difference_of_products(FixedBall& out, const FixedBall& a, const FixedBall& b,
                              const FixedBall& c, const FixedBall& d);
  // The radius is infinite where b contains zero.
  void div(FixedBall& out, const FixedBall& a, const FixedBall& b);
  // The radius is infinite where a contains zero and more, or is below it.
  void sqrt(FixedBall& out, const FixedBall& a);

 private:
  bool is_negative(const mp_limb_t* a) const { return (a[size_ - 1] >> 63) != 0; }
  bool is_negative(const FixedBall& a) const { return is_negative(a.limbs_.data()); }
  mp_limb_t* room(FixedBall& a) const;
  mp_limb_t* scratch(mp_size_t limbs);
  mp_size_t magnitude(mp_limb_t* to, const FixedBall& a) const;
  double upper(const FixedBall& a) const;
  double lower(const FixedBall& a) const;
  void place(FixedBall& out, const mp_limb_t* from, mp_size_t size, std::int64_t exponent,
             bool negative);
  void finish(FixedBall& out, double radius) const;
  void add(FixedBall& out, const mp_limb_t* a, const mp_limb_t* b, double radius) const;
  void sub(FixedBall& out, const mp_limb_t* a, const mp_limb_t* b, double radius) const;
  double multiply(mp_limb_t* r, const FixedBall& a, const FixedBall& b) const;
  const mp_limb_t* middle(const mp_limb_t* r, double& radius) const;

  mp_size_t size_ = 2, fraction_ = 1;  // limbs in all, after the point
  std::int64_t radius_exponent_ = -64;
  double last_place_ = 1;   // in units of radii
  double radius_unit_ = 1;  // above 2^radius_exponent
  std::vector<mp_limb_t> scratch_;
};

}  // namespace voroproof::internal
