// Balls: a real number known as midpoint +- radius, midpoint in MPFR.
//
// Every operation rounds its midpoint to nearest at a precision given by the
// caller and adds what that rounding can have lost to the radius, so the true
// value never leaves the ball. The radius is a Magnitude: a double with a wide
// exponent, because balls of thousands of bits have radii far below binary64.
// (Midpoint-radius arithmetic as in van der Hoeven, "Ball arithmetic", 2010, and
// Johansson, "Arb", IEEE Trans. Comput. 66, 2017.)
#pragma once

#include <mpfr.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "exact/rational.h"

namespace voroproof::internal {

// A nonnegative upper bound m * 2^e with m in [1, 2) or m = 0. All operations
// round up.
class Magnitude {
 public:
  Magnitude() = default;
  // An upper bound of |x|; x must be finite.
  static Magnitude of(double x);
  static Magnitude power_of_two(std::int64_t e) { return Magnitude(1.0, e); }
  // Above everything else.
  static Magnitude infinite() { return power_of_two(std::int64_t{1} << 40); }
  bool is_zero() const { return m_ == 0; }
  // floor(log2) of the bound; only for a nonzero one.
  std::int64_t exponent() const { return e_; }
  // The bound as a double: +inf where it is too large, DBL_MIN where too small.
  double to_double() const;
  friend Magnitude operator+(const Magnitude& a, const Magnitude& b);
  friend Magnitude operator*(const Magnitude& a, const Magnitude& b);
  // For lower bounds a of some quantity: a lower bound of a - b, where b < a; an upper bound of
  // 1/a, where a is not zero.
  friend Magnitude operator-(const Magnitude& a, const Magnitude& b);
  Magnitude inverse() const { return normalized(1 / m_ * kUp, -e_); }
  // a 2^k.
  Magnitude scaled(std::int64_t k) const { return is_zero() ? *this : Magnitude(m_, e_ + k); }
  friend bool operator<(const Magnitude& a, const Magnitude& b);

 private:
  // Every sum or product of two magnitudes is rounded once by the hardware; this factor turns the
  // rounded result into an upper bound.
  static constexpr double kUp = 1.0 + 0x1p-51;

  Magnitude(double m, std::int64_t e) : m_(m), e_(e) {}
  static Magnitude normalized(double m, std::int64_t e);
  // Of b to the exponent of a, which is not smaller; below a certain size, more than that.
  static double aligned(const Magnitude& a, const Magnitude& b) {
    const std::int64_t shift = a.e_ - b.e_;
    if (shift > 60) return 0x1p-59;
    return b.m_ * std::bit_cast<double>(static_cast<std::uint64_t>(1023 - shift) << 52);
  }
  double m_ = 0;
  std::int64_t e_ = 0;
};

inline Magnitude Magnitude::normalized(double m, std::int64_t e) {
  // m is positive and normal here: it is a sum or product of numbers in [1, 2),
  // or a finite nonzero double.
  const auto bits = std::bit_cast<std::uint64_t>(m);
  const auto exponent = static_cast<std::int64_t>((bits >> 52) & 0x7ff);
  if (exponent == 0) return Magnitude(1.0, e - 1021);  // subnormal: bounded by 2^-1021
  const double mantissa = std::bit_cast<double>((bits & 0x000fffffffffffffULL) | (0x3ffULL << 52));
  return Magnitude(mantissa, e + exponent - 1023);
}

inline Magnitude Magnitude::of(double x) {
  x = std::fabs(x);
  return x == 0 ? Magnitude() : normalized(x, 0);
}

inline Magnitude operator+(const Magnitude& a, const Magnitude& b) {
  if (a.is_zero()) return b;
  if (b.is_zero()) return a;
  const Magnitude& big = a.e_ >= b.e_ ? a : b;
  const Magnitude& small = a.e_ >= b.e_ ? b : a;
  return Magnitude::normalized((big.m_ + Magnitude::aligned(big, small)) * Magnitude::kUp, big.e_);
}

inline Magnitude operator-(const Magnitude& a, const Magnitude& b) {
  if (b.is_zero()) return a;
  return Magnitude::normalized((a.m_ - Magnitude::aligned(a, b)) * (1 - 0x1p-50), a.e_);
}

inline Magnitude operator*(const Magnitude& a, const Magnitude& b) {
  if (a.is_zero() || b.is_zero()) return Magnitude();
  return Magnitude::normalized(a.m_ * b.m_ * Magnitude::kUp, a.e_ + b.e_);
}

inline bool operator<(const Magnitude& a, const Magnitude& b) {
  if (a.is_zero() || b.is_zero()) return a.is_zero() && !b.is_zero();
  return a.e_ != b.e_ ? a.e_ < b.e_ : a.m_ < b.m_;
}

// A number with the significand (top + next 2^-64 + less than 2^-127) 2^-64 in [1/2, 1], the
// exponent e and that sign, and within `radius` of what is meant, as hi + lo with |value - hi - lo|
// <= err. False where the exponent is unusual, and where the number is short: then it may be exact.
bool leading_double_double(std::uint64_t top, std::uint64_t next, std::int64_t e, bool negative,
                           double radius, double& hi, double& lo, double& err);

class Ball {
 public:
  using Precision = mpfr_prec_t;

