// Values of one polynomial at many rational points: their signs exactly, and where zeros are to be
// expected.
//
// All templates are instantiated for Rational and Tower.
#pragma once

#include <vector>

#include "exact/ball.h"
#include "exact/polynomial.h"
#include "exact/rational.h"

namespace voroproof::internal {

// A polynomial up to a positive factor: each coefficient lies between coefficients[i] and
// coefficients[i] + widths[i]. Widths vanish for rationals.
struct Approximation {
  std::vector<Integer> coefficients, widths;
};
Approximation approximate(const Polynomial<Rational>& f, Ball::Precision precision);
Approximation approximate(const Polynomial<Tower>& f, Ball::Precision precision);

// Signs come from integers; over a tower from balls where the errors of these leave the sign open,
// and from the polynomial itself where the balls do.
template <class T>
class SignEvaluator {
 public:
  explicit SignEvaluator(const Polynomial<T>& f);
  Sign operator()(const Rational& x) const;

  // Where the secant through the values at lo and hi meets zero, as a part of the way from lo to hi
  // that is a multiple of 2^-bits. A guess: within [0, 1] where the signs at lo and hi differ.
  Rational secant(const Rational& lo, const Rational& hi, Ball::Precision bits) const;

 private:
  Ball value(const Rational& x, Ball::Precision precision) const;

  Polynomial<T> f_;
  Approximation approximation_;  // a positive multiple of f
};

template <class T>
Sign sign_at(const Polynomial<T>& f, const Rational& x);

}  // namespace voroproof::internal
