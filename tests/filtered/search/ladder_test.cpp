// The order in which tiers are asked, what is counted, and what happens where none answers.
#include "filtered/search/ladder.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "library/maneuver_input.h"
#include "tests/support/compact_arithmetic.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {
namespace {

using Answer = std::optional<int>;

std::uint64_t count(const TierCounts& counts, Tier tier) {
  return counts.decided[static_cast<int>(Predicate::compare)][static_cast<int>(tier)];
}

TEST(Ladder, AsksInOrderUntilOneAnswers) {
  TierCounts counts;
  Ladder<int> ladder(counts, Predicate::compare);
  std::string asked;
  const Rung silent{Tier::dd, [&]() -> Answer { return asked += 'd', std::nullopt; }};
  const Rung answers{Tier::ball, [&]() -> Answer { return asked += 'b', 7; }};
  const Rung later{Tier::exact, [&]() -> Answer { return asked += 'e', 8; }};
  EXPECT_EQ(ladder.climb(silent, answers, later), 7);
  EXPECT_EQ(asked, "db");
  EXPECT_EQ(ladder.climb(later, answers), 8);
  EXPECT_EQ(asked, "dbe");
  EXPECT_EQ(ladder.climb(silent), std::nullopt);
  EXPECT_EQ(count(counts, Tier::dd), 0u);
  EXPECT_EQ(count(counts, Tier::ball), 1u);
  EXPECT_EQ(count(counts, Tier::exact), 1u);
  EXPECT_TRUE(ladder.budget().empty());
}

TEST(Ladder, ARungBeyondItsBudgetIsPassed) {
  TierCounts counts;
  Ladder<int> ladder(counts, Predicate::compare);
  const Rung expensive{Tier::exact, []() -> Answer { throw BudgetExceeded(1000, 4); }};
  const Rung balls{Tier::ball, []() -> Answer { return -1; }};
  EXPECT_EQ(ladder.climb(expensive, balls), -1);
  EXPECT_EQ(count(counts, Tier::exact), 0u);
  EXPECT_NE(ladder.budget().find("1000"), std::string::npos);
  EXPECT_THROW(
      ladder.climb(Rung{Tier::exact, []() -> Answer { throw std::domain_error("inside"); }}),
      std::domain_error);
}

TEST(Ladder, MoreBitsUntilTheMostThereMayBe) {
  const Scene scene = scene_of(10, 1, {disk(0, 0, 1, 1, 0)});
  MotionOptions options;
  options.start_bits = 128;
  options.max_bits = 1024;
  TierCounts counts;
  ComputedMotion enough(motion_input(scene), options);
  Ladder<int> ladder(counts, Predicate::compare);
  const auto told_with = [](const Motion& motion, int bits) {
    return Rung{Tier::ball,
                [&motion, bits] { return motion.goal_bits() >= bits ? Answer(1) : std::nullopt; }};
  };
  EXPECT_EQ(ladder.with_more_bits(enough, told_with(enough, 500)), 1);
  EXPECT_LT(enough.goal_bits(), 1024);
  ComputedMotion too_few(motion_input(scene), options);
  EXPECT_EQ(ladder.with_more_bits(too_few, told_with(too_few, 5000)), std::nullopt);
  EXPECT_EQ(count(counts, Tier::ball), 1u);
}

}  // namespace
}  // namespace voroproof::internal::testing
