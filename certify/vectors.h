// Vectors of the plane in rationals and in enclosures, and bounds of their lengths.
#pragma once

#include <array>
#include <cfloat>
#include <cmath>
#include <limits>

#include "exact/compact_rational.h"
#include "filtered/numbers/dd_ball.h"
#include "filtered/numbers/double_ball.h"
#include "history/events.h"

namespace voroproof::internal {

using BallVec2 = std::array<DoubleBall, 2>;

// One vector each of two that collide, i < j, at [0] and [1]. For the container [0] is unused.
using ExactPair = std::array<ExactVec2, 2>;
using BallPair = std::array<BallVec2, 2>;

inline Rational square(const Rational& x) { return x * x; }

template <class T>
T norm2(const std::array<T, 2>& v) {
  return v[0] * v[0] + v[1] * v[1];
}
template <class T>
std::array<T, 2> minus(const std::array<T, 2>& a, const std::array<T, 2>& b) {
  return {a[0] - b[0], a[1] - b[1]};
}

// An enclosure: get_d() rounds towards zero.
inline DoubleBall ball(const Rational& q) {
  const double x = q.get_d();
  return {x, std::fabs(x) * 0x1p-52 + DBL_MIN};
}
inline DoubleBall ball(const CompactRational& q) {
  if (const Rational* exact = q.exact()) return ball(*exact);
  return {q.leading(), std::fabs(q.second()) * (1 + 0x1p-50)};
}
inline BallVec2 ball(const ExactVec2& v) { return {ball(v[0]), ball(v[1])}; }
inline BallVec2 ball(const Vec2& v) { return {DoubleBall(v[0]), DoubleBall(v[1])}; }
inline DoubleBall ball(const DdBall& x) {
  return {x.hi, (std::fabs(x.lo) + x.rad) * (1 + 0x1p-50)};
}

// An upper bound of the square root of n >= 0, good to a part in 10^15. The square of a length may
// be beyond all doubles, or below them: it is brought to about 1 by a power of 4.
inline Rational root_bound(Rational n) {
  if (n == 0) return n;
  const auto bits = [](const Integer& x) {
    return static_cast<long>(mpz_sizeinbase(x.get_mpz_t(), 2));
  };
  const long half = (bits(n.get_num()) - bits(n.get_den())) / 2;
  const auto times_power = [](const Rational& q, long exponent) {
    return exponent < 0 ? Rational(q >> static_cast<unsigned long>(-exponent))
                        : Rational(q << static_cast<unsigned long>(exponent));
  };
  n = times_power(n, -2 * half);
  const double root =
      std::nextafter(std::sqrt(round_up(n)), std::numeric_limits<double>::infinity());
  return times_power(to_rational(root), half);
}

// Such a bound of the length of a vector.
inline Rational length_bound(const ExactVec2& v) { return root_bound(norm2(v)); }

}  // namespace voroproof::internal
