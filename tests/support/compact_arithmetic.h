// Arithmetic of CompactRational with itself and other numbers: slow, and handy in tests.
#pragma once

#include <concepts>

#include "exact/compact_rational.h"

namespace voroproof::internal {

template <class A, class B>
concept CompactOperands = (std::same_as<A, CompactRational> ||
                           std::same_as<B, CompactRational>)&&requires(const A& a, const B& b) {
  Rational(a);
  Rational(b);
};

template <class A, class B>
requires CompactOperands<A, B> Rational operator+(const A& a, const B& b) {
  return Rational(a) + Rational(b);
}
template <class A, class B>
requires CompactOperands<A, B> Rational operator-(const A& a, const B& b) {
  return Rational(a) - Rational(b);
}
template <class A, class B>
requires CompactOperands<A, B> Rational operator*(const A& a, const B& b) {
  return Rational(a) * Rational(b);
}
template <class A, class B>
requires CompactOperands<A, B> Rational operator/(const A& a, const B& b) {
  return Rational(a) / Rational(b);
}
template <class A, class B>
requires CompactOperands<A, B>
auto operator<=>(const A& a, const B& b) { return cmp(Rational(a), Rational(b)) <=> 0; }
inline Rational operator-(const CompactRational& a) { return -a.value(); }

template <class B>
CompactRational& operator+=(CompactRational& a, const B& b) {
  return a = a + b;
}
template <class B>
CompactRational& operator-=(CompactRational& a, const B& b) {
  return a = a - b;
}
template <class B>
CompactRational& operator*=(CompactRational& a, const B& b) {
  return a = a * b;
}
template <class B>
CompactRational& operator/=(CompactRational& a, const B& b) {
  return a = a / b;
}

// change(x, y) with references to Rationals of both values, which become the new ones.
template <class Change>
void change_both(CompactRational& x, CompactRational& y, Change&& change) {
  Rational new_x = x, new_y = y;
  change(new_x, new_y);
  x = new_x;
  y = new_y;
}

}  // namespace voroproof::internal
