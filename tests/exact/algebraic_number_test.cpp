// Algebraic numbers: compared, rounded, and put into other polynomials.
#include "exact/algebraic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "exact/roots.h"
#include "tests/exact/fraction.h"
#include "tests/exact/powers.h"
#include "tests/exact/random_polynomials.h"

namespace voroproof::internal::testing {
namespace {

TEST(AlgebraicNumber, EqualAndUnequalRootsOfDifferentPolynomials) {
  const RationalPolynomial two{-2, 0, 1};
  RandomNumbers random(16);
  const auto root2 = only_root(two, 0, 2);
  for (int i = 0; i < 40; ++i) {
    const RationalPolynomial f = two * random.polynomial(3);
    const auto roots = real_roots(f, -50, 50);
    int equal = 0;
    for (const auto& root : roots) {
      equal += root == root2;
      EXPECT_EQ(root<root2, root2> root);
      EXPECT_EQ(compare(root, root2) < 0, round_nearest(root) < round_nearest(root2));
    }
    EXPECT_EQ(equal, 1);
  }
  // Nearer than any number of bits tried before equality is asked for.
  const RationalPolynomial shifted = two + RationalPolynomial{power_of_two(-700)};
  EXPECT_LT(only_root(shifted, 0, 2), root2);
  EXPECT_GT(root2, only_root(shifted, 0, 2));
  EXPECT_EQ(root2, root2);
  EXPECT_EQ(root2, AlgebraicNumber<Rational>(two * two, RootInterval{1, 2}));
}

TEST(AlgebraicNumber, ComparesWithRationals) {
  const auto root2 = only_root(RationalPolynomial{-2, 0, 1}, 0, 2);
  EXPECT_TRUE(compare(root2, fraction(7, 5)) > 0);
  EXPECT_TRUE(compare(root2, fraction(17, 12)) < 0);
  EXPECT_TRUE(compare(root2, Rational(-100)) > 0);
  EXPECT_TRUE(compare(root2, Rational(100)) < 0);
  EXPECT_GT(root2, AlgebraicNumber<Rational>(1));
  EXPECT_LT(AlgebraicNumber<Rational>(1), root2);
  EXPECT_EQ(AlgebraicNumber<Rational>(3).polynomial(), linear<Rational>(3));
  // A rational root inside an interval, found out by comparison alone.
  const AlgebraicNumber<Rational> third(linear(fraction(1, 3)), RootInterval{0, 1});
  EXPECT_FALSE(third.is_point());
  EXPECT_TRUE(compare(third, fraction(1, 3)) == 0);
  EXPECT_EQ(third, AlgebraicNumber<Rational>(fraction(1, 3)));
  EXPECT_LT(third, AlgebraicNumber<Rational>(fraction(1, 2)));
}

TEST(AlgebraicNumber, MixedCoefficientFields) {
  RadicalField field;
  const Tower root2 = field.sqrt(2);
  const Tower root3 = field.sqrt(3);
  // sqrt 2 + sqrt 3 as a root over the tower and over the rationals.
  const TowerPolynomial over_field = linear(root2 + root3);
  const TowerPolynomial over_rationals{1, 0, -10, 0, 1};
  const auto x = only_root(over_field, 0, 10);
  const auto y = only_root(over_rationals, 1, 10);
  EXPECT_EQ(x, y);
  EXPECT_EQ(round_nearest(x), round_nearest(y));
  const auto z = only_root(over_rationals + TowerPolynomial{power_of_two(-400)}, 1, 10);
  EXPECT_NE(x, z);
  EXPECT_GT(x, z);
  // Rational towers and rationals give the same answers.
  const auto same = only_root(RationalPolynomial{1, 0, -10, 0, 1}, 1, 10);
  EXPECT_EQ(round_nearest(y), round_nearest(same));
}

TEST(AlgebraicNumber, RefineNarrowsTheValue) {
  auto root2 = only_root(RationalPolynomial{-2, 0, 1}, 0, 2);
  const auto before = root2;
  root2.refine(power_of_two(-100));
  EXPECT_LE(root2.interval().hi - root2.interval().lo, power_of_two(-100));
  EXPECT_EQ(root2, before);
  EXPECT_THROW(root2.refine(0), std::invalid_argument);
}

TEST(AlgebraicNumber, RoundsSquareRootsAsTheProcessorDoes) {
  std::mt19937_64 random(17);
  for (int i = 0; i < 300; ++i) {
    const double square = std::ldexp(1 + static_cast<double>(random() >> 12) * 0x1p-52,
                                     static_cast<int>(random() % 200) - 100);
    const RationalPolynomial f{-to_rational(square), 0, 1};
    const auto roots = real_roots(f, -power_of_two(60), power_of_two(60));
    ASSERT_EQ(roots.size(), 2u);
    EXPECT_EQ(round_nearest(roots[1]), std::sqrt(square));
    EXPECT_EQ(round_nearest(roots[0]), -std::sqrt(square));
  }
}

TEST(AlgebraicNumber, RoundsExactValuesAndTies) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  // Hidden in an interval that bisection never makes a point of.
  auto hidden = [](const Rational& q) {
    const Rational lo = q - abs(q) / 3 - fraction(1, 7);
    const Rational hi = q + abs(q) / 5 + fraction(1, 11);
    return AlgebraicNumber<Rational>(linear(q) * RationalPolynomial{1, 0, 1}, RootInterval{lo, hi});
  };
  std::mt19937_64 random(18);
  for (int i = 0; i < 100; ++i) {
    const double a = std::ldexp(static_cast<double>(random() >> 11) - 0x1p52,
                                static_cast<int>(random() % 80) - 90);
    const double b = std::nextafter(a, infinity);
    const Rational middle = (to_rational(a) + to_rational(b)) / 2;
    const Rational tick = (to_rational(b) - to_rational(a)) * power_of_two(-300);
    EXPECT_EQ(round_nearest(hidden(to_rational(a))), a);
    EXPECT_EQ(round_nearest(hidden(middle)), round_nearest(middle));
    EXPECT_EQ(round_nearest(hidden(middle - tick)), a);
    EXPECT_EQ(round_nearest(hidden(middle + tick)), b);
  }
  EXPECT_EQ(round_nearest(hidden(0)), 0);
  EXPECT_FALSE(std::signbit(round_nearest(hidden(0))));
  const Rational limit = power_of_two(1024) - power_of_two(970);
  EXPECT_EQ(round_nearest(hidden(limit)), infinity);
  EXPECT_EQ(round_nearest(hidden(-limit)), -infinity);
  EXPECT_EQ(round_nearest(hidden(limit - 1)), std::numeric_limits<double>::max());
  EXPECT_EQ(round_nearest(hidden(1 - limit)), -std::numeric_limits<double>::max());
}

TEST(AlgebraicNumber, SignsOfOtherPolynomials) {
  const RationalPolynomial two{-2, 0, 1};
  const RationalPolynomial near = two + RationalPolynomial{power_of_two(-300)};
  const auto root2 = only_root(two, 0, 3);
  EXPECT_EQ(sign_at(two * linear<Rational>(5), root2), Sign::zero);
  EXPECT_EQ(sign_at(near, root2), Sign::positive);
  EXPECT_EQ(sign_at(near * linear<Rational>(5), root2), Sign::negative);
  EXPECT_EQ(sign_at(RationalPolynomial(), root2), Sign::zero);
  EXPECT_EQ(signs_around(near * two, root2), (SignsAround{Sign::negative, Sign::positive}));
  EXPECT_EQ(signs_around(near * two * two, root2), (SignsAround{Sign::positive, Sign::positive}));
  EXPECT_EQ(signs_around(near, root2), (SignsAround{Sign::positive, Sign::positive}));
  EXPECT_TRUE(root2.is_root_of(two));
  EXPECT_FALSE(root2.is_root_of(near));
  EXPECT_EQ(sign_at(two, root2), Sign::zero);
  EXPECT_EQ(signs_around(two, root2), (SignsAround{Sign::negative, Sign::positive}));
  const auto minus = only_root(two, -3, 0);
  EXPECT_EQ(signs_around(two, minus), (SignsAround{Sign::positive, Sign::negative}));
  EXPECT_EQ(signs_around(linear<Rational>(1), AlgebraicNumber<Rational>(1)),
            (SignsAround{Sign::negative, Sign::positive}));
  EXPECT_THROW(signs_around(RationalPolynomial(), root2), std::invalid_argument);

  RadicalField field;
  const Tower s = field.sqrt(2);
  const auto x = only_root(over_tower(two), 0, 3);
  EXPECT_EQ(sign_at(TowerPolynomial{-s, 1}, x), Sign::zero);
  // One root at x, another one beyond the bits tried before zero is considered.
  const TowerPolynomial pair = linear(s) * linear(s + power_of_two(-400));
  EXPECT_EQ(sign_at(pair, x), Sign::zero);
  EXPECT_EQ(signs_around(pair, x), (SignsAround{Sign::positive, Sign::negative}));
  EXPECT_EQ(sign_at(TowerPolynomial{-s - power_of_two(-200), 1}, x), Sign::negative);
}

TEST(AlgebraicNumber, TimesBesideOneNumber) {
  const RationalPolynomial two{-2, 0, 1};
  const auto root2 = only_root(two, 0, 3);
  // Another root as near on either side, and the number itself among the roots.
  for (const int sign : {1, -1}) {
    const Rational shift = sign * power_of_two(-300);
    const RationalPolynomial near = two - RationalPolynomial{shift};
    const auto other = only_root(near, 0, 3);
    const Rational middle = rational_between(root2, other);
    EXPECT_EQ(middle, rational_between(other, root2));
    EXPECT_EQ(compare(root2, middle) < 0, sign > 0);
    EXPECT_EQ(compare(other, middle) > 0, sign > 0);
    const RootInterval part = clear_of(near * two, root2, RootInterval{0, 3});
    EXPECT_TRUE(compare(root2, part.lo) > 0 && compare(root2, part.hi) < 0);
    EXPECT_EQ(real_roots(near * two, part.lo, part.hi).size(), 1u);
    EXPECT_EQ(sign > 0 ? part.lo : part.hi, sign > 0 ? Rational(0) : Rational(3));
  }
  const RootInterval all = clear_of(RationalPolynomial(), root2, RootInterval{1, 2});
  EXPECT_EQ(all.lo, 1);
  EXPECT_EQ(all.hi, 2);
  EXPECT_EQ(clear_of(two, root2, RootInterval{0, 3}).hi, 3);
}

}  // namespace
}  // namespace voroproof::internal::testing
