#include "exact/polynomial.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace voroproof::internal {
namespace {

// Random polynomials of both kinds behind one interface, so that every law is
// tested for both.
class RationalSource {
 public:
  using Number = Rational;
  explicit RationalSource(unsigned seed) : random_(seed) {}
  Rational number() {
    Rational q{static_cast<long>(random_() % 21) - 10, 1 + random_() % 6};
    q.canonicalize();
    return q;
  }
  std::size_t below(std::size_t n) { return random_() % n; }

 private:
  std::mt19937_64 random_;
};

class TowerSource {
 public:
  using Number = Tower;
  explicit TowerSource(unsigned seed) : rational_(seed) {
    s_ = field_.sqrt(2);
    t_ = field_.sqrt(Tower(5) - 2 * s_);
  }
  Tower number() {
    const Tower a = rational_.number();
    if (below(3) == 0) return a;
    const Tower b = rational_.number();
    return a + b * s_ + rational_.number() * t_;
  }
  std::size_t below(std::size_t n) { return rational_.below(n); }

 private:
  RationalSource rational_;
  RadicalField field_;
  Tower s_, t_;
};

template <class Source>
class PolynomialLaws : public testing::Test {
 protected:
  using T = typename Source::Number;

  Polynomial<T> polynomial(std::size_t max_degree) {
    std::vector<T> coefficients(1 + source_.below(max_degree + 1));
    for (T& c : coefficients) c = source_.number();
    return Polynomial<T>(std::move(coefficients));
  }
  Polynomial<T> nonzero(std::size_t max_degree) {
    for (;;) {
      Polynomial<T> f = polynomial(max_degree);
      if (!f.is_zero()) return f;
    }
  }

  Source source_{7};
};
using Sources = testing::Types<RationalSource, TowerSource>;
TYPED_TEST_SUITE(PolynomialLaws, Sources);

TYPED_TEST(PolynomialLaws, EvaluationIsAHomomorphism) {
  using T = typename TypeParam::Number;
  for (int i = 0; i < 50; ++i) {
    const Polynomial<T> f = this->polynomial(5);
    const Polynomial<T> g = this->polynomial(5);
    const T x = this->source_.number();
    const T fx = f.evaluate(x);
    const T gx = g.evaluate(x);
    EXPECT_EQ((f + g).evaluate(x), T(fx + gx));
    EXPECT_EQ((f - g).evaluate(x), T(fx - gx));
    EXPECT_EQ((f * g).evaluate(x), T(fx * gx));
    EXPECT_EQ((f * x).evaluate(x), T(fx * x));
    EXPECT_EQ((x * f).evaluate(x), T(fx * x));
    EXPECT_EQ((-f).evaluate(x), T(-fx));
    EXPECT_TRUE((f - f).is_zero());
    EXPECT_EQ((f - f).degree(), -1);
  }
}

TYPED_TEST(PolynomialLaws, DerivativeObeysTheProductRule) {
  using T = typename TypeParam::Number;
  for (int i = 0; i < 50; ++i) {
    const Polynomial<T> f = this->polynomial(5);
    const Polynomial<T> g = this->polynomial(5);
    EXPECT_EQ((f * g).derivative(), f.derivative() * g + f * g.derivative());
    EXPECT_EQ((f + g).derivative(), f.derivative() + g.derivative());
  }
  EXPECT_TRUE(Polynomial<T>{T(4)}.derivative().is_zero());
}

TYPED_TEST(PolynomialLaws, DivisionGivesQuotientAndSmallerRemainder) {
  using T = typename TypeParam::Number;
  for (int i = 0; i < 50; ++i) {
    const Polynomial<T> f = this->polynomial(7);
    const Polynomial<T> g = this->nonzero(4);
    const Division<T> division = divide(f, g);
    EXPECT_EQ(division.quotient * g + division.remainder, f);
    EXPECT_LT(division.remainder.degree(), g.degree());
    const Division<T> exact = divide(f * g, g);
    EXPECT_EQ(exact.quotient, f);
    EXPECT_TRUE(exact.remainder.is_zero());
  }
  EXPECT_THROW(divide(this->nonzero(3), Polynomial<T>()), std::domain_error);
}

// Divisibility both ways, and coprime cofactors shown by an identity of their own:
// their resultant, as the determinant that elimination of the Sylvester matrix gives.
template <class T>
bool coprime(const Polynomial<T>& f, const Polynomial<T>& g) {
  const std::size_t m = static_cast<std::size_t>(f.degree());
  const std::size_t n = static_cast<std::size_t>(g.degree());
  std::vector<std::vector<T>> rows(m + n, std::vector<T>(m + n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= m; ++j) rows[i][i + j] = f.coefficients()[m - j];
  }
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j <= n; ++j) rows[n + i][i + j] = g.coefficients()[n - j];
  }
  for (std::size_t c = 0; c < m + n; ++c) {
    std::size_t pivot = c;
    while (pivot < m + n && sign(rows[pivot][c]) == Sign::zero) ++pivot;
    if (pivot == m + n) return false;
    std::swap(rows[c], rows[pivot]);
    for (std::size_t r = c + 1; r < m + n; ++r) {
      const T factor = rows[r][c] / rows[c][c];
      for (std::size_t k = c; k < m + n; ++k) rows[r][k] -= factor * rows[c][k];
    }
  }
  return true;
}

