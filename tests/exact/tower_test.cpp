#include "exact/tower.h"

#include <gtest/gtest.h>
#include <mpfr.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/exact/fraction.h"
#include "tests/exact/powers.h"

namespace voroproof::internal {
namespace {

using testing::fraction;

// A random element over the given generators, built by field operations, together
// with its value by plain MPFR arithmetic at a precision that drowns all rounding:
// the second way to the same truth.
class Checked {
 public:
  static constexpr mpfr_prec_t precision = 4000;
  Checked(const Tower& x) : exact(x) {
    mpfr_init2(value_, precision);
    mpfr_set_q(value_, x.rational().get_mpq_t(), MPFR_RNDN);
  }
  Checked(const Checked& other) : exact(other.exact) {
    mpfr_init2(value_, precision);
    mpfr_set(value_, other.value_, MPFR_RNDN);
  }
  Checked& operator=(const Checked& other) {
    exact = other.exact;
    mpfr_set(value_, other.value_, MPFR_RNDN);
    return *this;
  }
  ~Checked() { mpfr_clear(value_); }

  friend Checked operator+(Checked a, const Checked& b) {
    a.exact += b.exact;
    mpfr_add(a.value_, a.value_, b.value_, MPFR_RNDN);
    return a;
  }
  friend Checked operator-(Checked a, const Checked& b) {
    a.exact -= b.exact;
    mpfr_sub(a.value_, a.value_, b.value_, MPFR_RNDN);
    return a;
  }
  friend Checked operator*(Checked a, const Checked& b) {
    a.exact *= b.exact;
    mpfr_mul(a.value_, a.value_, b.value_, MPFR_RNDN);
    return a;
  }
  friend Checked operator/(Checked a, const Checked& b) {
    a.exact /= b.exact;
    mpfr_div(a.value_, a.value_, b.value_, MPFR_RNDN);
    return a;
  }
  friend Checked sqrt(RadicalField& field, Checked a) {
    a.exact = field.sqrt(a.exact);
    // Rounding may have left a zero slightly negative.
    if (a.float_sign() == 0) mpfr_set_zero(a.value_, 1);
    mpfr_sqrt(a.value_, a.value_, MPFR_RNDN);
    return a;
  }

  // Values of these tests are zero or above 2^-1000 in magnitude; the float is good
  // to 2^-3000.
  int float_sign() const {
    if (mpfr_zero_p(value_) || mpfr_get_exp(value_) < -2000) return 0;
    return mpfr_sgn(value_);
  }
  double to_double() const { return mpfr_get_d(value_, MPFR_RNDN); }

  Tower exact;

