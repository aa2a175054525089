// Forms, bounds and jets through the formulas of the flip polynomial, against the same formulas
// over the rationals: the bounds hold where inputs err by as much as they may.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "exact/polynomial.h"
#include "exact/predicates.h"
#include "filtered/numbers/bound.h"
#include "filtered/numbers/form.h"
#include "filtered/numbers/jet.h"

namespace voroproof::internal::testing {
namespace {

using Random = std::mt19937_64;

double between(Random& random, double a, double b) {
  return a + (b - a) * static_cast<double>(random() >> 11) * 0x1p-53;
}
Rational power(const Rational& x, int n) {
  Rational y = 1;
  for (int k = 0; k < n; ++k) y *= x;
  return y;
}

// The value of the form at the part x of the window.
template <int degree>
Rational evaluate(const Form<Rational, degree>& f, const Rational& x) {
  Rational sum = 0;
  for (int k = 0; k <= degree; ++k) sum += f.c[k] * power(x, k) * power(1 - x, degree - k);
  return sum;
}

template <int degree>
Form<Rational, degree> random_form(Random& random) {
  Form<Rational, degree> f;
  for (Rational& c : f.c) c = Rational(static_cast<long>(random() % 2001) - 1000) / 7;
  return f;
}

TEST(Forms, MultiplyAsPolynomialsDo) {
  Random random(1);
  for (int k = 0; k < 50; ++k) {
    const auto p = random_form<2>(random), q = random_form<2>(random);
    const auto r = random_form<4>(random);
    const auto s = random_form<1>(random);
    const Form<Rational, 0> c{{Rational(k - 25) / 3}};
    for (const Rational& x : {Rational(0), Rational(1, 3), Rational(1), Rational(7, 2)}) {
      const Rational at_p = evaluate(p, x), at_r = evaluate(r, x), at_s = evaluate(s, x);
      EXPECT_EQ(evaluate(p * r, x), at_p * at_r);
      EXPECT_EQ(evaluate(p * s, x), at_p * at_s);
      EXPECT_EQ(evaluate(p + q, x), at_p + evaluate(q, x));
      EXPECT_EQ(evaluate(p - c, x), at_p - c.c[0]);
      EXPECT_EQ(evaluate(squared(s), x), at_s * at_s);
      EXPECT_EQ(evaluate(squared(p), x), at_p * at_p);
      EXPECT_EQ(evaluate(squared(r), x), at_r * at_r);
      EXPECT_EQ(evaluate(squared(c), x), c.c[0] * c.c[0]);
    }
  }
}

// The cotangency of four generators from their six pairs, in whatever `of` makes of a pair.
template <class P, class Of>
auto cotangency_of_pairs(const P (&p)[6], const Of& of) {
  return cotangency_of(of(p[0]) * of(p[1]), of(p[2]) * of(p[3]), of(p[4]) * of(p[5]));
}

Bound<double> total(const Bound<double>& a, const Bound<double>& b, const Bound<double>& c) {
  return {a.size + b.size + c.size, a.err + b.err + c.err};
}

// The bound of their cotangency.
template <class P>
Bound<double> cotangency_bound_of_pairs(const P (&p)[6]) {
  return cotangency_bound(
      total(p[0].bound() * p[1].bound(), p[2].bound() * p[3].bound(), p[4].bound() * p[5].bound()));
}

// A pair of generators: offsets over a window as they are computed, and as they truly are.
struct Pair {
  Form<double, 1> x, y;
  Form<double, 0> r;
  double err;
  Form<Rational, 1> true_x, true_y;
  Form<Rational, 0> true_r;

