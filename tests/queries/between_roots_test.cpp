// Times at which one of several polynomials vanishes, and which of them are the same.
#include "library/queries/between_roots.h"

#include <gtest/gtest.h>

#include <vector>

namespace voroproof::internal {
namespace {

using P = Polynomial<Rational>;

// The roots of the candidates in (0, 4].
std::vector<AlgebraicTime> times(const std::vector<P>& candidates) {
  std::vector<AlgebraicTime> found;
  between_roots(0, 4, candidates,
                [&](const AlgebraicTime& since, const Rational&) { found.push_back(since); });
  found.erase(found.begin());  // the start
  return found;
}

const P root_of_2{-2, 0, 1}, root_of_3{-3, 0, 1}, quintic{-1, -1, 0, 0, 0, 1};

TEST(SameTime, OfCandidatesInOtherCompany) {
  const auto with_3 = times({root_of_3, root_of_2}), with_5 = times({quintic, root_of_2});
  ASSERT_EQ(with_3.size(), 2u);
  ASSERT_EQ(with_5.size(), 2u);
  EXPECT_TRUE(same_time(with_3[0], with_5[1]));
  EXPECT_FALSE(same_time(with_3[1], with_5[1]));
  EXPECT_FALSE(same_time(with_3[0], with_5[0]));
  // Each is of the candidate that vanishes then, and of no product.
  EXPECT_EQ(with_3[0].polynomial().degree(), 2);
  EXPECT_EQ(with_5[0].polynomial().degree(), 5);
  EXPECT_EQ(with_5[1].polynomial().degree(), 2);
}

// Where a candidate touches zero it does not change its sign: the time is that of the product.
TEST(SameTime, OfCandidatesThatTouchZero) {
  const auto touched = times({root_of_2 * root_of_2}), crossed = times({root_of_2});
  ASSERT_EQ(touched.size(), 1u);
  EXPECT_TRUE(same_time(touched[0], crossed[0]));
  EXPECT_EQ(compare(touched[0], crossed[0]), std::strong_ordering::equal);
}

TEST(SameTime, IsNotNearTime) {
  // Other roots by 2^-120: the intervals of both overlap.
  const Rational tiny = Rational(1) / (Integer(1) << 120);
  const auto one = times({root_of_2}), other = times({P{Rational(-2 - tiny), 0, 1}});
  EXPECT_LT(one[0].interval().lo, other[0].interval().hi);
  EXPECT_LT(other[0].interval().lo, one[0].interval().hi);
  EXPECT_FALSE(same_time(one[0], other[0]));
  // Rational ones.
  const auto two = times({P{-2, 1}}), square = times({P{-4, 0, 1}});
  EXPECT_TRUE(same_time(two[0], square[0]));
  EXPECT_TRUE(same_time(AlgebraicTime(2), square[0]));
  EXPECT_FALSE(same_time(AlgebraicTime(Rational(2 + tiny)), square[0]));
}

}  // namespace
}  // namespace voroproof::internal
