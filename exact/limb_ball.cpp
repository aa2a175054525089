#include "exact/limb_ball.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace voroproof {

namespace {

static_assert(GMP_NUMB_BITS == 64);

Magnitude one_limb_at(std::int64_t top) { return Magnitude::power_of_two(64 * top); }

}  // namespace

mp_limb_t* LimbBall::room(mp_size_t limbs) {
  if (limbs_.size() < static_cast<std::size_t>(limbs)) limbs_.resize(limbs);
  return limbs_.data();
}

void LimbBall::normalize(mp_size_t size, std::int64_t top) {
  while (size > 0 && limbs_[size - 1] == 0) {
    --size;
    --top;
  }
  mp_size_t zeros = 0;
  while (zeros < size && limbs_[zeros] == 0) ++zeros;
  if (zeros > 0) std::copy(limbs_.begin() + zeros, limbs_.begin() + size, limbs_.begin());
  size_ = size - zeros;
  top_ = top;
}

void LimbBall::set_unknown() {
  size_ = 0;
  radius_ = Magnitude::infinite();
}

void LimbBall::set(double x) {
  radius_ = Magnitude();
  if (x == 0 || !std::isfinite(x)) {
    size_ = 0;
    if (x != 0) set_unknown();
    return;
  }
  // |x| = m 2^(e - 64) for a limb m, its first bit 1; moved down by `shift` bits into two limbs, so
  // that e becomes a multiple of 64.
  int e = 0;
  const double fraction = std::frexp(std::fabs(x), &e);
  const auto m = static_cast<mp_limb_t>(fraction * 0x1p64);
  const std::int64_t top = (e + 63) >> 6;
  const auto shift = static_cast<int>(64 * top - e);
  mp_limb_t* d = room(2);
  d[1] = m >> shift;
  d[0] = shift == 0 ? 0 : m << (64 - shift);
  negative_ = x < 0;
  normalize(2, top);
}

void LimbBall::set(const Ball& b) {
  mpfr_srcptr mid = b.midpoint();
  radius_ = b.radius();
  if (!mpfr_regular_p(mid)) {
    size_ = 0;
    if (!mpfr_zero_p(mid)) set_unknown();
    return;
  }
  // The significand's first bit has the weight 2^(e - 1): as in set(double).
  const auto* from = static_cast<const mp_limb_t*>(mpfr_custom_get_significand(mid));
  const mp_size_t size = (mpfr_get_prec(mid) + 63) / 64;
  const std::int64_t e = mpfr_get_exp(mid);
  const std::int64_t top = (e + 63) >> 6;
  const auto shift = static_cast<unsigned>(64 * top - e);
  mp_limb_t* d = room(size + 1);
  if (shift == 0) {
    d[0] = 0;
    std::copy(from, from + size, d + 1);
  } else {
    d[0] = mpn_rshift(d + 1, from, size, shift);
  }
  negative_ = mpfr_signbit(mid) != 0;
  normalize(size + 1, top);
}

void LimbBall::get(Ball& out, Ball::Precision bits) const {
  const mp_size_t size = bits / 64;
  out.set_precision(bits);
  out.radius_ = radius_;
  if (size_ == 0) {
    mpfr_set_zero(out.mid_, 1);
    return;
  }
  auto* to = static_cast<mp_limb_t*>(mpfr_custom_get_significand(out.mid_));
  const int shift = std::countl_zero(limbs_[size_ - 1]);
  const std::int64_t e = 64 * top_ - shift;
  // The limbs above those that are dropped; what the shift brings up from below them besides.
  const mp_size_t kept = std::min(size_, size), dropped = size_ - kept;
  std::fill(to, to + (size - kept), 0);
  to += size - kept;
  const mp_limb_t* from = limbs_.data() + dropped;
  if (shift == 0) {
    std::copy(from, from + kept, to);
  } else {
    mpn_lshift(to, from, kept, shift);
    if (dropped > 0) to[0] |= from[-1] >> (64 - shift);
  }
  // What is left out, if anything, is less than one in the last place. The first limb is not zero.
  if (dropped > 1 || (dropped == 1 && from[-1] << shift != 0)) {
    out.widen(Magnitude::power_of_two(e - bits));
  }
  mpfr_custom_init_set(out.mid_, negative_ ? -MPFR_REGULAR_KIND : MPFR_REGULAR_KIND, e, bits,
                       mpfr_custom_get_significand(out.mid_));
}

namespace {

// The leading 64 bits of a number of `size` > 0 limbs, the first of them 1, and how many zeros
// stood before them.
mp_limb_t leading_bits(const mp_limb_t* limbs, mp_size_t size, int& zeros) {
  const mp_limb_t first = limbs[size - 1];
  zeros = std::countl_zero(first);
  if (zeros == 0 || size == 1) return first << zeros;
  return first << zeros | limbs[size - 2] >> (64 - zeros);
}

}  // namespace

