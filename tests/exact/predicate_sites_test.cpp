// The sites over which the laws of the predicates are tested: that no special position is rare.
#include "tests/exact/predicate_sites.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "exact/predicates.h"
#include "exact/rational.h"
#include "tests/exact/predicate_invariants.h"

namespace voroproof::internal::testing {
namespace {

// All laws are tested over such sites: that none of the special positions is rare.
TEST(Sites, AreDegenerateInEveryWay) {
  int walls[5] = {}, equal = 0, points = 0, contacts = 0, no_tangent = 0, lines = 0, circles = 0,
      coincident = 0, separate = 0, without_circle = 0;
  const rc::Gen<Four> gen = fours();
  constexpr int count = 4000;
  for (int k = 0; k < count; ++k) {
    const Four four = gen(rc::Random(k), rc::kNominalSize).value();
    const auto& s = four.at;
    ++walls[four.wall + 1];
    separate += are_separate(four);
    circles += f_of(s) == 0;
    lines += columns(s, {0, 1, 2}) == 0;
    if (are_separate(four)) without_circle += invariants(four).exists != Sign::positive;
    for (int i = 0; i < 4; ++i) {
      ASSERT_EQ(s[i].r < 0, i == four.wall);
      points += s[i].r == 0;
      for (int j = 0; j < i; ++j) {
        const Rational x = s[i].x - s[j].x, y = s[i].y - s[j].y, reach = s[i].r + s[j].r;
        equal += s[i].r == s[j].r;
        contacts += reach != 0 && x * x + y * y == reach * reach;
        no_tangent += tangency(s[i], s[j]) == 0;
        coincident += x == 0 && y == 0;
      }
    }
  }
  for (const int n : walls) EXPECT_GT(n, count / 8);
  for (const int n : {equal, points, contacts, no_tangent, lines, circles, coincident, separate,
                      without_circle}) {
    EXPECT_GT(n, count / 20);
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
