// Numbers into fixed-point balls and out of them.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

#include "exact/fixed_ball.h"
#include "exact/fixed_ball_bounds.h"

namespace voroproof::internal {

using namespace fixed_ball_bounds;

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
    out.radius_ = infinity;
    return;
  }
  if (top <= 0) {
    out.radius_ = last_place_ * up;
    return;
  }
  const mp_size_t k = (top - 1) / 64;
  const auto used = static_cast<unsigned>(top - 64 * k);  // bits of m in limb k, the others below
  const mp_limb_t rest = used == 64 ? 0 : m << used;
  to[k] = m >> (64 - used);
  if (k > 0) {
    to[k - 1] = rest;
  } else if (rest != 0) {
    out.radius_ = last_place_ * up;
  }
  if (x < 0) mpn_neg(to, to, size_);
}

void FixedArithmetic::set(FixedBall& out, const Ball& x, std::int64_t unit) {
  out.radius_ = 0;
  if (!x.is_exact()) {
    const double r = x.radius().scaled(-unit - radius_exponent_).to_double();
    out.radius_ = std::max(r, least_radius);
  }
  const Ball::Digits d = x.is_finite() ? x.digits() : Ball::Digits{};
  if (d.size > 0) {
    place(out, d.limbs, d.size, d.exponent - unit, d.negative);
  } else {
    std::fill_n(room(out), size_, 0);
    if (!x.is_finite()) out.radius_ = infinity;
  }
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
    radius = std::max(scaled(x.radius_, shift), least_radius);
  }
  if (ahead > 0 && mpn_zero_p(x.limbs_, ahead) == 0) radius += last_place_;
  for (mp_size_t k = size_ + ahead; k < x.size_; ++k) {
    if (x.limbs_[k] != sign) radius = infinity;
  }
  if (is_negative(out) != x.is_negative()) radius = infinity;
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

std::int64_t FixedView::exponent_of_radius() const {
  if (std::isinf(radius_)) return std::int64_t{1} << 62;
  return std::ilogb(radius_) + radius_exponent_;
}

Ball FixedView::ball(std::int64_t unit, Ball::Precision bits) const {
  const auto of = [&](const mp_limb_t* magnitude) {
    return Ball(magnitude, size_, 64 * (size_ - fraction_) + unit, is_negative(),
                Magnitude::of(radius_).scaled(radius_exponent_ + unit), bits);
  };
  if (!is_negative()) return of(limbs_);
  std::vector<mp_limb_t> magnitude(static_cast<std::size_t>(size_));
  mpn_neg(magnitude.data(), limbs_, size_);
  return of(magnitude.data());
}

// The inverted limbs of a negative number are its magnitude less one in the last place.
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
      // A radius that underflows is less than what the bound is rounded up by.
      if (leading_double_double(top, next, 64 * (k + 1 - fraction_) - shift + unit, flip != 0,
                                scaled(radius_, radius_exponent_ + unit), hi, lo, err)) {
        return;
      }
    }
  }
  ball(unit, 64 * size_).to_double_double(hi, lo, err);
}

}  // namespace voroproof::internal
