#include "exact/ball.h"

#include <bit>
#include <cfloat>
#include <cmath>
#include <limits>

namespace voroproof::internal {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// Turns a bound that the hardware rounded once or twice into an upper one.
constexpr double kUp = 1.0 + 0x1p-51;

// Arb's numbers without a radius.
class Float {
 public:
  Float() { arf_init(value_); }
  Float(const Float&) = delete;
  Float& operator=(const Float&) = delete;
  ~Float() { arf_clear(value_); }
  operator arf_ptr() { return value_; }

 private:
  arf_t value_;
};

Rational to_rational(const arf_t x) {
  fmpq_t q;
  fmpq_init(q);
  arf_get_fmpq(q, x);
  Rational out;
  fmpq_get_mpq(out.get_mpq_t(), q);
  fmpq_clear(q);
  return out;
}

}  // namespace

Ball::Ball(const Rational& q, Precision bits) : Ball(bits) {
  fmpq_t view;
  fmpq_init_set_readonly(view, q.get_mpq_t());
  arb_set_fmpq(value_, view, bits);
  fmpq_clear_readonly(view);
}

Ball::Ball(const mp_limb_t* limbs, mp_size_t size, std::int64_t exponent, bool negative,
           const Magnitude& radius, Precision bits)
    : Ball(bits) {
  static_assert(GMP_NUMB_BITS == 64);
  while (size > 0 && limbs[size - 1] == 0) {
    --size;
    exponent -= 64;
  }
  if (size > 0) {
    arf_ptr middle = arb_midref(value_);
    arf_set_mpn(middle, limbs, size, negative ? 1 : 0);
    arf_mul_2exp_si(middle, middle, exponent - 64 * size);
    arb_set_round(value_, value_, bits);
  }
  widen(radius);
}

Sign Ball::sign() const {
  if (arb_is_positive(value_)) return Sign::positive;
  if (arb_is_negative(value_)) return Sign::negative;
  return arb_is_zero(value_) ? Sign::zero : Sign::unknown;
}

Rational Ball::midpoint() const { return to_rational(arb_midref(value_)); }

Ball::Digits Ball::digits() const {
  const arf_struct* middle = arb_midref(value_);
  if (arf_is_special(middle)) return {nullptr, 0, 0, false};
  Digits d{nullptr, 0, fmpz_get_si(ARF_EXPREF(middle)), ARF_SGNBIT(middle) != 0};
  ARF_GET_MPN_READONLY(d.limbs, d.size, middle);
  return d;
}

bool Ball::round_to_double(double& out) const {
  // hi is the nearest double of hi + lo unless the ball reaches half way to a neighbour.
  double hi = 0, lo = 0, err = 0;
  to_double_double(hi, lo, err);
  const double reach = (std::fabs(lo) + err) * kUp;
  const double toward_zero = std::fabs(hi) - std::nextafter(std::fabs(hi), 0.0);
  if (std::fabs(hi) > 1e-290 && reach < 0.5 * toward_zero * (1 - 0x1p-50)) {
    out = hi;
    return true;
  }
  // Both ends, moved outward by 2^-64 of the radius at most, must round to one double.
  Float low, high;
  arb_get_interval_arf(low, high, value_, std::max<Precision>(bits_, 64) + 64);
  out = arf_get_d(low, ARF_RND_NEAR) + 0.0;  // zero has no sign
  return out == arf_get_d(high, ARF_RND_NEAR);
}

void Ball::to_interval(double& lo, double& hi) const {
  Float low, high;
  arb_get_interval_arf(low, high, value_, 53);
  lo = arf_get_d(low, ARF_RND_FLOOR);
  hi = arf_get_d(high, ARF_RND_CEIL);
  // Nothing is known.
  if (std::isnan(lo) || std::isnan(hi)) {
    lo = -infinity;
    hi = infinity;
  }
}

std::pair<Rational, Rational> Ball::rational_interval() const {
  Float low, high;
  arb_get_interval_arf(low, high, value_, bits_);
  return {to_rational(low), to_rational(high)};
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
  const double radius = mag_get_d(arb_radref(value_));
  const Digits d = digits();
  if (d.size >= 3 && leading_double_double(d.limbs[d.size - 1], d.limbs[d.size - 2], d.exponent,
                                           d.negative, radius, hi, lo, err)) {
    return;
  }
  const arf_struct* middle = arb_midref(value_);
  hi = arf_get_d(middle, ARF_RND_NEAR);
  lo = 0;
  err = infinity;
  if (!std::isfinite(hi)) return;
  // middle - hi is exact at the midpoint's own precision plus the 53 bits of hi.
  Float rest;
  arf_set_d(rest, hi);
  const bool rounded = arf_sub(rest, middle, rest, 107, ARF_RND_NEAR) != 0;
  lo = arf_get_d(rest, ARF_RND_NEAR);
  err = radius;
  // The rest behind lo is at most half an ulp of lo (and the rounding of rest, 2^-54 of that
  // again).
  if (rounded || arf_cmp_d(rest, lo) != 0) err = (err + std::fabs(lo) * 0x1p-52 + DBL_MIN) * kUp;
}

}  // namespace voroproof::internal
