// A number that depends on time, with its derivative: forward-mode differentiation of
// the predicates, which are templates over the number type.
#pragma once

namespace voroproof::internal {

template <class T>
struct Dual {
  T value, slope;

  friend Dual operator+(const Dual& x, const Dual& y) {
    return {x.value + y.value, x.slope + y.slope};
  }
  friend Dual operator-(const Dual& x, const Dual& y) {
    return {x.value - y.value, x.slope - y.slope};
  }
  friend Dual operator*(const Dual& x, const Dual& y) {
    return {x.value * y.value, x.value * y.slope + x.slope * y.value};
  }
  Dual operator-() const { return {-value, -slope}; }
  // Precondition: the value is positive.
  friend Dual sqrt(const Dual& x) {
    const T root = sqrt(x.value);
    return {root, x.slope / (root + root)};
  }
};

}  // namespace voroproof::internal
