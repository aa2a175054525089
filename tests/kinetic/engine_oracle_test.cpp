// The engine's histories of random scenes against the oracles.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>

#include "tests/support/history_check.h"
#include "tests/support/random_scenes.h"

namespace voroproof::testing {
namespace {

struct Totals {
  CheckCounts seen;
  std::size_t flips = 0, collisions = 0;
};

// Runs and checks `scenes` scenes; every one must be right.
Totals expect_right(int scenes, const std::function<Scene(Random&)>& make, std::uint64_t seed,
                    const HistoryCheck& check = {}) {
  Random random(seed);
  Totals totals;
  for (int k = 0; k < scenes; ++k) {
    const Scene scene = make(random);
    const Run history = run(scene);
    const std::string fault = check_history(scene, history, check, &totals.seen);
    EXPECT_EQ(fault, "") << text(scene);
    totals.flips += history.count(Event::Kind::flip);
    totals.collisions += history.count(Event::Kind::collision);
  }
  EXPECT_EQ(totals.seen.skipped, 0);
  return totals;
}

TEST(EngineAgainstOracles, FewDisks) {
  for (int n : {0, 1, 2, 3}) {
    RandomScene options;
    options.n = n;
    options.rmin = 1;
    options.rmax = 20;
    options.horizon = 100;
    const Totals totals =
        expect_right(6, [&](Random& random) { return random_scene(options, random); }, 10 + n);
    if (n > 0) {
      EXPECT_GT(totals.collisions, 6u);
    }
    if (n > 1) {
      EXPECT_GT(totals.seen.brute_force, 10);
    }
  }
}

TEST(EngineAgainstOracles, ManyKindsOfRadii) {
  for (const auto& [rmin, rmax] : {std::pair(2.0, 8.0), std::pair(1e-4, 15.0), std::pair(5.0, 5.0),
                                   std::pair(4.0, 4.0 + 1e-9), std::pair(1e-9, 1e-9)}) {
    RandomScene options;
    options.n = 10;
    options.rmin = rmin;
    options.rmax = rmax;
    options.horizon = 30;
    const Totals totals =
        expect_right(4, [&](Random& random) { return random_scene(options, random); }, 20);
    EXPECT_GT(totals.flips, 40u);
    EXPECT_GT(totals.seen.brute_force, 8);
    EXPECT_GT(totals.seen.cgal, 4);
    EXPECT_GT(totals.seen.flip_times, 30);
  }
}

}  // namespace
}  // namespace voroproof::testing