  // Zero, exactly, held at `bits` of precision.
  explicit Ball(Precision bits = 64) {
    mpfr_init2(mid_, bits);
    mpfr_set_zero(mid_, 1);
  }
  Ball(double x, Precision bits) : Ball(bits < 53 ? 53 : bits) { mpfr_set_d(mid_, x, MPFR_RNDN); }
  Ball(const Rational& q, Precision bits);
  Ball(const Ball& o) : radius_(o.radius_) {
    mpfr_init2(mid_, mpfr_get_prec(o.mid_));
    mpfr_set(mid_, o.mid_, MPFR_RNDN);
  }
  Ball(Ball&& o) noexcept : radius_(o.radius_) {
    *mid_ = *o.mid_;
    o.mid_->_mpfr_d = nullptr;
  }
  Ball& operator=(const Ball& o);
  Ball& operator=(Ball&& o) noexcept {
    std::swap(*mid_, *o.mid_);
    radius_ = o.radius_;
    return *this;
  }
  ~Ball() {
    if (mid_->_mpfr_d != nullptr) mpfr_clear(mid_);
  }

  Precision precision() const { return mpfr_get_prec(mid_); }
  const Magnitude& radius() const { return radius_; }
  mpfr_srcptr midpoint() const { return mid_; }
  bool is_exact() const { return radius_.is_zero(); }
  // The same value held at `bits`, so that operators with it round no coarser.
  Ball at_precision(Precision bits) const {
    Ball r(bits);
    r.radius_ = radius_;
    r.add_rounding(mpfr_set(r.mid_, mid_, MPFR_RNDN));
    return r;
  }
  void widen(const Magnitude& by) { radius_ = radius_ + by; }

  // unknown when the ball contains zero and more than zero.
  Sign sign() const;

  // Bits of the midpoint above the radius: log2(|mid| / radius), roughly; large
  // for an exact ball. For precision control only, no decision rests on it.
  std::int64_t accuracy_bits() const;

  // The unique binary64 to which every number of the ball rounds (nearest, ties
  // to even); false where the ball straddles a rounding boundary.
  bool round_to_double(double& out) const;
  // Outward enclosure in doubles.
  void to_interval(double& lo, double& hi) const;
  // The value as hi + lo with |value - hi - lo| <= err.
  void to_double_double(double& hi, double& lo, double& err) const;

  // Three-operand forms; `out` may be an operand. `bits` is the precision of the
  // result.
  static void add(Ball& out, const Ball& a, const Ball& b, Precision bits);
  static void sub(Ball& out, const Ball& a, const Ball& b, Precision bits);
  static void mul(Ball& out, const Ball& a, const Ball& b, Precision bits);
  // Division by a ball that contains zero gives an infinite radius.
  static void div(Ball& out, const Ball& a, const Ball& b, Precision bits);
  // Square root of the nonnegative part of the ball; a ball wholly below zero is
  // the caller's mistake.
  static void sqrt(Ball& out, const Ball& a, Precision bits);
  static void neg(Ball& out, const Ball& a);

 private:
  friend class FixedView;
  void set_precision(Precision bits);
  // A moved-from ball has no precision: then `bits`.
  Precision precision_or(Precision bits) const {
    return mid_->_mpfr_d == nullptr ? bits : mpfr_get_prec(mid_);
  }
  // Adds the rounding error of the operation that just wrote mid_.
  void add_rounding(int ternary) {
    if (ternary != 0) {
      radius_ = radius_ + Magnitude::power_of_two(mpfr_get_exp(mid_) - mpfr_get_prec(mid_));
    }
  }
  static Magnitude magnitude_of(mpfr_srcptr x);
  mpfr_t mid_;
  Magnitude radius_;
};

inline Sign sign(const Ball& b) { return b.sign(); }

// Operators, for the predicates that are written once for every number type: the
// result has the larger precision of the operands.
inline Ball operator+(const Ball& a, const Ball& b) {
  const auto bits = std::max(a.precision(), b.precision());
  Ball r(bits);
  Ball::add(r, a, b, bits);
  return r;
}
inline Ball operator-(const Ball& a, const Ball& b) {
  const auto bits = std::max(a.precision(), b.precision());
  Ball r(bits);
  Ball::sub(r, a, b, bits);
  return r;
}
inline Ball operator*(const Ball& a, const Ball& b) {
  const auto bits = std::max(a.precision(), b.precision());
  Ball r(bits);
  Ball::mul(r, a, b, bits);
  return r;
}
inline Ball operator/(const Ball& a, const Ball& b) {
  const auto bits = std::max(a.precision(), b.precision());
  Ball r(bits);
  Ball::div(r, a, b, bits);
  return r;
}
inline Ball operator-(const Ball& a) {
  Ball r(a.precision());
  Ball::neg(r, a);
  return r;
}
inline Ball sqrt(const Ball& a) {
  Ball r(a.precision());
  Ball::sqrt(r, a, a.precision());
  return r;
}

}  // namespace voroproof::internal
