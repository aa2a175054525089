// Vectors of the plane and of space, over numbers of any kind; in the plane the third coordinate is
// zero.
#pragma once

#include <array>

#include "exact/compact_rational.h"
#include "exact/rational.h"

namespace voroproof::internal {

template <class T>
using Vector3 = std::array<T, 3>;
using Vec3 = Vector3<Rational>;
using CompactVec3 = Vector3<CompactRational>;

template <class T>
Vector3<T> operator+(const Vector3<T>& a, const Vector3<T>& b) {
  return {T(a[0] + b[0]), T(a[1] + b[1]), T(a[2] + b[2])};
}
template <class T>
Vector3<T> operator-(const Vector3<T>& a, const Vector3<T>& b) {
  return {T(a[0] - b[0]), T(a[1] - b[1]), T(a[2] - b[2])};
}
template <class T>
Vector3<T> operator*(const Vector3<T>& a, const T& factor) {
  return {T(a[0] * factor), T(a[1] * factor), T(a[2] * factor)};
}
template <class T>
T dot(const Vector3<T>& a, const Vector3<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace voroproof::internal
