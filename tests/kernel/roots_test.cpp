// Forms against evaluation in fractions, and instants that are equal or nearly so.
#include "kernel/roots.h"

#include <gtest/gtest.h>

#include <random>

namespace voroproof_kernel {
namespace {

// The factor c - t as a form over [a, b].
Form factor(const Rat& c, const Rat& a, const Rat& b) {
  const Int scale = lcm(Int(denominator(Rat(c - a))), Int(denominator(Rat(c - b))));
  return {Int(numerator(Rat((c - a) * scale))), Int(numerator(Rat((c - b) * scale)))};
}

Rat value(const Form& p, const Rat& z) {
  Rat sum = 0, power = 1;
  for (const Int& c : p) {
    sum += c * power;
    power *= z;
  }
  return sum;
}

int sign_at(const Form& p, const Rat& a, const Rat& b, const Rat& t) {
  return sgn(value(p, Rat((t - a) / (b - t))));
}

Form random_form(std::mt19937& rng, int degree) {
  Form p(degree + 1);
  for (Int& c : p) c = static_cast<int>(rng() % 2001) - 1000;
  return p;
}

TEST(KernelRoots, HalvesHaveTheSignsOfTheWhole) {
  std::mt19937 rng(1);
  for (int n = 0; n < 200; ++n) {
    const Form p = random_form(rng, 1 + n % 8);
    const Rat a(static_cast<int>(rng() % 100), 7), b = a + Rat(static_cast<int>(1 + rng() % 50), 3);
    const Rat m = (a + b) / 2;
    Form left, right;
    halve(p, left, right);
    for (int k = 1; k < 8; ++k) {
      const Rat t = a + (m - a) * Rat(k, 8), u = m + (b - m) * Rat(k, 8);
      EXPECT_EQ(sign_at(left, a, m, t), sign_at(p, a, b, t));
      EXPECT_EQ(sign_at(right, m, b, u), sign_at(p, a, b, u));
    }
    EXPECT_LE(variations(left) + variations(right), variations(p));
  }
}

TEST(KernelRoots, RestrictionHasTheSignsOfTheWhole) {
  std::mt19937 rng(2);
  for (int n = 0; n < 200; ++n) {
    const Form p = random_form(rng, 1 + n % 8);
    const Rat a(-3, 2), b(11, 5), lo = a + Rat(static_cast<int>(rng() % 50), 31);
    const Rat hi = lo + Rat(static_cast<int>(1 + rng() % 60), 30);
    if (hi > b) continue;
    const Form part = restricted(p, a, b, lo, hi);
    for (int k = 1; k < 8; ++k) {
      const Rat t = lo + (hi - lo) * Rat(k, 8);
      if (t < b) {
        EXPECT_EQ(sign_at(part, lo, hi, t), sign_at(p, a, b, t));
      }
    }
  }
}

TEST(KernelRoots, VariationsBoundRootsAndHaveTheirParity) {
  std::mt19937 rng(3);
  const Rat a = 0, b = 10;
  for (int n = 0; n < 200; ++n) {
    Form p{1};
    int inside = 0;
    for (int k = 0; k < 5; ++k) {
      const Rat c(static_cast<int>(rng() % 401) - 100, 10 + static_cast<int>(rng() % 3));
      p = p * factor(c, a, b);
      inside += c > a && c < b;
    }
    EXPECT_GE(variations(p), inside);
    EXPECT_EQ(variations(p) % 2, inside % 2);
  }
}

TEST(KernelRoots, SquarefreeKeepsEachRootOnce) {
  const Rat a = 0, b = 5;
  const Form f = factor(2, a, b), g = factor(3, a, b), h = factor(7, a, b);
  const Form p = squarefree(f * f * f * g * g * h);
  EXPECT_EQ(p.size(), 4U);
  EXPECT_EQ(sign_at(p, a, b, 2), 0);
  EXPECT_EQ(sign_at(p, a, b, 3), 0);
  EXPECT_NE(sign_at(p, a, b, Rat(5, 2)), 0);
  EXPECT_EQ(variations(common(f * h, f * g)) % 2, 1);
  EXPECT_EQ(variations(common(f * h, g)), 0);
}

// sqrt(2) by two polynomials is one instant; a neighbour 10^-60 away is another.
TEST(KernelRoots, EqualInstantsAreSeenAsEqual) {
  const Rat a = 1, b = 2;
  // t^2 - 2 over [1, 2]: values times (1 + z)^2.
  const auto square_minus = [&](const Rat& c) {
    const Int d = denominator(c), n = numerator(c);
    return Form{Int(d - n), Int(4 * d - 2 * n), Int(4 * d - n)};
  };
  const Form root2 = square_minus(2);
  Instant x{a, b, root2, a, b};
  Instant y{a, b, root2 * factor(5, a, b), a, b};
  EXPECT_EQ(compare(x, y), 0);
  Rat tiny = 1;
  for (int k = 0; k < 60; ++k) tiny /= 10;
  Instant z{a, b, square_minus(2 + tiny), a, b};
  Instant w{a, b, root2, a, b};
  EXPECT_EQ(compare(w, z), -1);
  EXPECT_EQ(compare(z, w), 1);
  EXPECT_EQ(compare(w, Rat(3, 2)), -1);
  EXPECT_EQ(compare(w, Rat(7, 5)), 1);
}

TEST(KernelRoots, RationalRootsBecomePoints) {
  const Rat a = 0, b = 4;
  Instant x{a, b, factor(Rat(4, 3), a, b), a, b};
  EXPECT_EQ(compare(x, Rat(4, 3)), 0);
  EXPECT_TRUE(x.is_point());
  Instant y{a, b, factor(1, a, b), a, b};
  y.refine();
  y.refine();
  EXPECT_TRUE(y.is_point());
  EXPECT_EQ(y.lo, 1);
}

}  // namespace
}  // namespace voroproof_kernel
