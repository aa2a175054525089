#include "exact/rounding.h"

#include <gtest/gtest.h>
#include <xmmintrin.h>

#include <cfenv>

namespace voroproof::internal {
namespace {

// Sets the thread's arithmetic back, whatever the test did to it.
class Arithmetic : public testing::Test {
 protected:
  void SetUp() override { control_ = _mm_getcsr(); }
  void TearDown() override {
    std::fesetround(FE_TONEAREST);
    _mm_setcsr(control_);
  }

 private:
  unsigned control_ = 0;
};

TEST_F(Arithmetic, IsThatOfIeeeUnlessSomebodyChangesIt) {
  EXPECT_TRUE(arithmetic_is_ieee());
  EXPECT_NO_THROW(require_ieee_arithmetic());
}

TEST_F(Arithmetic, EveryOtherRoundingModeIsSeen) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const bool seen = !arithmetic_is_ieee();
    std::fesetround(FE_TONEAREST);
    EXPECT_TRUE(seen) << mode;
  }
}

// What a program that is linked with -ffast-math does before main().
TEST_F(Arithmetic, SubnormalNumbersTurnedOffAreSeen) {
  constexpr unsigned flush_results = 0x8000, operands_are_zero = 0x0040;
  for (const unsigned bit : {flush_results, operands_are_zero}) {
    _mm_setcsr(_mm_getcsr() | bit);
    EXPECT_FALSE(arithmetic_is_ieee()) << bit;
    EXPECT_THROW(require_ieee_arithmetic(), std::runtime_error);
    _mm_setcsr(_mm_getcsr() & ~bit);
  }
  EXPECT_TRUE(arithmetic_is_ieee());
}

}  // namespace
}  // namespace voroproof::internal