// The midpoint is m 2^(e - 64) with m in [leading, leading + 1), e = 64 top - zeros.
Magnitude LimbBall::upper() const {
  int zeros = 0;
  const mp_limb_t leading = leading_bits(limbs_.data(), size_, zeros);
  return Magnitude::of(static_cast<double>((leading >> 11) + 1)).scaled(64 * top_ - zeros - 53);
}
Magnitude LimbBall::lower() const {
  int zeros = 0;
  const mp_limb_t leading = leading_bits(limbs_.data(), size_, zeros);
  return Magnitude::of(static_cast<double>(leading >> 11)).scaled(64 * top_ - zeros - 53);
}

Sign LimbBall::sign() const {
  if (size_ == 0) return radius_.is_zero() ? Sign::zero : Sign::unknown;
  if (!(radius_ < lower())) return Sign::unknown;
  return negative_ ? Sign::negative : Sign::positive;
}

void LimbArithmetic::set_precision(Ball::Precision bits) {
  // The leading limb may be as small as 1.
  limbs_ = (bits + 63) / 64 + 1;
}

mp_limb_t* LimbArithmetic::scratch(mp_size_t limbs) {
  if (scratch_.size() < static_cast<std::size_t>(limbs)) scratch_.resize(limbs);
  return scratch_.data();
}

// What is left out is less than one in the last place that is kept.
void LimbArithmetic::truncate(LimbBall& out, const mp_limb_t* limbs, mp_size_t size,
                              std::int64_t top, const Magnitude& radius) {
  while (size > 0 && limbs[size - 1] == 0) {
    --size;
    --top;
  }
  const mp_size_t kept = std::min(size, limbs_);
  const mp_limb_t* from = limbs + (size - kept);
  std::copy(from, from + kept, out.room(kept));
  out.radius_ = radius;
  if (kept < size && mpn_zero_p(limbs, size - kept) == 0) {
    out.radius_ = out.radius_ + one_limb_at(top - kept);
  }
  out.normalize(kept, top);
}

void LimbArithmetic::add(LimbBall& out, const LimbBall& a, const LimbBall& b) {
  add_signed(out, a, b, b.negative_);
}
void LimbArithmetic::sub(LimbBall& out, const LimbBall& a, const LimbBall& b) {
  add_signed(out, a, b, !b.negative_);
}

void LimbArithmetic::add_signed(LimbBall& out, const LimbBall& a, const LimbBall& b,
                                bool b_negative) {
  const Magnitude radius = a.radius_ + b.radius_;
  if (a.size_ == 0 || b.size_ == 0) {
    const LimbBall& x = a.size_ == 0 ? b : a;
    const bool negative = a.size_ == 0 ? b_negative : a.negative_;
    if (&out != &x) {
      std::copy(x.limbs_.begin(), x.limbs_.begin() + x.size_, out.room(x.size_));
      out.size_ = x.size_;
      out.top_ = x.top_;
    }
    out.negative_ = negative;
    out.radius_ = radius;
    return;
  }
  // Both in a frame of limbs from `low` to `high`; of what lies below the frame each operand loses
  // less than one in its last place.
  const std::int64_t high = std::max(a.top_, b.top_);
  const std::int64_t low = std::max(std::min(a.top_ - a.size_, b.top_ - b.size_), high - limbs_);
  const auto width = static_cast<mp_size_t>(high - low);
  mp_limb_t* r = scratch(width + 1);
  Magnitude lost = radius;
  const auto part = [&](const LimbBall& x, const mp_limb_t*& from, mp_size_t& offset) {
    const std::int64_t bottom = x.top_ - x.size_;
    if (bottom < low) lost = lost + one_limb_at(low);
    offset = static_cast<mp_size_t>(std::max<std::int64_t>(bottom - low, 0));
    const auto below = static_cast<mp_size_t>(std::clamp<std::int64_t>(low - bottom, 0, x.size_));
    from = x.limbs_.data() + below;
    return x.size_ - below;
  };
  const mp_limb_t *from_a = nullptr, *from_b = nullptr;
  mp_size_t offset_a = 0, offset_b = 0;
  const mp_size_t size_a = part(a, from_a, offset_a), size_b = part(b, from_b, offset_b);
  std::fill(r, r + offset_a, 0);
  std::copy(from_a, from_a + size_a, r + offset_a);
  std::fill(r + offset_a + size_a, r + width + 1, 0);
  bool negative = a.negative_;
  if (size_b > 0) {
    if (a.negative_ == b_negative) {
      r[width] = mpn_add(r + offset_b, r + offset_b, width - offset_b, from_b, size_b);
    } else if (mpn_sub(r + offset_b, r + offset_b, width - offset_b, from_b, size_b) != 0) {
      mpn_neg(r, r, width);
      negative = !negative;
    }
  }
  out.negative_ = negative;
  truncate(out, r, width + 1, high + 1, lost);
}

