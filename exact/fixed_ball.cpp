#include "exact/fixed_ball.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "exact/fixed_ball_bounds.h"

namespace voroproof::internal {

using namespace fixed_ball_bounds;

namespace {

static_assert(GMP_NUMB_BITS == 64);

// How many limbs from the least on are zero, at most `most`.
mp_size_t trailing_zeros(const mp_limb_t* limbs, mp_size_t most) {
  mp_size_t k = 0;
  while (k < most && limbs[k] == 0) ++k;
  return k;
}

}  // namespace

void FixedArithmetic::set_format(Ball::Precision bits, int integer_limbs,
                                 std::int64_t radius_exponent) {
  fraction_ = bits / 64;
  size_ = fraction_ + integer_limbs;
  radius_exponent_ = std::max<std::int64_t>(radius_exponent, -64 * fraction_);
  const auto power = [](std::int64_t e) {
    return e > 800 ? infinity : power_of_two(std::max<std::int64_t>(e, -800));
  };
  last_place_ = power(-64 * fraction_ - radius_exponent_);
  radius_unit_ = power(radius_exponent_);
}

mp_limb_t* FixedArithmetic::room(FixedBall& a) const {
  a.limbs_.resize(size_);
  return a.limbs_.data();
}

mp_limb_t* FixedArithmetic::scratch(mp_size_t limbs) {
  if (scratch_.size() < static_cast<std::size_t>(limbs)) scratch_.resize(limbs);
  return scratch_.data();
}

// |a| in as many limbs as it needs: returns their number.
mp_size_t FixedArithmetic::magnitude(mp_limb_t* to, const FixedBall& a) const {
  if (is_negative(a)) {
    mpn_neg(to, a.limbs_.data(), size_);
  } else {
    std::copy(a.limbs_.begin(), a.limbs_.begin() + size_, to);
  }
  mp_size_t size = size_;
  while (size > 0 && to[size - 1] == 0) --size;
  return size;
}

// A bound of |a| from above, never zero. The limbs of a negative number are inverted, which gives
// its magnitude less one in the last place. Two limbs are read, the second of them the first after
// the point or one before it.
double FixedArithmetic::upper(const FixedBall& a) const {
  const mp_limb_t flip = is_negative(a) ? ~mp_limb_t{0} : 0;
  mp_size_t k = size_ - 1;
  while (k > fraction_ && a.limbs_[k] == flip) --k;
  const double leading = static_cast<double>(a.limbs_[k] ^ flip);
  const double v = leading + static_cast<double>(a.limbs_[k - 1] ^ flip) * 0x1p-64;
  const double bound = v * (1 + 0x1p-50) + 0x1p-63;
  return k == fraction_ ? bound : scaled(bound, 64 * (k - fraction_));
}

// A bound of |a| from below, by the two leading limbs; zero where it would be less than 2^-800.
double FixedArithmetic::lower(const FixedBall& a) const {
  const mp_limb_t flip = is_negative(a) ? ~mp_limb_t{0} : 0;
  mp_size_t k = size_ - 1;
  while (k > 0 && a.limbs_[k] == flip) --k;
  const mp_size_t exponent = 64 * (k - fraction_);
  if (exponent < -800) return 0;
  double v = static_cast<double>(a.limbs_[k] ^ flip);
  if (k > 0) v += static_cast<double>(a.limbs_[k - 1] ^ flip) * 0x1p-64;
  return v * (1 - 0x1p-50) * power_of_two(std::min<mp_size_t>(exponent, 800));
}

// Gives a number its radius; what is too large for a double, or no number at all, is unknown.
void FixedArithmetic::finish(FixedBall& out, double radius) const {
  if (radius != 0) radius = std::max(radius * up, least_radius);
  out.radius_ = radius < std::numeric_limits<double>::max() ? radius : infinity;
}

// Writes the number m 2^exponent, the integer m of `size` limbs of which the last has its first bit
// set taken as a fraction in [1/2, 1); adds to the radius what is left out.
void FixedArithmetic::place(FixedBall& out, const mp_limb_t* from, mp_size_t size,
                            std::int64_t exponent, bool negative) {
  mp_limb_t* to = room(out);
  std::fill(to, to + size_, 0);
  const std::int64_t top = exponent + 64 * fraction_;  // bits in units of the last place
  if (top >= 64 * size_) {
    out.radius_ = infinity;
    return;
  }
  bool cut = true;
  if (top > 0) {
    const mp_size_t above = (top + 63) / 64;  // the limb below which the number ends
    const auto shift = static_cast<unsigned>(64 * above - top);
    mp_limb_t* d = scratch(size + 1);
    d[0] = 0;
    if (shift == 0) {
      std::copy(from, from + size, d + 1);
    } else {
      d[0] = mpn_rshift(d + 1, from, size, shift);
    }
    const mp_size_t kept = std::min(size + 1, above), dropped = size + 1 - kept;
    std::copy(d + dropped, d + size + 1, to + (above - kept));
    cut = dropped > 0 && mpn_zero_p(d, dropped) == 0;
    if (negative) mpn_neg(to, to, size_);
  }
  if (cut) out.radius_ = (out.radius_ + last_place_) * up;
}

Sign FixedArithmetic::sign(const FixedBall& a) const {
  const bool zero = mpn_zero_p(a.limbs_.data(), size_) != 0;
  if (a.radius_ == 0) {
    return zero ? Sign::zero : is_negative(a) ? Sign::negative : Sign::positive;
  }
  if (zero || std::isinf(a.radius_)) return Sign::unknown;
  // No radius is as small as what underflows here.
  if (!(a.radius_ < scaled(lower(a), -radius_exponent_))) return Sign::unknown;
  return is_negative(a) ? Sign::negative : Sign::positive;
}

void FixedArithmetic::negate(FixedBall& a) const {
  const bool negative = is_negative(a);
  mpn_neg(a.limbs_.data(), a.limbs_.data(), size_);
  if (negative && is_negative(a)) a.radius_ = infinity;
}

void FixedArithmetic::add(FixedBall& out, const mp_limb_t* a, const mp_limb_t* b,
                          double radius) const {
  const bool same = is_negative(a) == is_negative(b), negative = is_negative(a);
  mpn_add_n(room(out), a, b, size_);
  finish(out, same && is_negative(out) != negative ? infinity : radius);
}

void FixedArithmetic::sub(FixedBall& out, const mp_limb_t* a, const mp_limb_t* b,
                          double radius) const {
  const bool different = is_negative(a) != is_negative(b), negative = is_negative(a);
  mpn_sub_n(room(out), a, b, size_);
  finish(out, different && is_negative(out) != negative ? infinity : radius);
}

void FixedArithmetic::add(FixedBall& out, const FixedBall& a, const FixedBall& b) const {
  add(out, a.limbs_.data(), b.limbs_.data(), a.radius_ + b.radius_);
}

void FixedArithmetic::sub(FixedBall& out, const FixedBall& a, const FixedBall& b) const {
  sub(out, a.limbs_.data(), b.limbs_.data(), a.radius_ + b.radius_);
}

// The product of the midpoints, of twice as many limbs before and after the point; returns the
// radius: |a b - a0 b0| <= ra (|b0| + rb) + rb |a0|.
double FixedArithmetic::multiply(mp_limb_t* r, const FixedBall& a, const FixedBall& b) const {
  double radius = 0;
  if (a.radius_ != 0) radius = a.radius_ * (upper(b) + b.radius_ * radius_unit_);
  if (b.radius_ != 0) radius += b.radius_ * upper(a);
  // Short numbers (times, masses, factors of the law) end with limbs that are zero.
  const mp_limb_t *x = a.limbs_.data(), *y = b.limbs_.data();
  const mp_size_t zeros_x = trailing_zeros(x, size_ - 1), zeros_y = trailing_zeros(y, size_ - 1);
  const mp_size_t zeros = zeros_x + zeros_y, size_x = size_ - zeros_x, size_y = size_ - zeros_y;
  if (zeros > 0) std::fill(r, r + zeros, 0);
  if (&a == &b) {
    mpn_sqr(r + zeros, x + zeros_x, size_x);
  } else if (size_x == size_y) {
    mpn_mul_n(r + zeros, x + zeros_x, y + zeros_y, size_x);
  } else if (size_x > size_y) {
    mpn_mul(r + zeros, x + zeros_x, size_x, y + zeros_y, size_y);
  } else {
    mpn_mul(r + zeros, y + zeros_y, size_y, x + zeros_x, size_x);
  }
  // Read as an unsigned number a negative one is larger by 2^(64 size).
  mp_limb_t* high = r + size_;
  if (is_negative(a)) mpn_sub_n(high + zeros_y, high + zeros_y, y + zeros_y, size_y);
  if (is_negative(b)) mpn_sub_n(high + zeros_x, high + zeros_x, x + zeros_x, size_x);
  return radius;
}

// The part of such a product that the format has room for, rounded down: the error is less than one
// in the last place.
const mp_limb_t* FixedArithmetic::middle(const mp_limb_t* r, double& radius) const {
  if (r[fraction_ - 1] != 0 || mpn_zero_p(r, fraction_) == 0) radius += last_place_;
  const mp_limb_t* from = r + fraction_;
  const mp_limb_t sign = is_negative(from) ? ~mp_limb_t{0} : 0;
  for (const mp_limb_t* k = from + size_; k != r + 2 * size_; ++k) {
    if (*k != sign) radius = infinity;
  }
  return from;
}

void FixedArithmetic::mul(FixedBall& out, const FixedBall& a, const FixedBall& b) {
  mp_limb_t* r = scratch(2 * size_);
  double radius = multiply(r, a, b);
  const mp_limb_t* from = middle(r, radius);
  std::copy(from, from + size_, room(out));
  finish(out, radius);
}

void FixedArithmetic::add_product(FixedBall& out, const FixedBall& x, const FixedBall& a,
                                  const FixedBall& b) {
  mp_limb_t* r = scratch(2 * size_);
  double radius = multiply(r, a, b);
  const mp_limb_t* product = middle(r, radius);
  add(out, x.limbs_.data(), product, x.radius_ + radius);
}

void FixedArithmetic::sub_product(FixedBall& out, const FixedBall& x, const FixedBall& a,
                                  const FixedBall& b) {
  mp_limb_t* r = scratch(2 * size_);
  double radius = multiply(r, a, b);
  const mp_limb_t* product = middle(r, radius);
  sub(out, x.limbs_.data(), product, x.radius_ + radius);
}

// A product is at most half of what twice as many limbs can hold. Where two are too much they have
// far more than the format has room for, and the first limb says so.
void FixedArithmetic::sum_of_products(FixedBall& out, const FixedBall& a, const FixedBall& b,
                                      const FixedBall& c, const FixedBall& d) {
  mp_limb_t *r = scratch(4 * size_), *s = r + 2 * size_;
  double radius = multiply(r, a, b) + multiply(s, c, d);
  mpn_add_n(r, r, s, 2 * size_);
  const mp_limb_t* from = middle(r, radius);
  std::copy(from, from + size_, room(out));
  finish(out, radius);
}

void FixedArithmetic::difference_of_products(FixedBall& out, const FixedBall& a, const FixedBall& b,
                                             const FixedBall& c, const FixedBall& d) {
  mp_limb_t *r = scratch(4 * size_), *s = r + 2 * size_;
  double radius = multiply(r, a, b) + multiply(s, c, d);
  mpn_sub_n(r, r, s, 2 * size_);
  const mp_limb_t* from = middle(r, radius);
  std::copy(from, from + size_, room(out));
  finish(out, radius);
}

// |a/b - a0/b0| <= (ra + |a0/b0| rb) / (|b0| - rb).
void FixedArithmetic::div(FixedBall& out, const FixedBall& a, const FixedBall& b) {
  const double least = lower(b) * (1 - 0x1p-50) - b.radius_ * radius_unit_;
  if (!(least > 0)) {
    std::fill_n(room(out), size_, 0);
    out.radius_ = infinity;
    return;
  }
  const double radius_a = a.radius_, radius_b = b.radius_;
  const bool negative = is_negative(a) != is_negative(b);
  // The quotient of |a| 2^(64 fraction) and |b|, as integers.
  mp_limb_t* numerator = scratch(2 * (size_ + fraction_) + 2 * size_ + 1);
  mp_limb_t* denominator = numerator + size_ + fraction_;
  mp_limb_t* rest = denominator + size_;
  mp_limb_t* q = rest + size_;
  std::fill(numerator, numerator + fraction_, 0);
  mp_size_t size = magnitude(numerator + fraction_, a) + fraction_;
  mp_size_t size_b = magnitude(denominator, b);
  // Both lose the zeros that the denominator ends in: divisors are short, mostly.
  const mp_size_t zeros = trailing_zeros(denominator, std::min(size_b - 1, fraction_));
  numerator += zeros;
  size -= zeros;
  denominator += zeros;
  size_b -= zeros;
  mp_limb_t* to = room(out);
  double radius = 0;
  if (size < size_b) {
    std::fill(to, to + size_, 0);
    radius = size == 0 || mpn_zero_p(numerator, size) != 0 ? 0 : last_place_;
  } else {
    mpn_tdiv_qr(q, rest, 0, numerator, size, denominator, size_b);
    if (mpn_zero_p(rest, size_b) == 0) radius = last_place_;
    mp_size_t quotient = size - size_b + 1;
    while (quotient > 0 && q[quotient - 1] == 0) --quotient;
    const mp_size_t kept = std::min(quotient, size_);
    std::copy(q, q + kept, to);
    std::fill(to + kept, to + size_, 0);
    if (quotient > size_ || is_negative(out)) radius = infinity;
  }
  if (negative) mpn_neg(to, to, size_);
  if (radius_a != 0 || radius_b != 0) radius += (radius_a + upper(out) * radius_b) / least;
  finish(out, radius);
}

// |sqrt(x) - sqrt(a0)| <= ra / sqrt(a0) for x >= 0.
void FixedArithmetic::sqrt(FixedBall& out, const FixedBall& a) {
  const Sign s = sign(a);
  if (s != Sign::positive) {
    std::fill_n(room(out), size_, 0);
    out.radius_ = s == Sign::zero ? 0 : infinity;
    return;
  }
  const double radius_a = a.radius_;
  // The root of a 2^(64 fraction), as integers: the point is where it was.
  mp_limb_t* square = scratch(2 * (size_ + fraction_) + 1);
  mp_limb_t* root = square + size_ + fraction_;
  std::fill(square, square + fraction_, 0);
  const mp_size_t size = magnitude(square + fraction_, a) + fraction_;
  const mp_size_t size_of_root = (size + 1) / 2;
  double radius = mpn_sqrtrem(root, nullptr, square, size) != 0 ? last_place_ : 0;
  mp_limb_t* to = room(out);
  std::copy(root, root + size_of_root, to);
  std::fill(to + size_of_root, to + size_, 0);
  // The midpoint is not above the root of a's.
  if (radius_a != 0) radius += radius_a / lower(out);
  finish(out, radius);
}

}  // namespace voroproof::internal