TYPED_TEST(PolynomialLaws, GcdIsTheGreatestCommonDivisor) {
  using T = typename TypeParam::Number;
  int nontrivial = 0;
  for (int i = 0; i < 25; ++i) {
    const Polynomial<T> common = this->nonzero(2);
    const Polynomial<T> f = this->nonzero(2) * common;
    const Polynomial<T> g = this->nonzero(2) * common;
    const Polynomial<T> h = gcd(f, g);
    EXPECT_EQ(h.leading(), T(1));
    EXPECT_GE(h.degree(), common.degree());
    const Division<T> of_f = divide(f, h);
    const Division<T> of_g = divide(g, h);
    EXPECT_TRUE(of_f.remainder.is_zero());
    EXPECT_TRUE(of_g.remainder.is_zero());
    EXPECT_TRUE(coprime(of_f.quotient, of_g.quotient));
    EXPECT_EQ(gcd(g, f), h);
    if (h.degree() > 0) {
      ++nontrivial;
      EXPECT_FALSE(coprime(f, g));
    }
  }
  EXPECT_GT(nontrivial, 5);
  const Polynomial<T> zero;
  const Polynomial<T> f = this->nonzero(3);
  EXPECT_EQ(gcd(f, zero), monic(f));
  EXPECT_EQ(gcd(zero, f), monic(f));
  EXPECT_TRUE(gcd(zero, zero).is_zero());
}

TYPED_TEST(PolynomialLaws, SquareFreePartHasEachRootOnce) {
  using T = typename TypeParam::Number;
  const Polynomial<T> x{T(0), T(1)};
  for (int i = 0; i < 15; ++i) {
    const T a = this->source_.number();
    const T b = this->source_.number();
    if (a == b) continue;
    const Polynomial<T> u = x - Polynomial<T>{a};
    const Polynomial<T> v = x - Polynomial<T>{b};
    EXPECT_EQ(monic(square_free_part(u * u * u * v * v)), u * v);
    EXPECT_EQ(monic(square_free_part(u * v)), u * v);
    EXPECT_EQ(monic(square_free_part(u * u * (x * x + Polynomial<T>{T(1)}))),
              u * (x * x + Polynomial<T>{T(1)}));
  }
  EXPECT_THROW(square_free_part(Polynomial<T>()), std::invalid_argument);
}

TEST(Polynomial, LeadingZerosAreProvedAway) {
  RadicalField field;
  const Tower hidden_zero = field.sqrt(6) - field.sqrt(2) * field.sqrt(3);
  ASSERT_FALSE(hidden_zero.is_rational());
  const Polynomial<Tower> f{1, 2, hidden_zero};
  EXPECT_EQ(f.degree(), 1);
  EXPECT_EQ(Polynomial<Tower>{hidden_zero}.degree(), -1);
  // The gcd sees through it: (x - sqrt 6) and (x - sqrt 2 sqrt 3) are one factor.
  const Polynomial<Tower> x{0, 1};
  const Polynomial<Tower> u = x - Polynomial<Tower>{field.sqrt(6)};
  const Polynomial<Tower> v = x - Polynomial<Tower>{field.sqrt(2) * field.sqrt(3)};
  EXPECT_EQ(gcd(u * u, v * (x + Polynomial<Tower>{1})).degree(), 1);
}

TEST(Polynomial, RationalTowersTakeTheRationalPath) {
  RationalSource source(8);
  for (int i = 0; i < 50; ++i) {
    const Polynomial<Rational> f{source.number(), source.number(), source.number()};
    const Polynomial<Rational> g{source.number(), source.number()};
    EXPECT_EQ(gcd(over_tower(f * g), over_tower(g * g)), over_tower(gcd(f * g, g * g)));
    EXPECT_EQ(as_rational(over_tower(f)), f);
  }
  RadicalField field;
  EXPECT_FALSE(as_rational(Polynomial<Tower>{1, field.sqrt(2)}));
}

TEST(Polynomial, PrimitiveIntegersKeepTheSign) {
  const Polynomial<Rational> f{Rational(-3, 4), Rational(9, 2), Rational(-3)};
  EXPECT_EQ(primitive_integers(f), (std::vector<Integer>{-1, 6, -4}));
  EXPECT_TRUE(primitive_integers(Polynomial<Rational>()).empty());
}

}  // namespace
}  // namespace voroproof::internal
