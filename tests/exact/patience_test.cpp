// Long decisions that ask whether they are still wanted.
#include "exact/patience.h"

#include <gtest/gtest.h>

#include <optional>

#include "exact/tower.h"

namespace voroproof::internal {
namespace {

// sqrt(2), sqrt(3), ... multiplied out: some thousand steps.
void decide_something() {
  RadicalField field;
  const Tower a = field.sqrt(Tower(2)), b = field.sqrt(Tower(3)), c = field.sqrt(Tower(5));
  const Tower x = Tower(1) + a + b + c;
  Tower power = x;
  for (int k = 0; k < 40; ++k) power = power * x;
  EXPECT_EQ(sign(power), Sign::positive);
}

TEST(Patience, NobodyIsAskedWithoutAny) { EXPECT_NO_THROW(decide_something()); }

TEST(Patience, ADecisionIsGivenUp) {
  int asked = 0;
  const Patience patience([&] { return ++asked < 3; });
  EXPECT_THROW(decide_something(), GivenUp);
  EXPECT_EQ(asked, 3);
}

TEST(Patience, ArithmeticOfPlainRationalsIsGivenUp) {
  const Patience patience([] { return false; });
  Tower x = 1;
  const auto count = [&x] {
    for (int k = 0; k < 1000; ++k) x = (x * Tower(2) - Tower(1)) / Tower(3) + Tower(1);
  };
  EXPECT_THROW(count(), GivenUp);
}

TEST(Patience, LongStepsCountAsMany) {
  int asked = 0;
  const Patience patience([&] { return ++asked > 0; });
  Patience::ask_now();
  EXPECT_EQ(asked, 1);
  for (int k = 0; k < 10; ++k) Patience::ask(1000);
  EXPECT_EQ(asked, 11);
  for (int k = 0; k < 20; ++k) Patience::ask();
  EXPECT_EQ(asked, 11);
}

TEST(Patience, TheInnerOneIsAsked) {
  int outer = 0, inner = 0;
  const Patience patience([&] { return ++outer > 0; });
  {
    const Patience of_a_part([&] { return ++inner > 0; });
    decide_something();
  }
  EXPECT_GT(inner, 5);
  EXPECT_EQ(outer, 0);
  decide_something();
  EXPECT_GT(outer, 5);
}

}  // namespace
}  // namespace voroproof::internal
