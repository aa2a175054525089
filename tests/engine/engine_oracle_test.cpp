// The engine's histories of random scenes against the oracles.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/support/compact_arithmetic.h"
#include "tests/support/history_check.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
namespace {

struct Totals {
  CheckCounts seen;
  std::size_t flips = 0, collisions = 0, maneuvers = 0;
};

// Runs and checks `scenes` scenes; every one must be right.
Totals expect_right(int scenes, std::uint64_t seed, const std::function<Scene(Random&)>& make,
                    const HistoryCheck& check = {}) {
  Random random(seed);
  Totals totals;
  for (int k = 0; k < scenes; ++k) {
    const Scene scene = make(random);
    EXPECT_TRUE(is_acceptable(scene)) << text(scene);
    const RecordedRun history = run(scene);
    const std::string fault = check_history(scene, history, check, &totals.seen);
    EXPECT_EQ(fault, "") << text(scene);
    totals.flips += history.count(Event::Kind::flip);
    totals.collisions += history.count(Event::Kind::collision);
    totals.maneuvers += history.count(Event::Kind::maneuver);
  }
  EXPECT_EQ(totals.seen.skipped, 0);
  return totals;
}

Totals expect_right(int scenes, std::uint64_t seed, const RandomScene& options,
                    const HistoryCheck& check = {}) {
  return expect_right(
      scenes, seed, [&](Random& random) { return random_scene(options, random); }, check);
}

TEST(EngineAgainstOracles, FewDisks) {
  for (int n : {0, 1, 2, 3}) {
    const RandomScene options{.n = n, .rmin = 1, .rmax = 20, .horizon = 100};
    const Totals totals = expect_right(6, 10 + static_cast<std::uint64_t>(n), options);
    if (n > 0) {
      EXPECT_GT(totals.collisions, 6u);
    }
    if (n > 1) {
      EXPECT_GT(totals.seen.brute_force, 10);
    }
    if (n > 2) {
      EXPECT_GT(totals.flips, 10u);
    }
  }
}

TEST(EngineAgainstOracles, ManyKindsOfRadii) {
  for (const auto& [rmin, rmax] :
       {std::pair(2.0, 8.0), std::pair(1e-4, 15.0), std::pair(5.0, 5.0), std::pair(4.0, 4.0 + 1e-9),
        std::pair(1e-9, 1e-9), std::pair(0.0, 0.0)}) {
    const Totals totals =
        expect_right(4, 20, RandomScene{.n = 10, .rmin = rmin, .rmax = rmax, .horizon = 30});
    EXPECT_GT(totals.flips, 40u);
    EXPECT_GT(totals.seen.brute_force, 8);
    EXPECT_GT(totals.seen.cgal, 4);
    EXPECT_GT(totals.seen.flip_times, 30);
  }
}

TEST(EngineAgainstOracles, TwentyDisks) {
  const Totals totals = expect_right(3, 30, RandomScene{.n = 20, .horizon = 25});
  EXPECT_GT(totals.flips, 100u);
  EXPECT_GT(totals.seen.brute_force, 8);
}

TEST(EngineAgainstOracles, Dense) {
  for (double density : {0.3, 0.5}) {
    const Totals totals = expect_right(
        2, 40, RandomScene{.n = 12, .rmin = 5, .rmax = 15, .horizon = 12, .density = density});
    EXPECT_GT(totals.collisions, 20u);
  }
}

TEST(EngineAgainstOracles, TinyBesideHuge) {
  const auto make = [](Random& random) {
    Scene scene =
        random_scene({.n = 9, .rmin = 1e-3, .rmax = 0.1, .speed = 10, .horizon = 10}, random);
    // One disk that fills much of the container would not find its place last.
    Scene big = random_scene({.n = 1, .rmin = 45, .rmax = 55, .horizon = 10}, random);
    big.cx = scene.cx;
    big.cy = scene.cy;
    big.disks[0].x = Rational(scene.cx + 30);
    big.disks[0].y = Rational(scene.cy - 20);
    std::erase_if(scene.disks, [&](const DiskInput& d) {
      const Rational dx = d.x - big.disks[0].x, dy = d.y - big.disks[0].y;
      return dx * dx + dy * dy < 58 * 58;
    });
    scene.disks.push_back(big.disks[0]);
    return scene;
  };
  const Totals totals = expect_right(6, 50, make);
  EXPECT_GT(totals.flips, 10u);
}

TEST(EngineAgainstOracles, Maneuvers) {
  const Totals totals = expect_right(4, 60, RandomScene{.n = 8, .horizon = 30, .maneuvers = 20});
  EXPECT_EQ(totals.maneuvers, 80u);
}

TEST(EngineAgainstOracles, RestitutionBetweenDisks) {
  const auto make = [](Random& random) {
    Scene scene =
        random_scene({.n = 8, .rmin = 5, .rmax = 15, .horizon = 25, .density = 0.2}, random);
    scene.restitution = Rational(3, 5);
    return scene;
  };
  EXPECT_GT(expect_right(4, 70, make).collisions, 40u);
}

TEST(EngineAgainstOracles, RestitutionOfTheContainer) {
  for (const ContainerLaw law : {ContainerLaw::normal, ContainerLaw::whole}) {
    const auto make = [law](Random& random) {
      Scene scene = random_scene({.n = 5, .rmin = 3, .rmax = 12, .horizon = 60}, random);
      scene.container_restitution = Rational(4, 5);
      scene.law = law;
      return scene;
    };
    EXPECT_GT(expect_right(3, 80, make).collisions, 15u);
  }
}

TEST(EngineAgainstOracles, MassesOfTheirOwn) {
  const auto make = [](Random& random) {
    Scene scene =
        random_scene({.n = 8, .rmin = 5, .rmax = 15, .horizon = 25, .density = 0.2}, random);
    for (DiskInput& d : scene.disks) d.mass = uniform(random, 0.01, 100);
    return scene;
  };
  EXPECT_GT(expect_right(3, 90, make).collisions, 20u);
}

// G. Galperin, Playing pool with pi: between a wall and a disk 100^n times as heavy, a disk
// collides as often as the first n + 1 digits of pi say. All states are rational, and longer after
// each.
TEST(EngineAgainstOracles, CollisionsThatCountTheDigitsOfPi) {
  const std::vector<std::pair<int, std::size_t>> counts{{1, 3}, {100, 31}, {10000, 314}};
  for (const auto& [mass, collisions] : counts) {
    Scene scene = scene_of(100, 100, {disk(-90, 0, 1, 0, 0), disk(-80, 0, 1, -1, 0)});
    scene.disks[0].mass = 1;
    scene.disks[1].mass = mass;
    const RecordedRun counted = run(scene);
    EXPECT_TRUE(counted.complete());
    EXPECT_EQ(counted.count(Event::Kind::collision), collisions);
  }
}

// A ring of disks that all touch a middle one, exactly, and the container or not; radii such
// that lattice directions (3,4,5), (5,12,13) and so on make every contact rational.
Scene touching_ring(Random& random) {
  struct PythagoreanTriple {
    int x, y, length;
  };
  const std::vector<PythagoreanTriple> directions{{3, 4, 5},    {-4, 3, 5},  {-5, -12, 13},
                                                  {12, -5, 13}, {8, 15, 17}, {-15, 8, 17},
                                                  {0, -1, 1},   {1, 0, 1}};
  Scene scene = scene_of(40, 20, {disk(0, 0, 8, 0, 0)});
  const auto velocity = [&random] {
    return std::pair<Rational, Rational>(static_cast<int>(random() % 7) - 3,
                                         static_cast<int>(random() % 7) - 3);
  };
  std::tie(scene.disks[0].vx, scene.disks[0].vy) = velocity();
  for (const auto& [x, y, length] : directions) {
    Rational r(static_cast<int>(1 + random() % 8), 4);
    r.canonicalize();
    const Rational scale = (8 + r) / length;
    const auto v = velocity();
    Scene more = scene;
    more.disks.push_back(disk(x * scale, y * scale, r, v.first, v.second));
    if (is_acceptable(more)) scene = more;
  }
  return scene;
}

TEST(EngineAgainstOracles, TouchingAtTheStart) {
  const Totals totals = expect_right(4, 100, touching_ring);
  EXPECT_GT(totals.collisions, 20u);
}

TEST(EngineAgainstOracles, HorizonZero) {
  const auto make = [](Random& random) {
    Scene scene = touching_ring(random);
    scene.horizon = 0;
    return scene;
  };
  Random random(7);
  std::size_t collisions = 0;
  for (int k = 0; k < 5; ++k) {
    const Scene scene = make(random);
    const RecordedRun history = run(scene);
    EXPECT_EQ(check_history(scene, history), "") << text(scene);
    for (const Event& e : history.events) EXPECT_EQ(e.t, 0);
    collisions += history.count(Event::Kind::collision);
    EXPECT_EQ(history.initial.size(), 3 * (scene.disks.size() + 1) - 6);
  }
  EXPECT_GT(collisions, 5u);
}

TEST(EngineAgainstOracles, LargeAndSmallUnits) {
  for (int exponent : {-200, 200}) {
    const auto make = [exponent](Random& random) {
      Scene scene = random_scene({.n = 7, .horizon = 60}, random);
      Rational factor = 1;
      if (exponent > 0) {
        factor <<= static_cast<unsigned long>(exponent);
      } else {
        factor >>= static_cast<unsigned long>(-exponent);
      }
      for (Rational* length : {&scene.cx, &scene.cy, &scene.container_radius}) *length *= factor;
      for (DiskInput& d : scene.disks) {
        for (CompactRational* length : {&d.x, &d.y, &d.radius, &d.vx, &d.vy}) *length *= factor;
        d.mass *= Rational(factor * factor);
      }
      return scene;
    };
    Random random(5);
    Random same(5);
    const Scene scaled = make(random), plain = random_scene({.n = 7, .horizon = 60}, same);
    // A power of two changes no event and no time.
    const RecordedRun a = run(scaled), b = run(plain);
    EXPECT_EQ(names(a), names(b));
    ASSERT_EQ(a.events.size(), b.events.size());
    EXPECT_GT(a.events.size(), 10u);
    for (std::size_t k = 0; k < a.events.size(); ++k) EXPECT_EQ(a.events[k].t, b.events[k].t);
  }
}

// The checker itself: each damage to a right history is found.
TEST(HistoryCheck, FindsDamage) {
  Random random(3);
  const Scene scene = random_scene({.n = 8, .horizon = 30, .maneuvers = 5}, random);
  const RecordedRun right = run(scene);
  const HistoryCheck everywhere{.brute_force_instants = 10, .legality_instants = 1000};
  ASSERT_EQ(check_history(scene, right, everywhere), "");
  std::size_t damages = 0;
  const auto expect_found = [&](const RecordedRun& damaged) {
    EXPECT_NE(check_history(scene, damaged, everywhere), "");
    ++damages;
  };
  for (std::size_t k = 0; k < right.events.size(); ++k) {
    const Event& e = right.events[k];
    RecordedRun damaged = right;
    damaged.events[k].t = std::nextafter(e.t, 1e9);
    expect_found(damaged);
    damaged = right;
    damaged.events.erase(damaged.events.begin() + static_cast<long>(k));
    expect_found(damaged);
    if (k + 1 < right.events.size() && e.kind != Event::Kind::flip) {
      damaged = right;
      damaged.events[k].first.px = std::nextafter(e.first.px, 1e9);
      if (e.i != container_id) expect_found(damaged);
    }
    if (e.kind == Event::Kind::collision) {
      damaged = right;
      damaged.events[k].second.vy = std::nextafter(e.second.vy, 1e9);
      expect_found(damaged);
    }
    if (e.kind == Event::Kind::flip) {
      damaged = right;
      damaged.events[k].edge = canonical(flipped(e.edge));
      expect_found(damaged);
    }
  }
  EXPECT_GT(damages, 60u);
  RecordedRun damaged = right;
  damaged.final_diagram = right.initial;
  expect_found(damaged);
  damaged = right;
  damaged.initial = right.final_diagram;
  expect_found(damaged);
}

}  // namespace
}  // namespace voroproof::internal::testing
