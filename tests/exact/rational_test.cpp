#include "exact/rational.h"

#include <gtest/gtest.h>
#include <mpfr.h>

#include <cfenv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>
#include <string>

#include "tests/exact/powers.h"

namespace voroproof::internal {
namespace {

using testing::power_of_two;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();

std::uint64_t bits_of(double x) {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

double random_finite(std::mt19937_64& random) {
  for (;;) {
    const std::uint64_t bits = random();
    double x;
    std::memcpy(&x, &bits, sizeof x);
    if (std::isfinite(x)) return x;
  }
}

// ---- Reading ---------------------------------------------------------------------

struct Accepted {
  const char* text;
  Rational value;
};

TEST(ParseRational, ReadsExactValues) {
  const Accepted cases[] = {
      {"0", 0},
      {"-0", 0},
      {"0.1", Rational(1, 10)},
      {"-1.5e3", -1500},
      {"1e+2", 100},
      {"1E-2", Rational(1, 100)},
      {"007", 7},
      {"0.10", Rational(1, 10)},
      {"1/3", Rational(1, 3)},
      {"-4/6", Rational(-2, 3)},
      {"0/5", 0},
      {"010/8", Rational(5, 4)},
      {"0x1.8p-3", Rational(3, 16)},
      {"-0X1.8P+1", -3},
      {"0xff", 255},
      {"0x0.1", Rational(1, 16)},
      {"0x1p-1074", power_of_two(-1074)},
  };
  for (const Accepted& c : cases) {
    std::string reason;
    const auto value = parse_rational(c.text, &reason);
    ASSERT_TRUE(value) << c.text << ' ' << reason;
    EXPECT_EQ(*value, c.value) << c.text;
    EXPECT_TRUE(reason.empty());
    // In lowest terms with a positive denominator.
    Rational canonical = *value;
    canonical.canonicalize();
    EXPECT_EQ(value->get_den(), canonical.get_den()) << c.text;
  }
}

TEST(ParseRational, RefusesEverythingElse) {
  for (const char* text : {"",         "-",         "+1",
                           "--1",      " 1",        "1 ",
                           "1\n",      ".5",        "5.",
                           "1.e3",     "1e",        "1e+",
                           "1e1.5",    "1/0",       "1/00",
                           "1/",       "/3",        "1/-3",
                           "1/+3",     "1.5/2",     "1/2e3",
                           "1/2/3",    "0x",        "0x.8p1",
                           "0x1.p1",   "0x1p",      "0x1/3",
                           "0x1e+",    "nan",       "NaN",
                           "inf",      "-inf",      "Infinity",
                           "1,5",      "1_000",     "0b1",
                           "1e401",    "1e-401",    "0e99999999999999999999",
                           "0x1p1201", "0x1p-1201", "0x1g",
                           "\xd9\xa1"}) {
    std::string reason;
    EXPECT_FALSE(parse_rational(text, &reason)) << text;
    EXPECT_FALSE(reason.empty()) << text;
  }
  EXPECT_FALSE(parse_rational(std::string_view("1\0", 2)));
  EXPECT_FALSE(parse_rational("x"));  // without a reason
}

TEST(ParseRational, IsBoundedExactlyWhereDocumented) {
  const std::string longest(max_number_text, '7');
  EXPECT_EQ(*parse_rational(longest), Rational(Integer(longest)));
  EXPECT_FALSE(parse_rational(longest + '7'));
  EXPECT_TRUE(parse_rational("1e" + std::to_string(max_decimal_exponent)));
  EXPECT_TRUE(parse_rational("1e-" + std::to_string(max_decimal_exponent)));
  EXPECT_EQ(*parse_rational("0x1p" + std::to_string(max_binary_exponent)),
            power_of_two(max_binary_exponent));
  EXPECT_EQ(*parse_rational("0x1p-" + std::to_string(max_binary_exponent)),
            power_of_two(-max_binary_exponent));
}

// The C library's strtod rounds correctly: reading exactly and rounding once must
// agree with it, bit by bit.
TEST(ParseRational, RoundedAgreesWithStrtod) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    char text[200];
    const double x = random_finite(random);
    switch (i % 3) {
      case 0:
        std::snprintf(text, sizeof text, "%.*e", static_cast<int>(random() % 30), x);
        break;
      case 1:
        std::snprintf(text, sizeof text, "%a", x);
        break;
      default:  // anywhere, including beyond the range of binary64
        std::snprintf(text, sizeof text, "-%llu.%llue%d", static_cast<unsigned long long>(random()),
                      static_cast<unsigned long long>(random()),
                      static_cast<int>(random() % 761) - 380);
    }
    const auto value = parse_rational(text);
    ASSERT_TRUE(value) << text;
    const double expected = std::strtod(text, nullptr);
    const double got = round_nearest(*value);
    ASSERT_EQ(bits_of(got), bits_of(expected == 0 ? 0.0 : expected)) << text;
  }
}

// ---- Rounding --------------------------------------------------------------------

TEST(ToRational, IsExactAndRefusesWhatIsNotFinite) {
  EXPECT_EQ(to_rational(0.1), Rational(Integer("3602879701896397"), Integer(1) << 55));
  EXPECT_EQ(to_rational(-0.0), 0);
  EXPECT_EQ(to_rational(smallest), power_of_two(-1074));
  EXPECT_THROW(to_rational(infinity), std::domain_error);
  EXPECT_THROW(to_rational(std::nan("")), std::domain_error);
}

TEST(Rounding, KeepsEveryDouble) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 20000; ++i) {
    const double x = random_finite(random);
    const Rational q = to_rational(x);
    ASSERT_EQ(round_nearest(q), x);
    ASSERT_EQ(round_down(q), x);
    ASSERT_EQ(round_up(q), x);
  }
}

