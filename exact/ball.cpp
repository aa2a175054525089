#include "exact/ball.h"

#include <bit>
#include <cfloat>
#include <limits>

namespace voroproof::internal {

namespace {
// Turns a bound that the hardware rounded once or twice into an upper one.
constexpr double kUp = 1.0 + 0x1p-51;

// The significand of a regular number: least limb first, the highest bit of the last one set, below
// the precision zeros (MPFR, "Custom Interface" and "Internals").
const mp_limb_t* limbs_of(mpfr_srcptr x) {
  static_assert(GMP_NUMB_BITS == 64);
  return static_cast<const mp_limb_t*>(mpfr_custom_get_significand(x));
}
}  // namespace

double Magnitude::to_double() const {
  if (is_zero()) return 0;
  if (e_ > 1022) return std::numeric_limits<double>::infinity();
  if (e_ < -1021) return DBL_MIN;
  return m_ * std::bit_cast<double>(static_cast<std::uint64_t>(1023 + e_) << 52);
}

Ball::Ball(const Rational& q, Precision bits) : Ball(bits) {
  add_rounding(mpfr_set_q(mid_, q.get_mpq_t(), MPFR_RNDN));
}

Ball& Ball::operator=(const Ball& o) {
  if (this != &o) {
    set_precision(o.precision());
    mpfr_set(mid_, o.mid_, MPFR_RNDN);
    radius_ = o.radius_;
  }
  return *this;
}

void Ball::set_precision(Precision bits) {
  if (mid_->_mpfr_d == nullptr) {
    mpfr_init2(mid_, bits);
  } else if (mpfr_get_prec(mid_) != bits) {
    mpfr_set_prec(mid_, bits);
  }
}

Magnitude Ball::magnitude_of(mpfr_srcptr x) {
  if (mpfr_zero_p(x)) return Magnitude();
  if (!mpfr_number_p(x)) return Magnitude::infinite();
  // |x| = m 2^exp with m in [1/2, 1); its leading 53 bits, rounded up.
  const mp_size_t top = (mpfr_get_prec(x) - 1) / GMP_NUMB_BITS;
  const auto leading = static_cast<double>((limbs_of(x)[top] >> 11) + 1);
  return Magnitude::of(leading * 0x1p-53).scaled(mpfr_get_exp(x));
}

Sign Ball::sign() const {
  if (!mpfr_number_p(mid_)) return Sign::unknown;
  if (radius_.is_zero()) return sign_of(mpfr_sgn(mid_));
  if (mpfr_zero_p(mid_)) return Sign::unknown;
  // |mid| >= 2^(exp-1); the radius is below 2^(e+1).
  const std::int64_t low = mpfr_get_exp(mid_) - 1;
  if (low >= radius_.exponent() + 1) return sign_of(mpfr_sgn(mid_));
  if (low + 1 <= radius_.exponent()) return Sign::unknown;
  long e = 0;
  const double m = std::fabs(mpfr_get_d_2exp(&e, mid_, MPFR_RNDZ));
  return radius_ < Magnitude::of(m).scaled(e) ? sign_of(mpfr_sgn(mid_)) : Sign::unknown;
}

std::int64_t Ball::accuracy_bits() const {
  if (radius_.is_zero()) return std::int64_t{1} << 30;
  if (mpfr_zero_p(mid_)) return -radius_.exponent();
  return mpfr_get_exp(mid_) - 1 - radius_.exponent();
}

bool Ball::round_to_double(double& out) const {
  if (!mpfr_number_p(mid_)) return false;
  if (radius_.is_zero()) {
    out = mpfr_get_d(mid_, MPFR_RNDN);
    return true;
  }
  // hi is the nearest double of hi + lo unless the ball reaches half way to a neighbour.
  double hi = 0, lo = 0, err = 0;
  to_double_double(hi, lo, err);
  const double reach_of_ball = (std::fabs(lo) + err) * kUp;
  const double toward_zero = std::fabs(hi) - std::nextafter(std::fabs(hi), 0.0);
  if (std::fabs(hi) > 1e-290 && reach_of_ball < 0.5 * toward_zero * (1 - 0x1p-50)) {
    out = hi;
    return true;
  }
  // Both ends of the ball, rounded outward at a precision that leaves the ends
  // where they are up to a relative 2^-64 of the radius, must round to one double.
  const Precision bits = std::max<Precision>(precision(), 64) + 64;
  Ball end(bits);
  Ball reach(64);
  mpfr_set_d(reach.mid_, 1.0, MPFR_RNDN);
  if (radius_.exponent() > 2000) return false;
  // The radius as an MPFR number, rounded up to the next power of two times two
  // would waste a bit: use its double mantissa.
  const Magnitude unit = radius_.scaled(-radius_.exponent());
  mpfr_set_d(reach.mid_, unit.to_double(), MPFR_RNDU);
  mpfr_mul_2si(reach.mid_, reach.mid_, static_cast<long>(radius_.exponent()), MPFR_RNDU);
  mpfr_sub(end.mid_, mid_, reach.mid_, MPFR_RNDD);
  const double low_end = mpfr_get_d(end.mid_, MPFR_RNDN);
  mpfr_add(end.mid_, mid_, reach.mid_, MPFR_RNDU);
  const double high_end = mpfr_get_d(end.mid_, MPFR_RNDN);
  if (low_end != high_end) return false;
  out = low_end;
  return true;
}

void Ball::to_interval(double& lo, double& hi) const {
  if (!mpfr_number_p(mid_)) {
    lo = -std::numeric_limits<double>::infinity();
    hi = std::numeric_limits<double>::infinity();
    return;
  }
  lo = mpfr_get_d(mid_, MPFR_RNDD);
  hi = mpfr_get_d(mid_, MPFR_RNDU);
  if (radius_.is_zero()) return;
  const double r = radius_.to_double();
  lo = std::nextafter(lo - r, -std::numeric_limits<double>::infinity());
  hi = std::nextafter(hi + r, std::numeric_limits<double>::infinity());
}

// hi takes the first 53 bits, rounded, lo the rest, rounded.
bool leading_double_double(std::uint64_t top, std::uint64_t next, std::int64_t e, bool negative,
                           double radius, double& hi, double& lo, double& err) {
  if (e < -800 || e > 900) return false;
  // hi = h 2^(e-53) with h the first 53 bits, rounded half up (2^53 is a double as well); the
  // rest is r 2^(e-128), -2^74 <= r < 2^74, as a sum of two doubles: one of the multiple of 2^64
  // in it, exact, one of the second limb, rounded; their sum is rounded once more.
  const std::uint64_t h = (top >> 11) + ((top >> 10) & 1);
  const auto above = static_cast<std::int64_t>(top - (h << 11));  // -2^10 <= above < 2^10
  if (above == 0 && next == 0) return false;
  const double low = static_cast<double>(next);
  const double rest = static_cast<double>(above) * 0x1p64 + low;
  const double sign = negative ? -1.0 : 1.0;
  const auto power = [](std::int64_t k) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + k) << 52);
  };
  hi = sign * static_cast<double>(h) * power(e - 53);
  lo = sign * rest * power(e - 128);
  // The second limb errs by 2^10 at most, the sum by 2^-53 of itself, and 2 for what is below.
  err = (radius + (std::fabs(rest) * 0x1p-52 + 0x1p11) * power(e - 128)) * kUp;
  return true;
}

