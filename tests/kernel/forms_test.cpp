// Forms against evaluation in fractions, and instants that are equal or nearly so.
#include "certify/kernel/edge.h"

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

TEST(KernelForms, HalvesHaveTheSignsOfTheWhole) {
  std::mt19937 rng(1);
  for (int n = 0; n < 200; ++n) {
    const Form p = random_form(rng, 1 + n % 8);
    const Rat a(static_cast<int>(rng() % 100), 7), b = a + Rat(static_cast<int>(1 + rng() % 50), 3);
    const Rat m = (a + b) / 2;
    const auto [left, right] = halves(p);
    for (int k = 1; k < 8; ++k) {
      const Rat t = a + (m - a) * Rat(k, 8), u = m + (b - m) * Rat(k, 8);
      EXPECT_EQ(sign_at(left, a, m, t), sign_at(p, a, b, t));
      EXPECT_EQ(sign_at(right, m, b, u), sign_at(p, a, b, u));
    }
    EXPECT_LE(variations(left) + variations(right), variations(p));
  }
}

TEST(KernelForms, VariationsBoundRootsAndHaveTheirParity) {
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

TEST(KernelForms, SquarefreeKeepsEachRootOnce) {
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

// Three points at rest on the circle of radius rho about the origin; the fourth leaves the origin
// with velocity v and so meets the circle at rho / |v| only.
struct Leaving {
  std::vector<Leg> legs;
  Leaving(const Rat& rho, const Vec& v) {
    for (const Vec& at : {Vec{rho, 0}, Vec{-rho, 0}, Vec{0, rho}})
      legs.emplace_back(0, at, Vec{0, 0}, 0);
    legs.emplace_back(0, Vec{0, 0}, v, 0);
  }
  Instant instant(const Rat& lo, const Rat& hi) const {
    return {lo, hi, {{0, 1, 2, 3}, {&legs[0], &legs[1], &legs[2], &legs[3]}}};
  }
};

// sqrt(2) by two quadruplets is one instant; a neighbour 10^-60 away is another.
TEST(KernelForms, EqualInstantsAreSeenAsEqual) {
  const Rat half(1, 2), near = 1 + power(10, -60);
  const Leaving one(1, {half, half}), other(1, {half, -half}), later(near, {half, half});
  Instant x = one.instant(0, 2), y = other.instant(1, 3), z = later.instant(0, 2), w = x;
  EXPECT_EQ(compare(x, y), 0);
  EXPECT_EQ(compare(w, z), -1);
  EXPECT_EQ(compare(z, w), 1);
  EXPECT_EQ(compare(w, Rat(3, 2)), -1);
  EXPECT_EQ(compare(w, Rat(7, 5)), 1);
}

TEST(KernelForms, RationalRootsBecomePoints) {
  const Leaving late(1, {Rat(9, 20), Rat(12, 20)}), one(1, {Rat(3, 5), Rat(4, 5)});
  Instant x = late.instant(0, 4);
  EXPECT_EQ(compare(x, Rat(4, 3)), 0);
  EXPECT_TRUE(x.is_point());
  Instant y = one.instant(0, 4);
  y.split(2);
  y.split(1);
  EXPECT_TRUE(y.is_point());
  EXPECT_EQ(y.lo, 1);
}

}  // namespace
}  // namespace voroproof_kernel