TEST(Rounding, BetweenNeighbours) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 20000; ++i) {
    const double a = random_finite(random);
    const double b = std::nextafter(a, infinity);
    if (b == infinity) continue;
    const Rational tick = (to_rational(b) - to_rational(a)) / 1024;
    const Rational middle = (to_rational(a) + to_rational(b)) / 2;
    ASSERT_EQ(round_nearest(middle - tick), a);
    ASSERT_EQ(round_nearest(middle + tick), b);
    const double even = bits_of(a) % 2 == 0 ? a : b;
    ASSERT_EQ(round_nearest(middle), even);
    ASSERT_EQ(round_down(middle), a);
    ASSERT_EQ(round_up(middle), b);
    ASSERT_EQ(round_down(to_rational(b) - tick), a);
    ASSERT_EQ(round_up(to_rational(a) + tick), b);
  }
}

TEST(Rounding, AtTheEndsOfTheRange) {
  const Rational past_largest = to_rational(largest) + power_of_two(969);
  EXPECT_EQ(round_nearest(past_largest), largest);
  EXPECT_EQ(round_up(past_largest), infinity);
  EXPECT_EQ(round_down(past_largest), largest);
  const Rational halfway = to_rational(largest) + power_of_two(970);
  EXPECT_EQ(round_nearest(halfway), infinity);
  EXPECT_EQ(round_nearest(-halfway), -infinity);
  const Rational huge = power_of_two(5000);
  EXPECT_EQ(round_nearest(huge), infinity);
  EXPECT_EQ(round_down(huge), largest);
  EXPECT_EQ(round_up(-huge), -largest);
  EXPECT_EQ(round_down(-huge), -infinity);

  const Rational tiny = power_of_two(-5000);
  EXPECT_EQ(round_nearest(tiny), 0);
  EXPECT_EQ(round_up(tiny), smallest);
  EXPECT_EQ(round_down(-tiny), -smallest);
  EXPECT_EQ(round_nearest(power_of_two(-1075)), 0);
  EXPECT_EQ(round_nearest(power_of_two(-1075) + tiny), smallest);
  for (const double zero : {round_nearest(-tiny), round_up(-tiny), round_nearest(0)}) {
    EXPECT_EQ(bits_of(zero), 0u) << "zero is +0";
  }
}

