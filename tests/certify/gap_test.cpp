// The gap of two generators on lines.
#include "certify/gap.h"

#include <gtest/gtest.h>

#include "exact/roots.h"

namespace voroproof::internal::testing {
namespace {

// Disks of radius 1/2 on one line, ten apart at the time 3, that approach at speed 2: they touch at
// 3 + 9/2, and have passed through each other at 3 + 11/2.
Gap passing() {
  const Rational half(1, 2);
  return {Contact<Rational>(MovingSite<Rational>{0, 0, 2, 0, half},
                            MovingSite<Rational>{10, 0, 0, 0, half}),
          false, 3, 1, 0};
}

TEST(Gap, ChangesItsSignAtItsRoots) {
  const Gap gap = passing();
  const Rational enters(15, 2), leaves(17, 2), little(1, 1L << 40);
  EXPECT_FALSE(gap.changes_in(3, enters - little));
  EXPECT_TRUE(gap.changes_in(3, enters));
  EXPECT_TRUE(gap.changes_in(enters, enters));
  EXPECT_FALSE(gap.changes_in(enters + little, leaves - little));
  EXPECT_TRUE(gap.changes_in(8, leaves));
  EXPECT_TRUE(gap.changes_in(3, 100));
  EXPECT_FALSE(gap.changes_in(leaves + little, 100));
  const auto roots = isolate_roots(gap.polynomial(), Rational(0), Rational(100));
  ASSERT_EQ(roots.size(), 2u);
  EXPECT_EQ(sgn(gap.polynomial().evaluate(enters)), 0);
  EXPECT_EQ(sgn(gap.polynomial().evaluate(leaves)), 0);
}

// Those that only touch, or rest, do not change from apart to overlapping.
TEST(Gap, KeepsItsSignWhereTheTwoGraze) {
  const Rational half(1, 2);
  for (const int speed : {0, 2}) {
    const Gap gap(Contact<Rational>(MovingSite<Rational>{0, 1, speed, 0, half},
                                    MovingSite<Rational>{10, 0, 0, 0, half}),
                  false, 3, 1, 0);
    EXPECT_FALSE(gap.changes_in(3, 100));
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