  Form<double, 2> computed() const { return tangency_of(x, y, r); }
  Form<Rational, 2> truth() const { return tangency_of(true_x, true_y, true_r); }
  double far() const {
    return std::fmax(std::fabs(x.c[0]) + std::fabs(y.c[0]), std::fabs(x.c[1]) + std::fabs(y.c[1]));
  }
  Bound<double> bound() const { return tangency_bound(far(), std::fabs(r.c[0]), err); }
};

// Off by exactly what it may be, in one direction or the other.
Rational off(Random& random, double value, double err) {
  return to_rational(value) + (random() % 2 == 0 ? 1 : -1) * to_rational(err);
}

Pair random_pair(Random& random, double scale, double relative_error) {
  Pair p;
  const auto coordinate = [&] { return between(random, -scale, scale); };
  p.x = {{coordinate(), coordinate()}};
  p.y = {{coordinate(), coordinate()}};
  p.r = {{between(random, -0.5, 0.5) * scale}};
  p.err = relative_error * scale;
  for (int k = 0; k < 2; ++k) {
    p.true_x.c[k] = off(random, p.x.c[k], p.err);
    p.true_y.c[k] = off(random, p.y.c[k], p.err);
  }
  p.true_r.c[0] = off(random, p.r.c[0], p.err);
  return p;
}

// How much of the bound is used, at most; beyond 1 it does not hold.
template <int degree>
double used(const Form<double, degree>& computed, const Form<Rational, degree>& truth,
            double bound) {
  constexpr std::array<int, degree + 1> scale = binomials<degree>();
  double most = 0;
  for (int k = 0; k <= degree; ++k) {
    const Rational error = (to_rational(computed.c[k]) - truth.c[k]) / scale[k];
    most = std::fmax(most, std::fabs(error.get_d()) / bound);
  }
  return most;
}

struct Scales {
  double size, relative_error;
};

class BoundsHold : public ::testing::TestWithParam<Scales> {};

TEST_P(BoundsHold, OfTheCotangency) {
  Random random(2);
  double most = 0;
  for (int k = 0; k < 2000; ++k) {
    Pair p[6];
    for (Pair& pair : p) pair = random_pair(random, GetParam().size, GetParam().relative_error);
    const auto f = cotangency_of_pairs(p, [](const Pair& q) { return q.computed(); });
    const auto truth = cotangency_of_pairs(p, [](const Pair& q) { return q.truth(); });
    const auto bound = cotangency_bound_of_pairs(p);
    most = std::fmax(most, used(f, truth, bound.err * bound_up));
  }
  EXPECT_LE(most, 1);
  EXPECT_GE(most, 0.001) << "the bound is far from what can happen";
}

TEST_P(BoundsHold, OfTheCocircularity) {
  Random random(3);
  double most = 0;
  for (int k = 0; k < 2000; ++k) {
    Pair p[3];
    for (Pair& pair : p) {
      pair = random_pair(random, GetParam().size, GetParam().relative_error);
      pair.r.c[0] = 0;
      pair.true_r.c[0] = 0;
    }
    const auto term = [&](int a, int b, int c) {
      return cocircularity_term(p[a].computed(), p[b].x, p[b].y, p[c].x, p[c].y);
    };
    const auto true_term = [&](int a, int b, int c) {
      return cocircularity_term(p[a].truth(), p[b].true_x, p[b].true_y, p[c].true_x, p[c].true_y);
    };
    const auto bound = [&](int a, int b, int c) {
      return p[a].bound() * determinant_bound(p[b].far(), p[b].err, p[c].far(), p[c].err);
    };
    // The sum of the three is rounded twice.
    const auto all = total(bound(0, 1, 2), bound(1, 2, 0), bound(2, 0, 1));
    most = std::fmax(most, used(term(0, 1, 2) + term(1, 2, 0) + term(2, 0, 1),
                                true_term(0, 1, 2) + true_term(1, 2, 0) + true_term(2, 0, 1),
                                (all.err + 2 * unit_roundoff * all.size) * bound_up));
  }
  EXPECT_LE(most, 1);
  EXPECT_GE(most, 0.001) << "the bound is far from what can happen";
}

// The rule of products alone, each factor erring in its turn.
TEST_P(BoundsHold, OfProducts) {
  Random random(7);
  double most = 0;
  for (int k = 0; k < 2000; ++k) {
    Form<double, 0> computed[2];
    Form<Rational, 0> truth[2];
    Bound<double> bound[2];
    for (int i = 0; i < 2; ++i) {
      const double value = between(random, -1, 1) * GetParam().size;
      const double err = i == k % 2 ? GetParam().relative_error * GetParam().size : 0;
      computed[i] = {{value}};
      truth[i] = {{off(random, value, err)}};
      bound[i] = {std::fabs(value), err};
    }
    most = std::fmax(most, used(computed[0] * computed[1], truth[0] * truth[1],
                                (bound[0] * bound[1]).err * bound_up));
  }
  EXPECT_LE(most, 1);
  EXPECT_GE(most, 0.1);
}

// The rule of the cotangency alone, each of its three products erring in its turn.
TEST_P(BoundsHold, OfTheCotangencyOfThreeProducts) {
  Random random(8);
  double most = 0;
  for (int k = 0; k < 2000; ++k) {
    Form<double, 0> computed[3];
    Form<Rational, 0> truth[3];
    Bound<double> bound[3];
    for (int i = 0; i < 3; ++i) {
      const double value = between(random, -1, 1) * GetParam().size;
      const double err = i == k % 3 ? GetParam().relative_error * GetParam().size : 0;
      computed[i] = {{value}};
      truth[i] = {{off(random, value, err)}};
      bound[i] = {std::fabs(value), err};
    }
    most =
        std::fmax(most, used(cotangency_of(computed[0], computed[1], computed[2]),
                             cotangency_of(truth[0], truth[1], truth[2]),
                             cotangency_bound(total(bound[0], bound[1], bound[2])).err * bound_up));
  }
  EXPECT_LE(most, 1);
  EXPECT_GE(most, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Scales, BoundsHold,
                         ::testing::Values(Scales{100, 0}, Scales{100, 0x1p-50},
                                           Scales{100, 0x1p-3}, Scales{0x1p-100, 0x1p-50},
                                           Scales{0x1p100, 0x1p-50}));

// What overflows has no bound: the computed coefficient is never beyond it.
TEST(Bounds, AreInfiniteWhereSomethingOverflows) {
  Random random(4);
  for (const double size : {0x1p126, 0x1p127, 0x1p128, 0x1p130, 0x1p500}) {
    for (int k = 0; k < 200; ++k) {
      Pair p[6];
      for (Pair& pair : p) pair = random_pair(random, size, 0);
      const auto f = cotangency_of_pairs(p, [](const Pair& q) { return q.computed(); });
      const auto bound = cotangency_bound_of_pairs(p);
      const double err = bound.err + unit_roundoff * (80 * bound.size);
      for (const double c : f.c) EXPECT_TRUE(std::isfinite(c) || !(std::fabs(c) > err));
    }
  }
}

// A function of time, as a jet and as it truly is: a linear one whose value and slope at c err by
// as much as they may.
struct Linear {
  Jet<double> jet;
  Polynomial<Rational> truth;  // in the time since c
};

Linear random_linear(Random& random, double h, double value_error, double slope_error) {
  Linear f;
  const double v = between(random, -100, 100), lo = v * 0x1p-54 * between(random, -1, 1);
  const double d = between(random, -100, 100);
  const double e_v = std::fabs(v) * value_error, e_d = std::fabs(d) * slope_error;
  const double Dh = std::fabs(d) + e_d;
  f.jet = {{v, lo}, d, std::fabs(v), std::fabs(d), e_v, e_d, std::fabs(v) + e_v + Dh * h, Dh, 0};
  const Rational at_c = to_rational(v) + to_rational(lo) + off(random, 0, e_v);
  f.truth = {at_c, off(random, d, e_d)};
  return f;
}

struct JetErrors {
  double value, slope;
};

class JetsHold : public ::testing::TestWithParam<JetErrors> {};

TEST_P(JetsHold, ThroughTheCotangency) {
  Random random(5);
  double most_value = 0, most_slope = 0, most_curve = 0;
  const double h = 0x1p-4;
  for (int k = 0; k < 3000; ++k) {
    Linear p[6];
    for (Linear& q : p) q = random_linear(random, h, GetParam().value, GetParam().slope);
    const auto f = cotangency_of_pairs(p, [](const Linear& q) { return q.jet; });
    const auto truth = cotangency_of_pairs(p, [](const Linear& q) { return q.truth; });
    const auto share = [](const Rational& error, double bound) {
      return std::fabs(error.get_d()) / (bound * jet_up);
    };
    const Rational value = to_rational(f.v.hi) + to_rational(f.v.lo);
    const auto slope = truth.derivative(), curve = slope.derivative();
    most_value = std::fmax(most_value, share(value - truth.evaluate(0), f.e_v));
    most_slope = std::fmax(most_slope, share(to_rational(f.d) - slope.evaluate(0), f.e_d));
    EXPECT_LE(std::fabs(f.v.hi), f.V * jet_up);
    EXPECT_LE(std::fabs(f.d), f.D * jet_up);
    for (const double t : {-h, -0.5 * h, 0.0, 0.25 * h, h}) {
      most_curve = std::fmax(most_curve, share(curve.evaluate(to_rational(t)), f.D2h));
      EXPECT_LE(share(slope.evaluate(to_rational(t)), f.Dh), 1);
      EXPECT_LE(share(truth.evaluate(to_rational(t)), f.Vh), 1);
    }
  }
  EXPECT_LE(most_value, 1);
  EXPECT_LE(most_slope, 1);
  EXPECT_LE(most_curve, 1);
  EXPECT_GE(most_value, 0.01);
  EXPECT_GE(most_slope, 0.01);
  EXPECT_GE(most_curve, 0.01);
}

// The rule of products alone: no sum pays for them.
TEST_P(JetsHold, ThroughProducts) {
  Random random(6);
  double most_value = 0, most_slope = 0;
  for (int k = 0; k < 3000; ++k) {
    Linear p[4];
    for (Linear& q : p) q = random_linear(random, 0, GetParam().value, GetParam().slope);
    const Jet<double> f = (p[0].jet * p[1].jet) * (p[2].jet * p[3].jet);
    const auto truth = (p[0].truth * p[1].truth) * (p[2].truth * p[3].truth);
    const Rational value = to_rational(f.v.hi) + to_rational(f.v.lo);
    const Rational off = value - truth.evaluate(0);
    const Rational slope_off = to_rational(f.d) - truth.derivative().evaluate(0);
    most_value = std::fmax(most_value, std::fabs(off.get_d()) / (f.e_v * jet_up));
    most_slope = std::fmax(most_slope, std::fabs(slope_off.get_d()) / (f.e_d * jet_up));
  }
  EXPECT_LE(most_value, 1);
  EXPECT_LE(most_slope, 1);
  EXPECT_GE(most_value, 0.01);
  EXPECT_GE(most_slope, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Errors, JetsHold,
                         ::testing::Values(JetErrors{0, 0}, JetErrors{0x1p-53, 0},
                                           JetErrors{0x1p-80, 0x1p-50},
                                           JetErrors{0x1p-53, 0x1p-10}));

}  // namespace
}  // namespace voroproof::internal::testing