 private:
  mpfr_t value_;
};

void expect_consistent(const Checked& x) {
  EXPECT_EQ(static_cast<int>(sign(x.exact)), x.float_sign());
  const auto [lo, hi] = double_interval(x.exact);
  EXPECT_LE(lo, hi);
  if (x.float_sign() != 0) {
    EXPECT_LE(lo, x.to_double());
    EXPECT_GE(hi, x.to_double());
    EXPECT_LE(hi, std::nextafter(lo, INFINITY));
  }
}

TEST(Tower, RationalsNeedNoField) {
  const Tower x = fraction(1, 3);
  const Tower y = fraction(3, 4) * Rational(2);
  EXPECT_TRUE((x + y).is_rational());
  EXPECT_EQ((x + y).rational(), fraction(11, 6));
  EXPECT_EQ((x * y).rational(), fraction(1, 2));
  EXPECT_EQ((x / y).rational(), fraction(2, 9));
  EXPECT_EQ((-x).rational(), fraction(-1, 3));
  EXPECT_LT(x, y);
  EXPECT_EQ(sign(x - x), Sign::zero);
  EXPECT_THROW(x / Tower(0), std::domain_error);
  EXPECT_THROW(x / (y - y), std::domain_error);
}

TEST(Tower, SquareRootsReuseRadicals) {
  RadicalField field;
  EXPECT_EQ(field.sqrt(0).rational(), 0);
  EXPECT_EQ(field.sqrt(fraction(9, 4)).rational(), fraction(3, 2));
  EXPECT_EQ(field.size(), 0u);
  const Tower root2 = field.sqrt(2);
  EXPECT_EQ(field.size(), 1u);
  EXPECT_EQ(field.sqrt(8), Tower(2) * root2);
  EXPECT_EQ(field.sqrt(fraction(1, 2)), root2 / Tower(2));
  EXPECT_EQ(field.sqrt(Tower(2) * 257 * 257), Tower(257) * root2);
  EXPECT_EQ(field.size(), 1u);

  const Tower nested = Tower(3) + root2;
  const Tower root_nested = field.sqrt(nested);
  EXPECT_EQ(field.size(), 2u);
  EXPECT_EQ(field.sqrt(nested * fraction(4, 9)), root_nested * fraction(2, 3));
  EXPECT_EQ(field.size(), 2u);
  EXPECT_EQ(root_nested * root_nested, nested);
  EXPECT_THROW(field.sqrt(root2 - 2), std::domain_error);

  // Equal in value, different in form: sqrt(6) is registered for itself.
  const Tower root3 = field.sqrt(3);
  const Tower root6 = field.sqrt(6);
  EXPECT_EQ(field.size(), 4u);
  const Tower a = field.sqrt(Tower(5) + root6);
  const Tower b = field.sqrt(Tower(5) + root2 * root3);
  EXPECT_EQ(field.size(), 5u);
  EXPECT_EQ(a, b);
}

TEST(Tower, DependentRadicalsAreDecidedByValue) {
  RadicalField field;
  const Tower root2 = field.sqrt(2);
  const Tower root3 = field.sqrt(3);
  const Tower root6 = field.sqrt(6);
  const Tower zero = root6 - root2 * root3;
  EXPECT_EQ(sign(zero), Sign::zero);
  EXPECT_THROW(Tower(1) / zero, std::domain_error);
  EXPECT_THROW(root2 / (zero * root3), std::domain_error);
  EXPECT_EQ(field.sqrt(zero), Tower(0));

  // The norm of this one vanishes although it does not.
  const Tower twice = root6 + root2 * root3;
  EXPECT_EQ(twice, Tower(2) * root6);
  EXPECT_EQ(twice * (Tower(1) / twice), Tower(1));
  EXPECT_EQ(Tower(12) / twice, root6);
  EXPECT_GT(twice, zero);

  // Denesting that the field does not see: sqrt(5 + 2 sqrt 6) = sqrt 2 + sqrt 3.
  const Tower nested = field.sqrt(Tower(5) + Tower(2) * root6);
  EXPECT_EQ(field.size(), 4u);
  EXPECT_EQ(nested, root2 + root3);
  EXPECT_EQ(sign(nested - root2 - root3), Sign::zero);
  EXPECT_EQ(Tower(1) / (nested + root3), Tower(1) / (root2 + Tower(2) * root3));
  EXPECT_THROW(Tower(1) / (nested - root2 - root3), std::domain_error);
}

// D. Shanks, "Incredible identities", Fibonacci Quarterly 12 (1974).
TEST(Tower, ShanksIdentity) {
  RadicalField field({.radicals = 8});
  const Tower root5 = field.sqrt(5);
  const Tower root29 = field.sqrt(29);
  const Tower left = root5 + field.sqrt(Tower(22) + 2 * root5);
  const Tower inner = field.sqrt(Tower(55) - 10 * root29);
  const Tower right =
      field.sqrt(Tower(11) + 2 * root29) + field.sqrt(Tower(16) - 2 * root29 + 2 * inner);
  EXPECT_EQ(left, right);
  // One part in 10^300 away it is no identity, and enclosures alone decide.
  Integer large;
  mpz_ui_pow_ui(large.get_mpz_t(), 10, 300);
  const Tower nudge = Rational(Integer(1), large);
  EXPECT_GT(left + nudge, right);
  EXPECT_LT(left - nudge, right);
}

// Convergents p/q of sqrt 2: p^2 - 2 q^2 = +1 or -1, far beyond any enclosure tried.
TEST(Tower, SignsBeyondEveryEnclosure) {
  RadicalField field;
  const Tower root2 = field.sqrt(2);
  Integer p = 1, q = 1;
  for (int i = 0; i < 3000; ++i) {
    const Integer next = p + 2 * q;
    q += p;
    p = next;
    const Tower difference = Tower(Rational(p)) - Tower(Rational(q)) * root2;
    const Sign expected = sgn(Integer(p * p - 2 * q * q)) > 0 ? Sign::positive : Sign::negative;
    if (i % 100 < 2) {
      EXPECT_EQ(sign(difference), expected) << i;
      EXPECT_EQ(sign(-difference), -expected) << i;
    }
  }
  EXPECT_GT(mpz_sizeinbase(p.get_mpz_t(), 2), 2000u);
}

TEST(Tower, AgreesWithHighPrecisionFloats) {
  std::mt19937_64 random(5);
  for (int round = 0; round < 1500; ++round) {
    RadicalField field({.radicals = 4});
    std::vector<Checked> pool;
    for (int i = 0; i < 3; ++i) {
      const long numerator = static_cast<long>(random() % 41) - 20;
      pool.emplace_back(fraction(numerator, static_cast<long>(random() % 9) + 1));
    }
    auto pick = [&]() -> const Checked& { return pool[random() % pool.size()]; };
    for (int step = 0; step < 12; ++step) {
      const Checked a = pick();
      const Checked b = pick();
      Checked c = a;
      switch (random() % 5) {
        case 0:
          c = a + b;
          break;
        case 1:
          c = a - b;
          break;
        case 2:
          c = a * b;
          break;
        case 3:
          if (b.float_sign() == 0) {
            EXPECT_THROW(a.exact / b.exact, std::domain_error);
          } else {
            c = a / b;
          }
          break;
        default:
          if (a.float_sign() < 0) {
            EXPECT_THROW(field.sqrt(a.exact), std::domain_error);
          } else if (field.size() < field.budget().radicals) {
            c = sqrt(field, a);
          }
      }
      if (bit_size(c.exact) > 200) continue;
      expect_consistent(c);
      EXPECT_EQ(static_cast<int>(sign(c.exact - a.exact)), (c - a).float_sign());
      EXPECT_EQ(c.exact < a.exact, (c - a).float_sign() < 0);
      pool.push_back(c);
    }
  }
}

TEST(Tower, FieldAxioms) {
  RadicalField field;
  std::mt19937_64 random(6);
  auto small = [&] {
    const long numerator = static_cast<long>(random() % 19) - 9;
    return fraction(numerator, static_cast<long>(random() % 5) + 1);
  };
  const Tower s = field.sqrt(3);
  const Tower t = field.sqrt(Tower(7) - 2 * s);
  const Tower u = field.sqrt(t + s);
  for (int i = 0; i < 30; ++i) {
    auto element = [&] {
      Tower sum;
      for (const Tower& basis : {Tower(1), s, t, s * t, u, t * u}) sum += small() * basis;
      return sum;
    };
    const Tower x = element();
    const Tower y = element();
    const Tower z = element();
    EXPECT_EQ((x + y) * z, x * z + y * z);
    EXPECT_EQ((x * y) * z, x * (y * z));
    EXPECT_EQ(x - y, -(y - x));
    if (sign(y) != Sign::zero) {
      EXPECT_EQ(x / y * y, x);
    }
    EXPECT_EQ(sign(x * y), sign(x) * sign(y));
  }
}

TEST(Tower, EnclosuresContainTheValueAndShrink) {
  RadicalField field;
  const Tower x = field.sqrt(Tower(2) + field.sqrt(3)) - field.sqrt(fraction(7, 2));
  for (const int precision : {30, 64, 200, 1000}) {
    const auto [lower, upper] = ball(x, precision).rational_interval();
    EXPECT_LE(Tower(lower), x);
    EXPECT_GE(Tower(upper), x);
    EXPECT_LT(upper - lower, testing::power_of_two(6 - precision));
  }
}

// Radicals may depend on each other, so that no enclosure tells a number from a binary64 or from a
// point at which the nearest one changes: around zero and the powers of two, where neighbours are
// not equally far, and at ties.
TEST(Tower, RoundsWhatNoEnclosureTellsFromABinary64) {
  RadicalField field;
  const Tower zero = field.sqrt(2) * field.sqrt(3) - field.sqrt(6);
  ASSERT_FALSE(zero.is_rational());
  for (const double x :
       {0.0, 1.0, 0.5, -2.0, 0.1, 0x1p-1074, -0x1p-1022, 0x1.fffffffffffffp+1023}) {
    EXPECT_EQ(round_nearest(Tower(to_rational(x)) + zero), x);
  }
  const Tower one(1), half_place(testing::power_of_two(-53)), nothing(testing::power_of_two(-1074));
  EXPECT_EQ(round_nearest(one + half_place + zero), 1);
  EXPECT_EQ(round_nearest(one + half_place + zero + nothing), 1 + 0x1p-52);
  EXPECT_EQ(round_nearest(one - half_place * testing::power_of_two(-1) + zero), 1);
  EXPECT_EQ(round_nearest(nothing * fraction(1, 2) + zero), 0);
  EXPECT_EQ(round_nearest(nothing * fraction(2, 3) + zero), 0x1p-1074);
  // Small, and known to few of the bits that are looked at first.
  const Tower small = (field.sqrt(2) - field.sqrt(Rational(2) + testing::power_of_two(-700)));
  EXPECT_EQ(round_nearest(small),
            round_nearest(Tower(-testing::power_of_two(-701)) / field.sqrt(2)));
  EXPECT_EQ(round_nearest(small * small), round_nearest(Rational(testing::power_of_two(-1403))));
}

TEST(Tower, DifferentFieldsDoNotMix) {
  RadicalField one, other;
  const Tower x = one.sqrt(2);
  const Tower y = other.sqrt(2);
  EXPECT_THROW(x + y, std::invalid_argument);
  EXPECT_THROW(x * y, std::invalid_argument);
  EXPECT_THROW(one.sqrt(y), std::invalid_argument);
}

TEST(Budget, StopsAtTheStatedNumberOfRadicals) {
  RadicalField field({.radicals = 2});
  field.sqrt(2);
  field.sqrt(3);
  EXPECT_EQ(field.sqrt(12), Tower(2) * field.sqrt(3));  // needs none
  try {
    field.sqrt(5);
    FAIL() << "a third radical was granted";
  } catch (const BudgetExceeded& e) {
    EXPECT_EQ(e.degree, 8u);
    EXPECT_EQ(e.bits, 3u);
    EXPECT_NE(std::string(e.what()).find("3 bits"), std::string::npos);
    EXPECT_NE(std::string(e.what()).find("degree 8"), std::string::npos);
  }
  EXPECT_EQ(field.size(), 2u);
}

TEST(Budget, StopsAtTheStatedSizeOfCoefficients) {
  RadicalField field({.coefficient_bits = 100});
  Tower x = field.sqrt(2) + 3;
  try {
    for (int i = 0; i < 20; ++i) x *= x;
    FAIL() << "coefficients grew to " << bit_size(x);
  } catch (const BudgetExceeded& e) {
    EXPECT_GT(e.bits, 100u);
    EXPECT_EQ(e.degree, 2u);
  }
  EXPECT_LE(bit_size(x), 100u);
}

TEST(Budget, PlainRationalsKeepToThatOfTheFieldMadeLast) {
  const auto grow = [] {
    Tower x = Tower(3) / Tower(2);
    for (int i = 0; i < 8; ++i) x = x * x - Tower(1) / x + x;
    return bit_size(x);
  };
  EXPECT_GT(grow(), 1000u);
  const RadicalField wide({.coefficient_bits = 1 << 16});
  {
    const RadicalField narrow({.coefficient_bits = 100});
    EXPECT_THROW(grow(), BudgetExceeded);
  }
  EXPECT_GT(grow(), 1000u);
}

}  // namespace
}  // namespace voroproof::internal
