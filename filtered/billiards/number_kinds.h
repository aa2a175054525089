// The kinds of numbers in which billiards are computed: fractions, doubles with error bounds, and
// balls of any precision.
#pragma once

#include <cfloat>
#include <cmath>
#include <type_traits>

#include "exact/ball.h"
#include "exact/vector3.h"
#include "filtered/numbers/double_ball.h"

namespace voroproof::internal {

// Enclosures in doubles; of a binary64 the number itself.
inline DoubleBall enclosed(const Rational& q) {
  const double x = q.get_d();  // rounds towards zero
  return {x, to_rational(x) == q ? 0 : std::fabs(x) * 0x1p-52 + DBL_MIN};
}
inline DoubleBall enclosed(const CompactRational& q) {
  if (q.exact() != nullptr) return enclosed(*q.exact());
  return {q.leading(), std::fabs(q.second()) * (1 + 0x1p-50)};
}
inline DoubleBall enclosed(const Ball& b) {
  double lo = 0, hi = 0;
  b.to_interval(lo, hi);
  return DoubleBall::hull(lo, hi);
}
template <class T>
Vector3<DoubleBall> enclosed(const Vector3<T>& v) {
  return {enclosed(v[0]), enclosed(v[1]), enclosed(v[2])};
}

// A fraction in a kind of number; `bits`: the precision of a ball.
template <class T>
T of_kind(const Rational& q, int bits) {
  if constexpr (std::is_same_v<T, Rational>) {
    return q;
  } else if constexpr (std::is_same_v<T, Ball>) {
    return Ball(q, bits);
  } else {
    return enclosed(q);
  }
}
template <class T>
Vector3<T> of_kind(const Vec3& v, int bits) {
  return {of_kind<T>(v[0], bits), of_kind<T>(v[1], bits), of_kind<T>(v[2], bits)};
}

// A small whole number, exactly.
template <class T>
T whole(int k) {
  if constexpr (std::is_same_v<T, Ball>) {
    return Ball(static_cast<double>(k), 64);
  } else {
    return T(k);
  }
}

}  // namespace voroproof::internal
