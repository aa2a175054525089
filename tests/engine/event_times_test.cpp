// What the times of events ask for.
#include "engine/event_times.h"

#include <gtest/gtest.h>

#include "corpus/generate.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {
namespace {

// Each of these scenes has a flip whose enclosure is narrow, and still has the boundary between two
// doubles inside, before it is narrowed once more.
TEST(EventTimes, DoubleDoublesRoundWhatTheyCan) {
  struct Choice {
    int n;
    std::uint64_t seed;
    double horizon;
  };
  for (const auto& [n, seed, horizon] :
       {Choice{20, 25, 3000}, Choice{50, 17, 2000}, Choice{100, 17, 1500}}) {
    ReferenceOptions options;
    options.n = n;
    options.seed = seed;
    options.horizon = horizon;
    const RecordedRun r = run(generate_reference(options));
    const auto& rounded = r.stats.tiers.decided[static_cast<int>(Predicate::round_time)];
    EXPECT_GT(rounded[static_cast<int>(Tier::dd)], 4000u);
    EXPECT_EQ(rounded[static_cast<int>(Tier::ball)], 0u) << n;
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
