// Polynomials for tests of their roots: over the rationals and a tower, some at random.
#pragma once

#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

#include "exact/algebraic.h"
#include "exact/polynomial.h"
#include "exact/rational.h"
#include "exact/tower.h"
#include "tests/exact/fraction.h"

namespace voroproof::internal::testing {

using RationalPolynomial = Polynomial<Rational>;
using TowerPolynomial = Polynomial<Tower>;

template <class T>
Polynomial<T> linear(const T& root) {
  return {T(-root), T(1)};
}

class RandomNumbers {
 public:
  explicit RandomNumbers(unsigned seed) : engine_(seed) {}
  long below(long n) { return static_cast<long>(engine_() % static_cast<unsigned long>(n)); }
  Rational number() {
    const long numerator = below(41) - 20;
    return fraction(numerator, 1 + below(8));
  }
  RationalPolynomial polynomial(int degree) {
    std::vector<Rational> coefficients;
    for (int i = 0; i < degree; ++i) coefficients.push_back(number());
    coefficients.push_back(1 + below(5));
    return RationalPolynomial(std::move(coefficients));
  }

 private:
  std::mt19937_64 engine_;
};

// The one root there is in [lo, hi].
template <class T>
AlgebraicNumber<T> only_root(const Polynomial<T>& f, const Rational& lo, const Rational& hi) {
  const auto roots = real_roots(f, lo, hi);
  EXPECT_EQ(roots.size(), 1u);
  return roots.at(0);
}

}  // namespace voroproof::internal::testing
