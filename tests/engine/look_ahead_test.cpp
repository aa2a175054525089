// How far searches look ahead where much happens in a short part of a run, by their number.
#include <gtest/gtest.h>

#include <cstdint>
#include <random>

#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {
namespace {

// Some searches for each event, and some for each edge and factor by which the rest of the run is
// longer than the part with events.
void expect_few_searches(const Scene& scene, std::uint64_t most) {
  std::uint64_t questions = 0;
  const RecordedRun done =
      run(scene, {}, [&](double, std::uint64_t) { return ++questions < most; });
  EXPECT_TRUE(done.complete()) << done.outcome.reason;
  EXPECT_LT(done.stats.flip_searches, most);
}

Scene with_burst(int maneuvers, double from, double step) {
  Scene scene = scene_of(100, 1, {disk(0, 0, 1, 0, 0), disk(20, 0, 1, 0, 0), disk(0, 20, 2, 1, 0)});
  for (int k = 1; k <= maneuvers; ++k) {
    scene.maneuvers.push_back({from + k * step, 0, Rational(k % 2 == 0 ? 1 : -1), Rational(1, 10)});
  }
  return scene;
}

TEST(LookAhead, IsLongAgainAfterABurstOfManeuvers) {
  expect_few_searches(with_burst(700, 0, 0x1p-17), 100'000);
  expect_few_searches(with_burst(3000, 0, 0x1p-17), 200'000);
  expect_few_searches(with_burst(3000, 0.5, 0x1p-40), 200'000);
}

// After its collisions every disk flies on for a time that is long beside them.
TEST(LookAhead, IsLongAgainAfterAnExplosion) {
  for (const double radius : {0x1p17, 0x1p27}) {
    Scene scene = scene_of(radius, radius / 8, {});
    std::mt19937 random(1);
    const auto part = [&random] { return static_cast<double>(random()) / 0x1p32; };
    for (int k = 0; k < 144; ++k) {
      const double x = 3 * (k % 12) + part() - 18, y = 3 * (k / 12) + part() - 18;
      scene.disks.push_back(disk(x, y, 1, 2 * part() - 1, 2 * part() - 1));
    }
    expect_few_searches(scene, 200'000);
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
