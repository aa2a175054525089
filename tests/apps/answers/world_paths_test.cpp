// The clearance of worlds against sampling.
#include "apps/answers/world_paths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "library/planning/given_clearance.h"

namespace voroproof::internal {
namespace {

class RandomWorld {
 public:
  explicit RandomWorld(unsigned seed) : random_(seed) {
    world_.horizon = 4;
    for (int g = 0; g < 4; ++g) {
      WorldDisk disk{Rational(integer(0, 3)) / 2, {}, state()};
      if (integer(0, 2) == 0) disk.leave = disk.enter + Rational(integer(1, 6)) / 2;
      world_.disks.push_back(disk);
    }
    for (int k = 1; k < 16; ++k) {
      WorldManeuver m{Rational(k) / 4, integer(0, 3), {}, {}, {}, {}};
      const WorldDisk& disk = world_.disks[static_cast<std::size_t>(m.disk)];
      if (m.t <= disk.enter || (disk.leave && m.t >= *disk.leave)) continue;
      const GrowingDisk next = state();
      if (integer(0, 1) == 0) m.growth = next.growth;
      if (integer(0, 1) == 0) m.velocity = Point2{next.vx, next.vy};
      if (integer(0, 3) == 0) m.center = Point2{next.x, next.y};
      if (integer(0, 3) == 0) m.radius = next.radius;
      if (m.growth || m.velocity || m.center || m.radius) world_.maneuvers.push_back(m);
    }
  }
  const World& world() const { return world_; }

 private:
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  GrowingDisk state() {
    return {integer(-6, 6), integer(-6, 6), integer(0, 4),
            integer(-4, 4), integer(-4, 4), Rational(integer(-2, 2)) / 3};
  }

  std::mt19937_64 random_;
  World world_;
};

double gap_of(const GrowingDisk& a, const GrowingDisk& b) {
  return std::hypot(Rational(b.x - a.x).get_d(), Rational(b.y - a.y).get_d()) -
         Rational(a.radius + b.radius).get_d();
}

TEST(ClearanceOfWorlds, AsSamplingFinds) {
  int pairs = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const World world = RandomWorld(seed).world();
    const WorldMotion motion = world.motion();
    const GivenPaths given = world_paths(world);
    const GivenClearance clearance(given, [] { return true; });
    const auto least = clearance.least();
    double sampled = HUGE_VAL;
    const auto sample = [&](const Rational& t) {
      for (std::size_t i = 0; i < motion.paths.size(); ++i) {
        for (std::size_t j = i + 1; j < motion.paths.size(); ++j) {
          const auto a = state_at(motion.paths[i], t), b = state_at(motion.paths[j], t);
          if (a && b) sampled = std::min(sampled, gap_of(*a, *b));
        }
      }
    };
    for (int k = 0; k <= 1000; ++k) sample(Rational(k) / 250);
    ASSERT_EQ(least.has_value(), sampled < HUGE_VAL) << seed;
    if (!least) continue;
    ++pairs;
    const double told = gap(*least).lo;
    EXPECT_LE(told, sampled + 1e-12) << seed;
    // At the told time, or just before it where it is only approached.
    sample(least->is_reached ? least->t : Rational(least->t - Rational(1, 1 << 30)));
    EXPECT_NEAR(told, sampled, 1e-6) << seed;
    EXPECT_EQ(keeps_clear(*least, to_rational(told - 1e-9)), true) << seed;
    EXPECT_EQ(falls_short(*least, to_rational(told + 1e-9), Touching::is_too_near), true) << seed;
  }
  EXPECT_GT(pairs, 40);
}

}  // namespace
}  // namespace voroproof::internal