// Interval arithmetic elsewhere may have left another rounding mode behind.
TEST(Rounding, DoesNotDependOnTheProcessorsRoundingMode) {
  const Rational halfway = to_rational(largest) + power_of_two(970);
  for (const int mode : {FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO, FE_TONEAREST}) {
    ASSERT_EQ(std::fesetround(mode), 0);
    const double positive = round_nearest(halfway);
    const double negative = round_nearest(-halfway);
    const double third = round_nearest(Rational(1, 3));
    const double subnormal = round_nearest(power_of_two(-1075) * 3);
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(positive, infinity);
    EXPECT_EQ(negative, -infinity);
    EXPECT_EQ(third, 0x1.5555555555555p-2);
    EXPECT_EQ(subnormal, 2 * smallest);
  }
}

TEST(Rounding, AgreesWithMpfr) {
  std::mt19937_64 random(4);
  gmp_randclass integers(gmp_randinit_mt);
  integers.seed(4);
  mpfr_t x;
  mpfr_init2(x, 6000);  // enough for the first inexact bit of any of these fractions
  for (int i = 0; i < 5000; ++i) {
    Rational q(integers.get_z_bits(1 + random() % 200),
               integers.get_z_bits(1 + random() % 200) + 1);
    q.canonicalize();
    if (random() % 2) q = -q;
    q *= power_of_two(static_cast<long>(random() % 2400) - 1200);
    // Rounding to 6000 bits in the same direction first changes no directed result;
    // ties are dyadic and survive it exactly.
    mpfr_set_q(x, q.get_mpq_t(), MPFR_RNDD);
    ASSERT_EQ(round_down(q), mpfr_get_d(x, MPFR_RNDD));
    mpfr_set_q(x, q.get_mpq_t(), MPFR_RNDU);
    ASSERT_EQ(round_up(q), mpfr_get_d(x, MPFR_RNDU));
    mpfr_set_q(x, q.get_mpq_t(), MPFR_RNDN);
    ASSERT_EQ(round_nearest(q), mpfr_get_d(x, MPFR_RNDN));
  }
  mpfr_clear(x);
}

// ---- Helpers ---------------------------------------------------------------------

TEST(RationalSqrt, FindsSquaresAndOnlySquares) {
  for (int n = 0; n <= 40; ++n) {
    for (int d = 1; d <= 40; ++d) {
      Rational q(n, d);
      q.canonicalize();
      EXPECT_EQ(rational_sqrt(Rational(q * q)), q);
      const auto root = rational_sqrt(q);
      const bool is_square =
          std::round(std::sqrt(q.get_num().get_d())) * std::round(std::sqrt(q.get_num().get_d())) ==
              q.get_num().get_d() &&
          std::round(std::sqrt(q.get_den().get_d())) * std::round(std::sqrt(q.get_den().get_d())) ==
              q.get_den().get_d();
      EXPECT_EQ(root.has_value(), is_square) << q;
    }
  }
  EXPECT_FALSE(rational_sqrt(-4));
}

TEST(BitSize, IsThatOfTheLargerPart) {
  EXPECT_EQ(bit_size(Rational(255)), 8u);
  EXPECT_EQ(bit_size(Rational(-1, 256)), 9u);
}

TEST(SignAlgebra, UnknownIsAbsorbedByZeroOnly) {
  EXPECT_EQ(Sign::unknown * Sign::zero, Sign::zero);
  EXPECT_EQ(Sign::unknown * Sign::negative, Sign::unknown);
  EXPECT_EQ(Sign::negative * Sign::negative, Sign::positive);
  EXPECT_EQ(-Sign::unknown, Sign::unknown);
  EXPECT_EQ(-Sign::negative, Sign::positive);
}

}  // namespace
}  // namespace voroproof::internal
