#include "exact/fixed_ball.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace voroproof::internal {

namespace {

static_assert(GMP_NUMB_BITS == 64);

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Some ten roundings of a radius, each of 2^-53, are paid for by this factor.
constexpr double kUp = 1 + 0x1p-48;
// A radius that is not zero is not less, so that its products with what `upper` returns do not
// underflow.
constexpr double kLeastRadius = 0x1p-800;

// 2^e, for -1000 <= e <= 1000.
double power_of_two(std::int64_t e) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + e) << 52);
}

// x 2^e.
double scaled(double x, std::int64_t e) {
  if (std::abs(e) <= 1000) return x * power_of_two(e);
  return std::ldexp(x, static_cast<int>(std::clamp<std::int64_t>(e, -4000, 4000)));
}

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
    return e > 800 ? kInfinity : power_of_two(std::max<std::int64_t>(e, -800));
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

// A bound of |a| from above, never zero. Of a negative number the limbs are inverted, which gives
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
  if (radius != 0) radius = std::max(radius * kUp, kLeastRadius);
  out.radius_ = radius < std::numeric_limits<double>::max() ? radius : kInfinity;
}

// Writes the number m 2^exponent, the integer m of `size` limbs of which the last has its first bit
// set taken as a fraction in [1/2, 1); adds to the radius what is left out.
void FixedArithmetic::place(FixedBall& out, const mp_limb_t* from, mp_size_t size,
                            std::int64_t exponent, bool negative) {
  mp_limb_t* to = room(out);
  std::fill(to, to + size_, 0);
  const std::int64_t top = exponent + 64 * fraction_;  // bits in units of the last place
  if (top >= 64 * size_) {
    out.radius_ = kInfinity;
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
  if (cut) out.radius_ = (out.radius_ + last_place_) * kUp;
}

void FixedArithmetic::set(FixedBall& out, double x, std::int64_t unit) {
  out.radius_ = 0;
  mp_limb_t* to = room(out);
  std::fill_n(to, size_, 0);
  if (x == 0) return;
  // |x| = m 2^(e - 64), the first bit of m being set.
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto field = static_cast<int>((bits >> 52) & 0x7ff);
  mp_limb_t m = bits << 11 | std::uint64_t{1} << 63;
  std::int64_t e = field - 1022;
  if (field == 0) {
    const int zeros = std::countl_zero(bits << 1) + 1;
    m = bits << zeros;
    e = 64 - 1074 - zeros;
  }
  const std::int64_t top = e - unit + 64 * fraction_;  // bits in units of the last place
  if (field == 0x7ff || top >= 64 * size_) {
    out.radius_ = kInfinity;
    return;
  }
  if (top <= 0) {
    out.radius_ = last_place_ * kUp;
    return;
  }
  const mp_size_t k = (top - 1) / 64;
  const auto used = static_cast<unsigned>(top - 64 * k);  // of m in limb k, the rest in the next
  const mp_limb_t rest = used == 64 ? 0 : m << used;
  to[k] = m >> (64 - used);
  if (k > 0) {
    to[k - 1] = rest;
  } else if (rest != 0) {
    out.radius_ = last_place_ * kUp;
  }
  if (x < 0) mpn_neg(to, to, size_);
}

void FixedArithmetic::set(FixedBall& out, const Ball& x, std::int64_t unit) {
  out.radius_ = 0;
  if (!x.is_exact()) {
    const double r = x.radius().scaled(-unit - radius_exponent_).to_double();
    out.radius_ = std::max(r, kLeastRadius);
  }
  mpfr_srcptr mid = x.midpoint();
  if (!mpfr_regular_p(mid)) {
    std::fill_n(room(out), size_, 0);
    if (!mpfr_zero_p(mid)) out.radius_ = kInfinity;
    return;
  }
  place(out, static_cast<const mp_limb_t*>(mpfr_custom_get_significand(mid)),
        (mpfr_get_prec(mid) + 63) / 64, mpfr_get_exp(mid) - unit, mpfr_signbit(mid) != 0);
}

// Limbs after the point that the format does not have are cut off, which rounds down.
void FixedArithmetic::set(FixedBall& out, const FixedView& x) const {
  mp_limb_t* to = room(out);
  const mp_limb_t sign = x.is_negative() ? ~mp_limb_t{0} : 0;
  // Limb k is limb k + ahead of x.
  const mp_size_t ahead = x.fraction_ - fraction_;
  const mp_size_t first = std::max<mp_size_t>(0, -ahead), last = std::min(size_, x.size_ - ahead);
  std::fill(to, to + first, 0);
  std::copy(x.limbs_ + first + ahead, x.limbs_ + last + ahead, to + first);
  std::fill(to + last, to + size_, sign);
  double radius = 0;
  if (x.radius_ != 0) {
    const std::int64_t shift = x.radius_exponent_ - radius_exponent_;
    radius = std::max(scaled(x.radius_, shift), kLeastRadius);
  }
  if (ahead > 0 && mpn_zero_p(x.limbs_, ahead) == 0) radius += last_place_;
  for (mp_size_t k = size_ + ahead; k < x.size_; ++k) {
    if (x.limbs_[k] != sign) radius = kInfinity;
  }
  if (is_negative(out) != x.is_negative()) radius = kInfinity;
  finish(out, radius);
}

void FixedArithmetic::store(FixedRow& row, const std::array<const FixedBall*, 4>& numbers) const {
  row.size_ = size_;
  row.fraction_ = fraction_;
  row.radius_exponent_ = radius_exponent_;
  row.limbs_.resize(static_cast<std::size_t>(4 * size_));
  for (std::size_t k = 0; k < 4; ++k) {
    const FixedBall& a = *numbers[k];
    std::copy(a.limbs_.begin(), a.limbs_.begin() + size_,
              row.limbs_.begin() + static_cast<std::ptrdiff_t>(k) * size_);
    row.radii_[k] = a.radius_;
  }
}

Magnitude FixedView::radius() const {
  if (std::isinf(radius_)) return Magnitude::infinite();
  return Magnitude::of(radius_).scaled(radius_exponent_);
}

void FixedView::get(Ball& out, std::int64_t unit, Ball::Precision bits) const {
  out.set_precision(bits);
  out.radius_ = radius().scaled(unit);
  std::vector<mp_limb_t> from(limbs_, limbs_ + size_);
  if (is_negative()) mpn_neg(from.data(), limbs_, size_);
  while (!from.empty() && from.back() == 0) from.pop_back();
  if (from.empty()) {
    mpfr_set_zero(out.mid_, 1);
    return;
  }
  const auto size = static_cast<mp_size_t>(from.size());
  auto* to = static_cast<mp_limb_t*>(mpfr_custom_get_significand(out.mid_));
  const mp_size_t wanted = bits / 64;
  const auto shift = static_cast<unsigned>(std::countl_zero(from.back()));
  if (shift > 0) mpn_lshift(from.data(), from.data(), size, shift);
  const std::int64_t e = 64 * (size - fraction_) - shift + unit;
  const mp_size_t kept = std::min(size, wanted), dropped = size - kept;
  std::fill(to, to + (wanted - kept), 0);
  std::copy(from.begin() + dropped, from.end(), to + (wanted - kept));
  if (dropped > 0 && mpn_zero_p(from.data(), dropped) == 0) {
    out.widen(Magnitude::power_of_two(e - bits));
  }
  mpfr_custom_init_set(out.mid_, is_negative() ? -MPFR_REGULAR_KIND : MPFR_REGULAR_KIND, e, bits,
                       mpfr_custom_get_significand(out.mid_));
}

// Of a negative number the inverted limbs are its magnitude less one in the last place.
void FixedView::to_double_double(std::int64_t unit, double& hi, double& lo, double& err) const {
  if (radius_ != 0 && !std::isinf(radius_)) {
    const mp_limb_t flip = is_negative() ? ~mp_limb_t{0} : 0;
    mp_size_t k = size_ - 1;
    while (k > 2 && (limbs_[k] ^ flip) == 0) --k;
    const std::uint64_t a = limbs_[k] ^ flip;
    if (a != 0 && k >= 2) {
      const std::uint64_t b = limbs_[k - 1] ^ flip, c = limbs_[k - 2] ^ flip;
      const int shift = std::countl_zero(a);
      const std::uint64_t top = shift == 0 ? a : a << shift | b >> (64 - shift);
      const std::uint64_t next = shift == 0 ? b : b << shift | c >> (64 - shift);
      if (leading_double_double(top, next, 64 * (k + 1 - fraction_) - shift + unit, flip != 0,
                                radius().scaled(unit).to_double(), hi, lo, err)) {
        return;
      }
    }
  }
  Ball b;
  get(b, unit, 64 * std::max<mp_size_t>(size_, 3));
  b.to_double_double(hi, lo, err);
}

Sign FixedArithmetic::sign(const FixedBall& a) const {
  const bool zero = mpn_zero_p(a.limbs_.data(), size_) != 0;
  if (a.radius_ == 0) {
    return zero ? Sign::zero : is_negative(a) ? Sign::negative : Sign::positive;
  }
  if (zero || std::isinf(a.radius_)) return Sign::unknown;
  const Magnitude radius = Magnitude::of(a.radius_).scaled(radius_exponent_);
  if (!(radius < Magnitude::of(lower(a)))) return Sign::unknown;
  return is_negative(a) ? Sign::negative : Sign::positive;
}

void FixedArithmetic::negate(FixedBall& a) const {
  const bool negative = is_negative(a);
  mpn_neg(a.limbs_.data(), a.limbs_.data(), size_);
  if (negative && is_negative(a)) a.radius_ = kInfinity;
}

void FixedArithmetic::add(FixedBall& out, const mp_limb_t* a, const mp_limb_t* b,
                          double radius) const {
  const bool same = is_negative(a) == is_negative(b), negative = is_negative(a);
  mpn_add_n(room(out), a, b, size_);
  finish(out, same && is_negative(out) != negative ? kInfinity : radius);
}

void FixedArithmetic::sub(FixedBall& out, const mp_limb_t* a, const mp_limb_t* b,
                          double radius) const {
  const bool different = is_negative(a) != is_negative(b), negative = is_negative(a);
  mpn_sub_n(room(out), a, b, size_);
  finish(out, different && is_negative(out) != negative ? kInfinity : radius);
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

// What of such a product the format has room for, rounded down: less than one in the last place.
const mp_limb_t* FixedArithmetic::middle(const mp_limb_t* r, double& radius) const {
  if (r[fraction_ - 1] != 0 || mpn_zero_p(r, fraction_) == 0) radius += last_place_;
  const mp_limb_t* from = r + fraction_;
  const mp_limb_t sign = is_negative(from) ? ~mp_limb_t{0} : 0;
  for (const mp_limb_t* k = from + size_; k != r + 2 * size_; ++k) {
    if (*k != sign) radius = kInfinity;
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
    out.radius_ = kInfinity;
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
  // Both without as many zeros: divisors are short, mostly.
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
    if (quotient > size_ || is_negative(out)) radius = kInfinity;
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
    out.radius_ = s == Sign::zero ? 0 : kInfinity;
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
