// How far the claimed times of flips are from the true ones, as the certificate tells.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>

#include "tests/certify/claimed_history.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
namespace {

Scene some_scene() {
  Random random(7);
  return random_scene({.n = 12}, random);
}

TEST(TimeErrors, AreToldInUnitsInTheLastPlace) {
  const Scene scene = some_scene();
  const ClaimedHistory right = claimed_history(scene, run(scene));
  const Certificate rounded = certify(scene, right);
  ASSERT_EQ(rounded.verdict, Verdict::certified);
  EXPECT_LE(rounded.ulps_max, 0.5 + 1e-9);
  EXPECT_GT(rounded.ulps_mean(), 0);
  // Within the steps that are looked at first, at their end, and beyond.
  for (const int ulps : {1, 3, 4, 5, 100, 100000}) {
    ClaimedHistory shifted = right;
    // In the middle, to have no claim beside it that would come first then.
    const std::size_t k = shifted.events.size() / 2;
    std::size_t at = k;
    while (!std::holds_alternative<FlipEvent>(shifted.events[at])) ++at;
    double& t = std::get<FlipEvent>(shifted.events[at]).t;
    for (int step = 0; step < ulps; ++step) {
      t = std::nextafter(t, std::numeric_limits<double>::infinity());
    }
    const Certificate c = certify(scene, shifted);
    ASSERT_EQ(c.verdict, Verdict::certified) << ulps;
    EXPECT_NEAR(c.ulps_max, ulps, 0.5 + 1e-9);
    EXPECT_EQ(c.ulps_max_line, static_cast<std::int64_t>(at) + 2);
    EXPECT_NEAR((c.ulps_mean() - rounded.ulps_mean()) * static_cast<double>(c.flips), ulps, 1);
  }
}

TEST(TimeErrors, NothingElseDependsOnWhetherTheyAreToldOf) {
  const Scene scene = some_scene();
  const ClaimedHistory history = claimed_history(scene, run(scene));
  const Certificate with = certify(scene, history);
  CertifyOptions options;
  options.measures_times = false;
  const Certificate without = certify(scene, history, options);
  EXPECT_EQ(without.ulps_max, 0);
  EXPECT_EQ(without.ulps_mean(), 0);
  EXPECT_EQ(without.verdict, with.verdict);
  EXPECT_EQ(without.flips, with.flips);
  EXPECT_EQ(without.edge_lives, with.edge_lives);
  EXPECT_EQ(without.pair_lives, with.pair_lives);
  EXPECT_EQ(without.tiers.beyond_filter, with.tiers.beyond_filter);
  EXPECT_EQ(without.highest_bits, with.highest_bits);
}

}  // namespace
}  // namespace voroproof::internal::testing
