#include "exact/compact_rational.h"

#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

#include "tests/exact/powers.h"

namespace voroproof::internal {
namespace {

// Values of all three kinds, and near the limits between them.
std::vector<Rational> values() {
  const auto power = [](long e) { return testing::power_of_two(e); };
  const Rational tenth(1, 10), nearest = to_rational(0.1), eps = power(-53);
  std::vector<Rational> out{0, 1, tenth, nearest, Rational(nearest * nearest), 1 + eps, 1 - eps / 2,
                            // Ties: beyond the nearest double is half a unit of its last place.
                            1 + 3 * eps, 1 + eps + power(-106), 1 + eps + power(-107),
                            1 + power(-900), 1 + power(-1074), 1 + power(-1075), power(-1074),
                            power(-1075), 3 * power(-1075), power(1023), power(1024),
                            power(1024) - power(970), power(1024) - power(969), power(3000),
                            1 + power(-53) + power(-160)};
  for (std::size_t k = 0, n = out.size(); k < n; ++k) out.push_back(-out[k]);
  return out;
}

TEST(CompactRational, HoldsEveryValue) {
  std::size_t doubles = 0, sums = 0, others = 0;
  for (const Rational& q : values()) {
    const CompactRational c = q;
    EXPECT_EQ(c.value(), q);
    EXPECT_EQ(sgn(c), sgn(q));
    EXPECT_EQ(round_nearest(c), round_nearest(q));
    if (c.exact() != nullptr) {
      ++others;
      EXPECT_EQ(*c.exact(), q);
      continue;
    }
    ++(c.is_double() ? doubles : sums);
    EXPECT_EQ(c.leading(), round_nearest(q));
    EXPECT_EQ(to_rational(c.leading()) + to_rational(c.second()), q);
  }
  EXPECT_GT(doubles, 8u);
  EXPECT_GT(sums, 8u);
  EXPECT_GT(others, 8u);
}

TEST(CompactRational, EqualJustWhereTheValuesAre) {
  const std::vector<Rational> all = values();
  for (const Rational& p : all) {
    for (const Rational& q : all) EXPECT_EQ(CompactRational(p) == CompactRational(q), p == q);
  }
  EXPECT_EQ(CompactRational(0.1), CompactRational(to_rational(0.1)));
  EXPECT_EQ(CompactRational(-0.0), CompactRational());
}

TEST(CompactRational, SquaresHaveTheFormOfTheirValue) {
  std::mt19937_64 random(1);
  std::vector<Rational> all = values();
  for (int k = 0; k < 2000; ++k) {
    const int e = static_cast<int>(random() % 1000) - 500;
    all.push_back(to_rational(std::ldexp(static_cast<double>(random() >> 11), e)));
  }
  for (const Rational& q : all) {
    EXPECT_EQ(square(CompactRational(q)), CompactRational(Rational(q * q)));
  }
}

TEST(CompactRational, DifferencesHaveTheFormOfTheirValue) {
  std::mt19937_64 random(2);
  std::vector<Rational> all = values();
  for (int k = 0; k < 60; ++k) {
    const int e = static_cast<int>(random() % 200) - 100;
    all.push_back(to_rational(std::ldexp(static_cast<double>(random() >> 11), e)));
  }
  for (const Rational& p : all) {
    for (const Rational& q : all) {
      EXPECT_EQ(CompactRational(p) - CompactRational(q), CompactRational(Rational(p - q)));
    }
  }
}

// From and to each kind, and to itself.
TEST(CompactRational, CopiesAndMoves) {
  const Rational kinds[] = {5, Rational(1 + to_rational(0x1p-60)), Rational(1, 3), Rational(2, 7)};
  for (const Rational& from : kinds) {
    for (const Rational& to : kinds) {
      const CompactRational a = from;
      CompactRational b = to;
      b = a;
      EXPECT_EQ(b.value(), from);
      EXPECT_EQ(a.value(), from);
      CompactRational c = to;
      b = std::move(c);
      EXPECT_EQ(b.value(), to);
      const CompactRational d = std::move(b);
      EXPECT_EQ(d.value(), to);
      CompactRational e = from;
      const CompactRational& same = e;
      e = same;
      EXPECT_EQ(e.value(), from);
    }
  }
}

}  // namespace
}  // namespace voroproof::internal