void Ball::to_double_double(double& hi, double& lo, double& err) const {
  const mp_size_t size = (mpfr_get_prec(mid_) + GMP_NUMB_BITS - 1) / GMP_NUMB_BITS;
  if (size >= 3 && mpfr_regular_p(mid_)) {
    const mp_limb_t* d = limbs_of(mid_);
    // Padded with zeros it may be exact.
    mp_size_t below = size - 2;
    while (below > 0 && d[below - 1] == 0) --below;
    if (below > 0 && leading_double_double(d[size - 1], d[size - 2], mpfr_get_exp(mid_),
                                           mpfr_sgn(mid_) < 0, radius_.to_double(), hi, lo, err)) {
      return;
    }
  }
  hi = mpfr_get_d(mid_, MPFR_RNDN);
  if (!std::isfinite(hi)) {
    lo = 0;
    err = std::numeric_limits<double>::infinity();
    return;
  }
  // mid - hi is exact at the midpoint's own precision plus the 53 bits of hi.
  mp_limb_t limbs[2];
  mpfr_t rest;
  mpfr_custom_init(limbs, 107);
  mpfr_custom_init_set(rest, MPFR_ZERO_KIND, 0, 107, limbs);
  const int ternary = mpfr_sub_d(rest, mid_, hi, MPFR_RNDN);
  lo = mpfr_get_d(rest, MPFR_RNDN);
  err = radius_.to_double();
  // What is left after lo is at most half an ulp of lo (and the rounding of rest,
  // 2^-54 of that again).
  const double left = std::fabs(lo) * 0x1p-52;
  if (ternary != 0 || mpfr_cmp_d(rest, lo) != 0) err = (err + left + DBL_MIN) * kUp;
}

void Ball::add(Ball& out, const Ball& a, const Ball& b, Precision bits) {
  if (out.precision_or(bits) != bits && (&out == &a || &out == &b)) {
    Ball r(bits);
    add(r, a, b, bits);
    out = std::move(r);
    return;
  }
  const Magnitude radius = a.radius_ + b.radius_;
  out.set_precision(bits);
  const int t = mpfr_add(out.mid_, a.mid_, b.mid_, MPFR_RNDN);
  out.radius_ = radius;
  out.add_rounding(t);
}

