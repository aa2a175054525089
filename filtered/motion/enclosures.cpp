#include "filtered/motion/enclosures.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>

namespace voroproof::internal {

namespace {

// Whether q is held by its truncation `first` to binary64, by a test that numbers of few digits may
// fail.
bool is_held_by(double first, const Rational& q) {
  return mpz_popcount(q.get_den_mpz_t()) == 1 && mpz_sizeinbase(q.get_num_mpz_t(), 2) <= 53 &&
         std::fabs(first) >= DBL_MIN && std::isfinite(first);
}

}  // namespace

// The nearest double below in magnitude, and what is left of it.
DdBall dd_of(const Rational& q) {
  if (sgn(q) == 0) return {};
  const double first = q.get_d();
  if (is_held_by(first, q)) return {first};
  if (!std::isfinite(first)) return {first, 0, std::numeric_limits<double>::infinity()};
  const Rational rest = q - to_rational(first);
  if (sgn(rest) == 0) return {first};
  const double second = rest.get_d();
  DdBall b;
  dd_detail::fast_two_sum(first, second, b.hi, b.lo);
  if (!is_held_by(second, rest)) b.rad = std::fabs(second) * 0x1p-52 + DBL_MIN;  // towards zero
  return b;
}

DdBall dd_of(const CompactRational& q) {
  if (const Rational* exact = q.exact()) return dd_of(*exact);
  return {q.leading(), q.second(), 0};
}

Ball dyadic_or_rounded(const Rational& q, Ball::Precision bits) {
  // A binary64 or a product of two is held exactly, whatever the working precision.
  const auto& den = q.get_den();
  if (mpz_popcount(den.get_mpz_t()) == 1) {
    const auto size = static_cast<Ball::Precision>(
        std::max<std::size_t>(mpz_sizeinbase(q.get_num_mpz_t(), 2), 2));
    if (size <= 256) return Ball(q, std::max<Ball::Precision>(size, 53));
  }
  return Ball(q, bits);
}

DdBall dd_of(const Ball& b) {
  DdBall r;
  b.to_double_double(r.hi, r.lo, r.rad);
  return r;
}

}  // namespace voroproof::internal
