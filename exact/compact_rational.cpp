#include "exact/compact_rational.h"

#include <cmath>
#include <limits>
#include <utility>

namespace voroproof::internal {

CompactRational::CompactRational(const Rational& q) {
  const double leading = round_nearest(q);
  if (std::isfinite(leading)) {
    const Rational rest = q - to_rational(leading);
    const double second = rest.get_d();
    if (to_rational(second) == rest) {
      leading_ = leading;
      second_ = second;
      return;
    }
  }
  exact_ = new Rational(q);
  leading_ = std::numeric_limits<double>::quiet_NaN();
}

CompactRational::CompactRational(const CompactRational& other) : leading_(other.leading_) {
  if (other.is_allocated()) {
    exact_ = new Rational(*other.exact_);
  } else {
    second_ = other.second_;
  }
}

void CompactRational::swap(CompactRational& other) noexcept {
  const bool here = is_allocated(), there = other.is_allocated();
  const Rational* mine = here ? exact_ : nullptr;
  const double second = here ? 0 : second_;
  if (there) {
    exact_ = other.exact_;
  } else {
    second_ = other.second_;
  }
  if (here) {
    other.exact_ = mine;
  } else {
    other.second_ = second;
  }
  std::swap(leading_, other.leading_);
}

Rational CompactRational::value() const {
  if (is_allocated()) return *exact_;
  if (second_ == 0) return to_rational(leading_);
  return to_rational(leading_) + to_rational(second_);
}

CompactRational square(const CompactRational& a) {
  // The error of the product is a double too where neither is near the ends of the range.
  constexpr double least = 0x1p-450, most = 0x1p500;
  const double x = std::fabs(a.leading_);
  if (a.is_double() && x > least && x < most) {
    CompactRational out(x * x);
    out.second_ = std::fma(x, x, -out.leading_);
    return out;
  }
  const Rational q = a.value();
  return Rational(q * q);
}

CompactRational operator-(const CompactRational& a, const CompactRational& b) {
  const double difference = a.leading_ - b.leading_;
  if (!a.is_double() || !b.is_double() || !std::isfinite(difference)) {
    return Rational(a.value() - b.value());
  }
  // Its error is a double, too (Knuth).
  CompactRational out(difference);
  const double subtracted = a.leading_ - difference;
  out.second_ = (a.leading_ - (difference + subtracted)) + (subtracted - b.leading_) + 0.0;
  return out;
}

double round_nearest(const CompactRational& q) {
  return q.exact() != nullptr ? round_nearest(*q.exact()) : q.leading();
}

}  // namespace voroproof::internal