void Ball::sub(Ball& out, const Ball& a, const Ball& b, Precision bits) {
  if (out.precision_or(bits) != bits && (&out == &a || &out == &b)) {
    Ball r(bits);
    sub(r, a, b, bits);
    out = std::move(r);
    return;
  }
  const Magnitude radius = a.radius_ + b.radius_;
  out.set_precision(bits);
  const int t = mpfr_sub(out.mid_, a.mid_, b.mid_, MPFR_RNDN);
  out.radius_ = radius;
  out.add_rounding(t);
}

void Ball::mul(Ball& out, const Ball& a, const Ball& b, Precision bits) {
  if (out.precision_or(bits) != bits && (&out == &a || &out == &b)) {
    Ball r(bits);
    mul(r, a, b, bits);
    out = std::move(r);
    return;
  }
  Magnitude radius;
  if (!a.radius_.is_zero()) radius = a.radius_ * (magnitude_of(b.mid_) + b.radius_);
  if (!b.radius_.is_zero()) radius = radius + b.radius_ * magnitude_of(a.mid_);
  out.set_precision(bits);
  const int t = mpfr_mul(out.mid_, a.mid_, b.mid_, MPFR_RNDN);
  out.radius_ = radius;
  out.add_rounding(t);
}

void Ball::div(Ball& out, const Ball& a, const Ball& b, Precision bits) {
  if (out.precision_or(bits) != bits && (&out == &a || &out == &b)) {
    Ball r(bits);
    div(r, a, b, bits);
    out = std::move(r);
    return;
  }
  const Magnitude radius_a = a.radius_, radius_b = b.radius_;
  // A lower bound of |b0| - rad_b as low 2^e.
  long e = 0;
  double low = 0;
  if (b.sign() == Sign::positive || b.sign() == Sign::negative) {
    low = std::fabs(mpfr_get_d_2exp(&e, b.mid_, MPFR_RNDZ));
    if (!radius_b.is_zero()) low = (low - radius_b.scaled(-e).to_double()) * (1 - 0x1p-50);
  }
  out.set_precision(bits);
  if (!(low > 0)) {
    mpfr_set_zero(out.mid_, 1);
    out.radius_ = Magnitude::infinite();
    return;
  }
  const int t = mpfr_div(out.mid_, a.mid_, b.mid_, MPFR_RNDN);
  // |a/b - a0/b0| <= (rad_a + |a0/b0| rad_b) / (|b0| - rad_b); 1/low is rounded up.
  out.radius_ = Magnitude();
  if (!radius_a.is_zero() || !radius_b.is_zero()) {
    Magnitude top = radius_a;
    if (!radius_b.is_zero()) {
      Magnitude quotient = magnitude_of(out.mid_);
      if (!quotient.is_zero()) {
        quotient = quotient + Magnitude::power_of_two(mpfr_get_exp(out.mid_) - bits);
      }
      top = top + quotient * radius_b;
    }
    out.radius_ = top * Magnitude::of(1 / low * kUp).scaled(-e);
  }
  out.add_rounding(t);
}

void Ball::sqrt(Ball& out, const Ball& a, Precision bits) {
  if (out.precision_or(bits) != bits && &out == &a) {
    Ball r(bits);
    sqrt(r, a, bits);
    out = std::move(r);
    return;
  }
  const Magnitude radius = a.radius_;
  if (!radius.is_zero() && a.sign() != Sign::positive) {
    // The ball reaches zero: sqrt lies in [0, sqrt(|mid| + rad)].
    const Magnitude top = magnitude_of(a.mid_) + radius;
    out.set_precision(bits);
    mpfr_set_zero(out.mid_, 1);
    out.radius_ = Magnitude::power_of_two((top.exponent() + 2) / 2 + 1);
    return;
  }
  out.set_precision(bits);
  const int t = mpfr_sqrt(out.mid_, a.mid_, MPFR_RNDN);
  out.radius_ = Magnitude();
  if (!radius.is_zero()) {
    // |sqrt(x) - sqrt(x0)| <= rad / sqrt(x0) for x >= 0; out.mid_ may exceed
    // sqrt(x0) by a relative 2^-bits, which the factor covers.
    long e = 0;
    const double low = std::fabs(mpfr_get_d_2exp(&e, out.mid_, MPFR_RNDZ)) * (1 - 0x1p-50);
    out.radius_ = radius * Magnitude::of(1 / low * kUp).scaled(-e);
  }
  out.add_rounding(t);
}

void Ball::neg(Ball& out, const Ball& a) {
  out = a;
  mpfr_neg(out.mid_, out.mid_, MPFR_RNDN);
}

}  // namespace voroproof::internal
