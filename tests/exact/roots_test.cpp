// Roots isolated by Descartes' rule against Sturm's count; signs around them and their refinement.
#include "exact/roots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

#include "exact/algebraic.h"
#include "tests/exact/fraction.h"
#include "tests/exact/powers.h"
#include "tests/exact/random_polynomials.h"
#include "tests/exact/sturm_sequence.h"

namespace voroproof::internal::testing {
namespace {

// What RootInterval promises, checked with Sturm's count.
template <class T>
void expect_isolating(const Polynomial<T>& f, const std::vector<RootInterval>& roots,
                      const Rational& lo, const Rational& hi) {
  const SturmSequence<T> sturm(f);
  for (const RootInterval& root : roots) {
    EXPECT_LE(lo, root.lo);
    EXPECT_LE(root.hi, hi);
    if (root.is_point()) {
      EXPECT_EQ(sign_at(f, root.lo), Sign::zero);
    } else {
      EXPECT_LT(root.lo, root.hi);
      EXPECT_NE(sign_at(f, root.lo), Sign::zero);
      EXPECT_NE(sign_at(f, root.hi), Sign::zero);
      EXPECT_EQ(sturm.count(root.lo, root.hi), 1);
    }
  }
  for (std::size_t i = 1; i < roots.size(); ++i) EXPECT_LE(roots[i - 1].hi, roots[i].lo);
  const int at_lo = sign_at(f, lo) == Sign::zero ? 1 : 0;
  EXPECT_EQ(static_cast<int>(roots.size()), sturm.count(lo, hi) + at_lo);
}

// ---- Isolation -------------------------------------------------------------------

TEST(IsolateRoots, DescartesAndSturmAgreeOnRandomPolynomials) {
  RandomNumbers random(11);
  int found = 0;
  for (int i = 0; i < 400; ++i) {
    RationalPolynomial f = random.polynomial(1 + static_cast<int>(random.below(8)));
    if (i % 4 == 0) f = f * f;
    if (i % 3 == 0) f = f * random.polynomial(2) * linear(random.number());
    Rational lo = random.number();
    Rational hi = random.number();
    if (lo > hi) std::swap(lo, hi);
    const auto roots = isolate_roots(f, lo, hi);
    expect_isolating(f, roots, lo, hi);
    const auto by_sturm = SturmSequence<Rational>(f).isolate(lo, hi);
    expect_isolating(f, by_sturm, lo, hi);
    EXPECT_EQ(roots.size(), by_sturm.size());
    found += static_cast<int>(roots.size());
  }
  EXPECT_GT(found, 300);
}

TEST(IsolateRoots, FindsPlantedRootsOfAnyMultiplicity) {
  RandomNumbers random(12);
  for (int i = 0; i < 150; ++i) {
    std::vector<Rational> planted;
    RationalPolynomial f{Rational(-3)};
    for (long k = random.below(5); k >= 0; --k) {
      const Rational root = random.number();
      if (std::find(planted.begin(), planted.end(), root) != planted.end()) continue;
      planted.push_back(root);
      for (long m = random.below(4); m >= 0; --m) f = f * linear(root);
    }
    // A factor without real roots: (x - a)^2 + tiny.
    const Rational a = random.number();
    f = f * (linear(a) * linear(a) + RationalPolynomial{power_of_two(-random.below(60))});
    std::sort(planted.begin(), planted.end());
    const auto roots = isolate_roots(f, -20, 20);
    ASSERT_EQ(roots.size(), planted.size());
    for (std::size_t k = 0; k < roots.size(); ++k) {
      EXPECT_LE(roots[k].lo, planted[k]);
      EXPECT_GE(roots[k].hi, planted[k]);
    }
    expect_isolating(f, roots, -20, 20);
  }
}

TEST(IsolateRoots, ClosedEndsAndBisectionPoints) {
  // Roots at both ends, at the first midpoint, and close beside each of them.
  RationalPolynomial f = linear<Rational>(0) * linear<Rational>(1) * linear(fraction(1, 2));
  for (const Rational& r : {power_of_two(-40), Rational(1 - power_of_two(-40)),
                            Rational(fraction(1, 2) + power_of_two(-50))}) {
    f = f * linear(r);
  }
  f = f * linear(fraction(-1, 1000)) * linear(fraction(1001, 1000));  // just outside
  const auto roots = isolate_roots(f, 0, 1);
  ASSERT_EQ(roots.size(), 6u);
  expect_isolating(f, roots, 0, 1);
  EXPECT_TRUE(roots.front().is_point());
  EXPECT_TRUE(roots.back().is_point());

  EXPECT_EQ(isolate_roots(f, 0, 0).size(), 1u);
  EXPECT_EQ(isolate_roots(f, 2, 2).size(), 0u);
  EXPECT_EQ(isolate_roots(f, 2, 3).size(), 0u);
  EXPECT_EQ(isolate_roots(RationalPolynomial{5}, -1, 1).size(), 0u);
  EXPECT_THROW(isolate_roots(RationalPolynomial(), 0, 1), std::invalid_argument);
  EXPECT_THROW(isolate_roots(f, 1, 0), std::invalid_argument);
}

// M. Mignotte's polynomials x^n - 2 (a x - 1)^2 have two roots about a^-(n/2+1) apart.
TEST(IsolateRoots, SeparatesMignottesPairs) {
  for (const int n : {3, 5, 8, 14}) {
    std::vector<Rational> power(static_cast<std::size_t>(n) + 1);
    power.back() = 1;
    const RationalPolynomial line{-1, 1000};
    const RationalPolynomial f = RationalPolynomial(power) - line * line * Rational(2);
    const auto roots = isolate_roots(f, 0, 1);
    EXPECT_EQ(roots.size(), 2u) << n;
    expect_isolating(f, roots, 0, 1);
  }
}

TEST(IsolateRoots, ChebyshevPolynomialsHaveAllTheirRoots) {
  RationalPolynomial previous{1};
  RationalPolynomial current{0, 1};
  for (int n = 1; n < 24; ++n) {
    const auto roots = isolate_roots(current, -1, 1);
    ASSERT_EQ(roots.size(), static_cast<std::size_t>(n));
    for (std::size_t k = 0; k < roots.size(); ++k) {
      const double expected =
          -std::cos((2 * static_cast<double>(k) + 1) * std::acos(-1.0) / (2 * n));
      const double got = round_nearest(AlgebraicNumber<Rational>(current, roots[k]));
      EXPECT_NEAR(got, expected, 1e-15);
    }
    const RationalPolynomial next = RationalPolynomial{0, 2} * current - previous;
    previous = current;
    current = next;
  }
}

TEST(IsolateRoots, OverATower) {
  RadicalField field;
  const Tower s = field.sqrt(2);
  const Tower t = field.sqrt(Tower(3) + s);
  RandomNumbers random(13);
  for (int i = 0; i < 20; ++i) {
    std::vector<Tower> planted;
    TowerPolynomial f{s - 5};
    for (int k = 0; k < 3; ++k) {
      planted.push_back(Tower(random.number()) + random.number() * s + random.number() * t);
      f = f * linear(planted.back());
      if (k == i % 3) f = f * linear(planted.back());
    }
    std::sort(planted.begin(), planted.end());
    planted.erase(std::unique(planted.begin(), planted.end()), planted.end());
    const auto roots = isolate_roots(f, -100, 100);
    ASSERT_EQ(roots.size(), planted.size());
    expect_isolating(f, roots, -100, 100);
    for (std::size_t k = 0; k < roots.size(); ++k) {
      EXPECT_LE(Tower(roots[k].lo), planted[k]);
      EXPECT_GE(Tower(roots[k].hi), planted[k]);
    }
  }
}

TEST(IsolateRoots, OverATowerDescartesAndSturmAgree) {
  RadicalField field;
  const Tower s = field.sqrt(5);
  const Tower t = field.sqrt(Tower(7) - s);
  RandomNumbers random(19);
  int found = 0;
  for (int i = 0; i < 40; ++i) {
    TowerPolynomial f = over_tower(random.polynomial(3)) * s -
                        over_tower(random.polynomial(3)) * t + over_tower(random.polynomial(2));
    // Roots that bisection meets, and ones at the ends.
    if (i % 2) f = f * linear(Tower(fraction(random.below(33) - 16, 2)));
    if (i % 3) f = f * linear<Tower>(8);
    const auto roots = isolate_roots(f, -8, 8);
    expect_isolating(f, roots, -8, 8);
    const auto by_sturm = SturmSequence<Tower>(f).isolate(-8, 8);
    expect_isolating(f, by_sturm, -8, 8);
    EXPECT_EQ(roots.size(), by_sturm.size());
    found += static_cast<int>(roots.size());
  }
  EXPECT_GT(found, 40);
}

// Pairs that need more than the first precision, more than every precision tried before
// the square-free part, and double roots, which no precision separates.
TEST(IsolateRoots, OverATowerCloseAndDoubleRoots) {
  RadicalField field;
  const Tower s = field.sqrt(2);
  for (const long bits : {10, 100, 1500}) {
    const TowerPolynomial f = linear(s) * linear(s + power_of_two(-bits)) * linear<Tower>(1);
    const auto roots = isolate_roots(f, 0, 4);
    ASSERT_EQ(roots.size(), 3u) << bits;
    expect_isolating(f, roots, 0, 4);
  }
  const TowerPolynomial doubled = linear(s) * linear(s) * linear(s - 1);
  const auto roots = isolate_roots(doubled, 0, 4);
  ASSERT_EQ(roots.size(), 2u);
  expect_isolating(doubled, roots, 0, 4);
  EXPECT_EQ(signs_around(doubled, roots[0]), (SignsAround{Sign::negative, Sign::positive}));
  EXPECT_EQ(signs_around(doubled, roots[1]), (SignsAround{Sign::positive, Sign::positive}));
  const auto numbers = real_roots(doubled, 0, 4);
  ASSERT_EQ(numbers.size(), 2u);
  EXPECT_EQ(numbers[1], only_root(over_tower({-2, 0, 1}), 0, 4));
  // The double root of a higher power lies where bisection looks.
  EXPECT_EQ(isolate_roots(linear<Tower>(2) * linear<Tower>(2) * linear(s), 0, 4).size(), 2u);
}

TEST(IsPlainlyRootless, IsNeverWrongAndOftenTrue) {
  RandomNumbers random(20);
  RadicalField field;
  const Tower s = field.sqrt(2);
  int proved = 0;
  for (int i = 0; i < 300; ++i) {
    const TowerPolynomial f =
        over_tower(random.polynomial(4)) + over_tower(random.polynomial(3)) * s;
    const Rational lo = random.number();
    const Rational hi = lo + fraction(1 + random.below(20), 10);
    if (!is_plainly_rootless(f, lo, hi)) continue;
    ++proved;
    EXPECT_TRUE(isolate_roots(f, lo, hi).empty());
    EXPECT_EQ(SturmSequence<Tower>(f).count(lo, hi), 0);
    EXPECT_NE(sign_at(f, lo), Sign::zero);
  }
  EXPECT_GT(proved, 100);
  EXPECT_FALSE(is_plainly_rootless(linear<Rational>(1), 1, 2));
  EXPECT_FALSE(is_plainly_rootless(linear<Rational>(1), 0, 1));
  EXPECT_FALSE(is_plainly_rootless(RationalPolynomial(), 0, 1));
}

// The roots of the product with the conjugate polynomial, rational by construction,
// are those of f and of its conjugate: Descartes there, Sturm here.
TEST(IsolateRoots, TowerRootsAreRootsOfTheNorm) {
  RadicalField field;
  const Tower s = field.sqrt(7);
  RandomNumbers random(14);
  for (int i = 0; i < 40; ++i) {
    const RationalPolynomial u = random.polynomial(4);
    const RationalPolynomial v = random.polynomial(3);
    const TowerPolynomial f = over_tower(u) + over_tower(v) * s;
    const TowerPolynomial conjugate = over_tower(u) - over_tower(v) * s;
    const RationalPolynomial norm = u * u - v * v * Rational(7);
    const auto of_norm = real_roots(over_tower(norm), -1000, 1000);
    auto both = real_roots(f, -1000, 1000);
    const auto of_conjugate = real_roots(conjugate, -1000, 1000);
    both.insert(both.end(), of_conjugate.begin(), of_conjugate.end());
    std::sort(both.begin(), both.end());
    ASSERT_EQ(both.size(), of_norm.size());
    for (std::size_t k = 0; k < both.size(); ++k) EXPECT_EQ(both[k], of_norm[k]);
  }
}

// ---- Signs and refinement ----------------------------------------------------------

TEST(SignAt, AgreesWithEvaluation) {
  RandomNumbers random(15);
  RadicalField field;
  const Tower s = field.sqrt(3);
  for (int i = 0; i < 200; ++i) {
    const RationalPolynomial f = random.polynomial(5) * linear(random.number());
    const Rational x = random.number();
    EXPECT_EQ(sign_at(f, x), sign(f.evaluate(x)));
    EXPECT_EQ(sign_at(over_tower(f), x), sign(f.evaluate(x)));
    const TowerPolynomial g = over_tower(f) * s + over_tower(random.polynomial(2));
    EXPECT_EQ(sign_at(g, x), sign(g.evaluate(x)));
  }
  EXPECT_EQ(sign_at(RationalPolynomial(), Rational(3)), Sign::zero);
}

TEST(Refine, KeepsTheRootAndReachesTheWidth) {
  const RationalPolynomial f{-2, 0, 1};
  for (const RationalPolynomial& g : {f, RationalPolynomial(-f), RationalPolynomial(f * f)}) {
    auto roots = isolate_roots(g, -5, 5);
    ASSERT_EQ(roots.size(), 2u);
    RootInterval& root = roots[1];
    refine(g, root, power_of_two(-500));
    EXPECT_LE(root.hi - root.lo, power_of_two(-500));
    EXPECT_LT(root.lo * root.lo, 2);
    EXPECT_GT(root.hi * root.hi, 2);
    EXPECT_THROW(refine(g, root, 0), std::invalid_argument);
  }
  RootInterval met{0, 2};  // the root 1 is the first midpoint
  refine(linear<Rational>(1), met, fraction(1, 2));
  EXPECT_TRUE(met.is_point());
  EXPECT_EQ(met.lo, 1);
}

// Bisection alone gives the same interval, also where it meets the root on its way.
template <class T>
void expect_bisected(const Polynomial<T>& f, RandomNumbers& random) {
  const SignEvaluator<T> sign_at(f);
  for (const RootInterval& isolating : isolate_roots(f, -10, 10)) {
    if (isolating.is_point()) continue;
    const Sign at_lo = sign_at(isolating.lo);
    if (sign_at(isolating.hi) == at_lo) continue;  // a root of even multiplicity
    RootInterval bisected = isolating, refined = isolating;
    for (const int bits : {1, 5, 40, 41, 700}) {
      const Rational width = abs(random.number() + 1) * power_of_two(-bits) + power_of_two(-800);
      while (bisected.hi - bisected.lo > width) halve(sign_at, at_lo, bisected);
      refine(sign_at, at_lo, refined, width);
      EXPECT_EQ(refined.lo, bisected.lo);
      EXPECT_EQ(refined.hi, bisected.hi);
    }
  }
}

TEST(Refine, GivesTheIntervalOfBisection) {
  RandomNumbers random(16);
  RadicalField field;
  const Tower s = field.sqrt(3);
  for (int i = 0; i < 30; ++i) {
    const RationalPolynomial f = random.polynomial(5) * linear(random.number());
    expect_bisected(f, random);
    expect_bisected(over_tower(f) * s + over_tower(random.polynomial(2)), random);
  }
  expect_bisected(linear(fraction(5, 1 << 12)), random);
  expect_bisected(linear<Rational>(0), random);
  // Two roots 2^-200 apart, and one of the third order.
  expect_bisected(linear<Rational>(1) * linear(Rational(1 + power_of_two(-200))), random);
  const RationalPolynomial third = linear(fraction(1, 3));
  expect_bisected(third * third * third, random);
}

TEST(SignsAround, ParityOfTheMultiplicity) {
  const RationalPolynomial quadratic{-2, 0, 1};
  for (int multiplicity = 1; multiplicity <= 5; ++multiplicity) {
    for (const Rational& at : {Rational(0), fraction(1, 3)}) {
      RationalPolynomial f{1};
      RationalPolynomial g{-1};
      for (int m = 0; m < multiplicity; ++m) {
        f = f * linear(at);
        g = g * quadratic;
      }
      const Sign before = multiplicity % 2 ? Sign::negative : Sign::positive;
      EXPECT_EQ(signs_around(f, RootInterval{at, at}), (SignsAround{before, Sign::positive}));
      EXPECT_EQ(signs_around(f, isolate_roots(f, -3, 4).at(0)),
                (SignsAround{before, Sign::positive}));
      EXPECT_EQ(signs_around(g, isolate_roots(g, 0, 5).at(0)),
                (SignsAround{-before, Sign::negative}));
      EXPECT_EQ(signs_around(over_tower(f), RootInterval{at, at}),
                (SignsAround{before, Sign::positive}));
    }
  }
  EXPECT_THROW(signs_around(RationalPolynomial(), RootInterval{0, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace voroproof::internal::testing
