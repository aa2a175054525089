// Balls: a real number known as midpoint +- radius. The arithmetic is Arb's (Johansson, "Arb:
// efficient arbitrary-precision midpoint-radius interval arithmetic", IEEE Trans. Comput. 66,
// 2017): every operation rounds its midpoint at a given precision and adds to the radius what that
// rounding can have lost, so that the true value never leaves the ball.
#pragma once

#include <arb.h>
#include <gmp.h>
#include <mpfr.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "exact/magnitude.h"
#include "exact/rational.h"

namespace voroproof::internal {

// Arb's arb_t, owned, with the precision at which the number is held: results have that, or the
// larger one of two operands. The predicates that are written once for every number type have
// nothing else to say at which precision they are to be evaluated.
class Ball {
 public:
  using Precision = std::int64_t;  // bits

  // Zero, exactly, held at `bits` of precision.
  explicit Ball(Precision bits = 64) : bits_(bits) { arb_init(value_); }
  // x, exactly.
  Ball(double x, Precision bits) : Ball(std::max<Precision>(bits, 53)) { arb_set_d(value_, x); }
  Ball(const Rational& q, Precision bits);
  // The number with the significand limbs[0..size), least first, as a fraction in [0, 1), times
  // 2^exponent; within `radius` of it, rounded to `bits`.
  Ball(const mp_limb_t* limbs, mp_size_t size, std::int64_t exponent, bool negative,
       const Magnitude& radius, Precision bits);
  Ball(const Ball& o) : bits_(o.bits_) {
    arb_init(value_);
    arb_set(value_, o.value_);
  }
  Ball(Ball&& o) noexcept : Ball(o.bits_) { arb_swap(value_, o.value_); }
  Ball& operator=(const Ball& o) {
    arb_set(value_, o.value_);
    bits_ = o.bits_;
    return *this;
  }
  Ball& operator=(Ball&& o) noexcept {
    arb_swap(value_, o.value_);
    bits_ = o.bits_;
    return *this;
  }
  ~Ball() { arb_clear(value_); }

  Precision precision() const { return bits_; }
  // This value held at `bits`, so that operators with it round no coarser.
  Ball at_precision(Precision bits) const {
    Ball r(bits);
    arb_set_round(r.value_, value_, bits);
    return r;
  }
  bool is_exact() const { return arb_is_exact(value_) != 0; }
  bool is_finite() const { return arb_is_finite(value_) != 0; }
  Magnitude radius() const { return Magnitude(arb_radref(value_)); }
  void widen(const Magnitude& by) { arb_add_error_mag(value_, by.value()); }

  // unknown when the ball contains zero and more than zero.
  Sign sign() const;

  // The midpoint; the ball must be finite.
  Rational midpoint() const;
  // The double nearest to the midpoint.
  double midpoint_as_double() const { return arf_get_d(arb_midref(value_), ARF_RND_NEAR); }
  // The midpoint as it is held: a significand in [1/2, 1), least limb first, times 2^exponent. Zero
  // has no limb. The ball must be finite, and stay as it is while that is read.
  struct Digits {
    const mp_limb_t* limbs;
    mp_size_t size;
    std::int64_t exponent;
    bool negative;
  };
  Digits digits() const;

  // The unique binary64 to which every number of the ball rounds (nearest, ties to even); false
  // where the ball straddles a rounding boundary.
  bool round_to_double(double& out) const;
  // Outward enclosures: in doubles, in MPFR numbers of any precision, in rationals with numerators
  // of about the ball's precision (of a finite ball).
  void to_interval(double& lo, double& hi) const;
  void to_interval(mpfr_ptr lo, mpfr_ptr hi) const { arb_get_interval_mpfr(lo, hi, value_); }
  std::pair<Rational, Rational> rational_interval() const;
  // The value as hi + lo with |value - hi - lo| <= err.
  void to_double_double(double& hi, double& lo, double& err) const;

  friend Ball operator+(const Ball& a, const Ball& b) { return apply(arb_add, a, b); }
  friend Ball operator-(const Ball& a, const Ball& b) { return apply(arb_sub, a, b); }
  friend Ball operator*(const Ball& a, const Ball& b) { return apply(arb_mul, a, b); }
  // Infinite where b contains zero.
  friend Ball operator/(const Ball& a, const Ball& b) { return apply(arb_div, a, b); }
  friend Ball operator-(const Ball& a) {
    Ball r(a.bits_);
    arb_neg(r.value_, a.value_);
    return r;
  }
  // The square roots of what is not negative in the ball. Where all of it is negative, nothing is
  // known: a predicate must not be decided from a root that does not exist.
  friend Ball sqrt(const Ball& a) {
    Ball r(a.bits_);
    if (arb_is_negative(a.value_)) {
      arb_indeterminate(r.value_);
    } else {
      arb_sqrtpos(r.value_, a.value_, a.bits_);
    }
    return r;
  }

 private:
  template <class Operation>
  static Ball apply(const Operation& operation, const Ball& a, const Ball& b) {
    Ball r(std::max(a.bits_, b.bits_));
    operation(r.value_, a.value_, b.value_, r.bits_);
    return r;
  }

  arb_t value_;
  Precision bits_;
};

inline Sign sign(const Ball& b) { return b.sign(); }

// A number with the significand (top + next 2^-64 + less than 2^-127) 2^-64 in [1/2, 1], the
// exponent e and that sign, and within `radius` of what is meant, as hi + lo with |value - hi - lo|
// <= err. False where the exponent is unusual, and where the number is short: then it may be exact.
bool leading_double_double(std::uint64_t top, std::uint64_t next, std::int64_t e, bool negative,
                           double radius, double& hi, double& lo, double& err);

}  // namespace voroproof::internal