// |a b - a0 b0| <= ra (|b0| + rb) + rb |a0|.
void LimbArithmetic::mul(LimbBall& out, const LimbBall& a, const LimbBall& b) {
  Magnitude radius;
  if (!a.radius_.is_zero()) {
    radius = a.radius_ * (b.size_ == 0 ? b.radius_ : b.upper() + b.radius_);
  }
  if (!b.radius_.is_zero() && a.size_ > 0) radius = radius + b.radius_ * a.upper();
  if (a.size_ == 0 || b.size_ == 0) {
    out.size_ = 0;
    out.radius_ = radius;
    return;
  }
  const mp_size_t size = a.size_ + b.size_;
  mp_limb_t* r = scratch(size);
  if (&a == &b) {
    mpn_sqr(r, a.limbs_.data(), a.size_);
  } else if (a.size_ >= b.size_) {
    mpn_mul(r, a.limbs_.data(), a.size_, b.limbs_.data(), b.size_);
  } else {
    mpn_mul(r, b.limbs_.data(), b.size_, a.limbs_.data(), a.size_);
  }
  out.negative_ = a.negative_ != b.negative_;
  truncate(out, r, size, a.top_ + b.top_, radius);
}

// |a/b - a0/b0| <= (ra + |a0/b0| rb) / (|b0| - rb).
void LimbArithmetic::div(LimbBall& out, const LimbBall& a, const LimbBall& b) {
  const Sign sign = b.sign();
  if (sign != Sign::positive && sign != Sign::negative) {
    out.set_unknown();
    return;
  }
  const Magnitude radius_a = a.radius_, radius_b = b.radius_;
  const Magnitude inverse = (b.lower() - radius_b).inverse();
  if (a.size_ == 0) {
    out.size_ = 0;
    out.radius_ = radius_a * inverse;
    return;
  }
  // The quotient of a, moved to as many limbs as b has and `limbs_` more, has limbs_ + 1 limbs. a
  // is never longer: results have no more than limbs_, numbers that were set may have one more.
  const mp_size_t size = std::max(b.size_ + limbs_, a.size_);
  const mp_size_t quotient = size - b.size_ + 1;
  mp_limb_t* q = scratch(quotient + size + b.size_);
  mp_limb_t* numerator = q + quotient;
  std::fill(numerator, numerator + (size - a.size_), 0);
  std::copy(a.limbs_.begin(), a.limbs_.begin() + a.size_, numerator + (size - a.size_));
  mp_limb_t* rest = numerator + size;
  mpn_tdiv_qr(q, rest, 0, numerator, size, b.limbs_.data(), b.size_);
  const std::int64_t top = a.top_ - b.top_ + 1;
  // Cut off where the remainder begins; if it is zero the quotient is exact.
  Magnitude radius;
  if (mpn_zero_p(rest, b.size_) == 0) radius = one_limb_at(top - quotient);
  out.negative_ = a.negative_ != b.negative_;
  truncate(out, q, quotient, top, radius);
  if (!radius_a.is_zero() || !radius_b.is_zero()) {
    // The quotient of the midpoints is at most that of what was kept and cut off.
    Magnitude quotient_up = out.radius_;
    if (out.size_ > 0) quotient_up = quotient_up + out.upper();
    out.radius_ = out.radius_ + (radius_a + quotient_up * radius_b) * inverse;
  }
}

// |sqrt(x) - sqrt(a0)| <= ra / sqrt(a0) for x >= 0.
void LimbArithmetic::sqrt(LimbBall& out, const LimbBall& a) {
  const Sign sign = a.sign();
  if (sign != Sign::positive) {
    out.set_unknown();
    if (sign == Sign::zero) out.radius_ = Magnitude();
    return;
  }
  const Magnitude radius_a = a.radius_;
  // a in twice as many limbs as the root shall have, or one less: the exponent must be even.
  mp_size_t size = std::max(2 * limbs_, a.size_);
  if (((a.top_ - size) & 1) != 0) ++size;
  const mp_size_t root = (size + 1) / 2;
  mp_limb_t* r = scratch(root + size);
  mp_limb_t* square = r + root;
  std::fill(square, square + (size - a.size_), 0);
  std::copy(a.limbs_.begin(), a.limbs_.begin() + a.size_, square + (size - a.size_));
  const std::int64_t bottom = (a.top_ - size) / 2;
  Magnitude radius;
  if (mpn_sqrtrem(r, nullptr, square, size) != 0) radius = one_limb_at(bottom);
  out.negative_ = false;
  truncate(out, r, root, bottom + root, radius);
  // The midpoint is not above the root of a's.
  if (!radius_a.is_zero()) out.radius_ = out.radius_ + radius_a * out.lower().inverse();
}

}  // namespace voroproof
