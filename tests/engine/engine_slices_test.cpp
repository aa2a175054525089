// Runs in slices of time, on several threads, against runs of one thread.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <mutex>
#include <thread>

#include "corpus/generate.h"
#include "engine/leader.h"
#include "engine/slice.h"
#include "history/scene_motion.h"
#include "tests/support/random_scenes.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {
namespace {

// Slices of random lengths up to `most`.
EngineOptions sliced(int threads, std::uint64_t most, std::uint64_t seed,
                     const MotionOptions& motion = {}) {
  EngineOptions options;
  options.motion = motion;
  options.threads = threads;
  options.least_sliced = 0;
  const auto random = std::make_shared<Random>(seed);
  options.slice_hooks.work = [random, most](int) { return 1 + (*random)() % most; };
  return options;
}

// Returns the number of slices.
std::uint64_t expect_same(const RecordedRun& whole, const RecordedRun& run) {
  EXPECT_EQ(difference(whole, run), "");
  EXPECT_EQ(run.begins, 1);
  EXPECT_EQ(whole.outcome.t, run.outcome.t);
  EXPECT_EQ(whole.outcome.reason, run.outcome.reason);
  EXPECT_EQ(whole.outcome.events, run.outcome.events);
  EXPECT_EQ(whole.final_diagram, run.final_diagram);
  EXPECT_EQ(whole.stats.flips, run.stats.flips);
  EXPECT_EQ(whole.stats.disk_collisions, run.stats.disk_collisions);
  EXPECT_EQ(whole.stats.wall_collisions, run.stats.wall_collisions);
  EXPECT_EQ(whole.stats.maneuvers, run.stats.maneuvers);
  EXPECT_EQ(whole.stats.ties, run.stats.ties);
  EXPECT_EQ(whole.stats.settling_flips, run.stats.settling_flips);
  EXPECT_EQ(whole.stats.highest_bits, run.stats.highest_bits);
  EXPECT_EQ(whole.stats.end, run.stats.end);
  return run.stats.slices;
}

// The least number of slices of a few runs with 2 to 8 threads.
std::uint64_t expect_same(const Scene& scene, std::uint64_t most,
                          const MotionOptions& motion = {}) {
  const RecordedRun whole = run(scene, motion);
  std::uint64_t slices = ~std::uint64_t{0};
  for (const int threads : {2, 3, 4, 8}) {
    const RecordedRun parts = run_with(scene, sliced(threads, most, threads, motion));
    slices = std::min(slices, expect_same(whole, parts));
    if (::testing::Test::HasFailure()) break;
  }
  return slices;
}

Scene reference(int n, double density, double horizon, double restitution = 1) {
  ReferenceOptions options;
  options.n = n;
  options.density = density;
  options.horizon = horizon;
  options.restitution = restitution;
  return generate_reference(options);
}

TEST(EngineSlices, Reference) {
  for (const double density : {0.05, 0.4}) {
    EXPECT_GE(expect_same(reference(60, density, 100), 40), 3u);
    EXPECT_GE(expect_same(reference(200, density, 40), 10), 10u);
  }
}

TEST(EngineSlices, LawsAndManeuvers) {
  Random random(6);
  for (int k = 0; k < 9; ++k) {
    Scene scene = random_scene({.n = 20, .rmin = 3, .rmax = 12, .maneuvers = 3 * k}, random);
    if (k % 3 == 1) scene.restitution = Rational(4, 5);
    if (k % 3 == 2) scene.law = ContainerLaw::whole;
    if (k % 3 == 2) scene.container_restitution = Rational(9, 10);
    EXPECT_GE(expect_same(scene, 5), 2u) << k;
  }
}

TEST(EngineSlices, NobodyMoves) {
  Random random(7);
  Scene scene = random_scene({.n = 20, .speed = 0}, random);
  EXPECT_EQ(expect_same(scene, 5), 1u);
  scene.maneuvers.push_back({3, 4, Rational(1), Rational(2)});
  EXPECT_GE(expect_same(scene, 1), 2u);
}

TEST(EngineSlices, FewDisksAndEventsAtZeroAndAtTheHorizon) {
  expect_same(scene_of(10, 30, {}), 1);
  expect_same(scene_of(10, 30, {disk(0, 0, 1, 1, 0)}), 1);
  expect_same(scene_of(10, 30, {disk(-3, 0, 1, 1, 0), disk(3, 0, 1, -1, 0)}), 1);
  // Three touch at 0; one reaches the wall at the horizon.
  expect_same(scene_of(10, 8, {disk(-1, 0, 1, 1, 0), disk(1, 0, 1, -1, 0), disk(3, 0, 1, -1, 0)}),
              1);
}

TEST(EngineSlices, Points) {
  Random random(8);
  for (int k = 0; k < 3; ++k) {
    expect_same(random_scene({.n = 15, .rmin = 0, .rmax = 0}, random), 3);
  }
}

TEST(EngineSlices, TiesAndMirrorSymmetry) {
  GridOptions options;
  options.n = 25;
  options.spacing = 2.5;
  options.horizon = 20;
  for (const auto motion : {GridOptions::Motion::random, GridOptions::Motion::shear,
                            GridOptions::Motion::common, GridOptions::Motion::rest}) {
    options.motion = motion;
    expect_same(generate_grid(options), 6);
  }
}

TEST(EngineSlices, SwarmsAndFormations) {
  SwarmOptions swarm;
  swarm.n = 20;
  expect_same(generate_swarm(swarm), 6);
  for (const char* name : {"figure24", "h-to-y"}) {
    expect_same(generate_formation(formation_preset(name)), 10);
  }
}

// Slices end at flips, wherever the time of one is a binary64: these belong to the slice before.
TEST(EngineSlices, BordersAtFlips) {
  // They fly in a row past the others, and cross lines of symmetry at whole times.
  Scene scene = scene_of(40, 30, {});
  for (int k = 0; k < 4; ++k) {
    scene.disks.push_back(disk(-30 + 4 * k, 0, 1, 1, 0));
    scene.disks.push_back(disk(6 * k - 10, 8, 1, 0, 0));
    scene.disks.push_back(disk(6 * k - 10, -8, 1, 0, 0));
  }
  for (int k = 1; k < 15; ++k) {
    scene.maneuvers.push_back({2 * k, 1, Rational(k % 2, 64), Rational(0)});
  }
  const RecordedRun whole = run(scene);
  ASSERT_TRUE(whole.complete());
  std::atomic<int> at_flips = 0;
  EngineOptions options = sliced(2, 1, 1);
  options.slice_hooks.border = [&](double after, double before) {
    for (const Event& e : whole.events) {
      if (e.kind == Event::Kind::flip && after < e.t && e.t < before && e.t == std::round(e.t)) {
        ++at_flips;
        return e.t;
      }
    }
    return 0.5 * (after + before);
  };
  const RecordedRun parts = run_with(scene, options);
  EXPECT_GE(at_flips, 5);
  EXPECT_GE(expect_same(whole, parts), 10u);
}

// A slice ends at no time that an instant's enclosure has.
TEST(EngineSlices, NoBorderWhereAnInstantMayBe) {
  ReferenceOptions scene_options;
  scene_options.n = 30;
  scene_options.horizon = 50;
  const Scene scene = generate_reference(scene_options);
  const RecordedRun whole = run(scene);
  for (const bool first : {true, false}) {
    EngineOptions options = sliced(2, 1, 1);
    options.slice_hooks.border = [first](double after, double before) {
      return first ? after : before;
    };
    EXPECT_EQ(expect_same(whole, run_with(scene, options)), 1u);
  }
}

// Collisions at right angles and cradles at one instant, a maneuver at that of a collision.
TEST(EngineSlices, InstantsOfManyEvents) {
  Scene cradle = scene_of(20, 40,
                          {disk(-6, 0, 1, 1, 0), disk(0, 0, 1, 0, 0), disk(6, 0, 1, -1, 0),
                           disk(0, 6, 1, 0, -1), disk(0, -6, 1, 0, 1)});
  expect_same(cradle, 1);
  cradle.maneuvers.push_back({4, 1, Rational(1, 2), Rational(1, 3)});
  cradle.maneuvers.push_back({4, 3, Rational(0), Rational(1)});
  expect_same(cradle, 1);
}

// At the wall, which is proved, and of a disk between two others, by the rule.
TEST(EngineSlices, Collapse) {
  Scene wall = reference(60, 0.2, 300);
  wall.container_restitution = Rational(1, 4);
  Scene between = scene_of(50, 100,
                           {disk(-10, 0, 1, 1, 0), disk(1, Rational(1, 100), 1, 0, 0),
                            disk(11, Rational(-1, 50), 1, -1, Rational(1, 1000))});
  between.restitution = Rational(1, 20);
  for (const Scene& scene : {wall, between}) {
    const RecordedRun whole = run(scene);
    EXPECT_EQ(whole.outcome.reason.find("inelastic collapse"), 0u) << whole.outcome.reason;
    expect_same(scene, 20);
  }
}

TEST(EngineSlices, StopsOfTheBudget) {
  const Scene scene = reference(30, 0.4, 300);
  for (const int bits : {192, 320, 704}) {
    MotionOptions options;
    options.max_bits = bits;
    EXPECT_EQ(run(scene, options).outcome.kind, Outcome::Kind::stopped);
    expect_same(scene, 30, options);
  }
}

TEST(EngineSlices, MoreEventsThanAllowed) {
  const Scene scene = reference(60, 0.2, 60);
  EngineOptions options;
  for (const std::uint64_t most : {1, 50, 333}) {
    options.max_events = most;
    const RecordedRun whole = run_with(scene, options);
    EXPECT_EQ(whole.outcome.kind, Outcome::Kind::stopped);
    EngineOptions parts = sliced(3, 20, 1);
    parts.max_events = most;
    expect_same(whole, run_with(scene, parts));
  }
}

// What is told before an interruption are whole instants of the whole history.
TEST(EngineSlices, Interruption) {
  const Scene scene = reference(60, 0.2, 60);
  const RecordedRun whole = run(scene);
  for (const std::uint64_t after : {0, 1, 100, 400}) {
    EngineOptions options = sliced(2, 20, 1);
    options.monitor = [after](double, std::uint64_t events) { return events < after; };
    RecordedRun run = run_with(scene, options);
    EXPECT_EQ(run.outcome.kind, Outcome::Kind::interrupted);
    EXPECT_EQ(run.outcome.reason, "interrupted");
    EXPECT_GE(run.events.size(), after);
    ASSERT_LT(run.events.size(), whole.events.size());
    EXPECT_EQ(run.outcome.t, run.events.empty() ? 0 : run.events.back().t);
    EXPECT_EQ(run.stats.flip_count(), run.count(Event::Kind::flip));
    EXPECT_EQ(run.stats.disk_collisions + run.stats.wall_collisions,
              run.count(Event::Kind::collision));
    RecordedRun begin = whole;
    begin.events.resize(run.events.size());
    if (run.initial.empty()) run.initial = whole.initial;  // interrupted before
    run.outcome.kind = whole.outcome.kind;
    EXPECT_EQ(difference(begin, run), "");
  }
}

// A slice whose first diagram is not the last one of the slice before is not told.
TEST(EngineSlices, ThatDoNotJoin) {
  const Scene scene = reference(60, 0.2, 60);
  const RecordedRun whole = run(scene);
  for (const int wrong : {1, 5}) {
    EngineOptions options = sliced(2, 20, 1);
    options.slice_hooks.diagram = [wrong](int slice, Diagram& diagram) {
      if (slice != wrong) return;
      int e = 0;
      while (diagram.apex(2 * e) == diagram.apex(2 * e + 1)) ++e;
      diagram.flip(2 * e);
    };
    EXPECT_EQ(expect_same(whole, run_with(scene, options)), 0u);
  }
}

// The first slices are short, and the last ones the more so the more threads there are; the run's
// own lengths lead to its horizon.
TEST(EngineSlices, AreShorterAtBothEnds) {
  constexpr int disks = 100;
  const auto work = [](int slice, double ahead, int threads) {
    return static_cast<double>(work_of_slice(slice, disks * ahead, disks, threads)) / disks;
  };
  EXPECT_LT(work(0, 50, 2), work(1, 48.5, 2));
  EXPECT_LT(work(1, 48.5, 2), work(5, 40, 2));
  double shortest = 4;
  for (const int threads : {2, 4, 8, 16, 64}) {
    if (threads <= 8) {
      EXPECT_EQ(work(5, 40, threads), 4);
    }
    EXPECT_LE(work(5, 10, threads), shortest) << threads;
    shortest = work(5, 10, threads);
    double ahead = 40, last = 4;
    int slice = 5;
    while (ahead > 0) {
      const double w = std::min(ahead, work(slice++, ahead, threads));
      EXPECT_LE(w, std::max(last, 2.0)) << threads;
      EXPECT_GE(w, std::min(ahead, 1.0)) << threads;
      last = w;
      ahead -= w;
    }
    EXPECT_LE(slice, 50);
  }
  EXPECT_LT(shortest, 2);
}

// Two threads have something to do in a run of a flip a disk; shorter ones are not worth it.
TEST(EngineSlices, ShortRunsHaveTwo) {
  constexpr int disks = 1000;
  const auto first = [](double ahead) {
    return static_cast<double>(work_of_slice(0, disks * ahead, disks, 2)) / disks;
  };
  for (const double ahead : {1.1, 1.5, 2.0}) {
    EXPECT_GT(first(ahead), 0.5 * ahead) << ahead;
    EXPECT_LT(first(ahead), 0.8 * ahead) << ahead;
  }
  // Nothing is left over where more happens than was expected.
  EXPECT_GT(first(0.6), 1.2);
}

// What is to come is estimated well enough for that, before a run begins and within it.
TEST(EngineSlices, WorkAheadIsEstimated) {
  const Scene scene = reference(300, 0.05, 60);
  Leader leader(motion_input(scene), {}, MotionOptions());
  const double expected = leader.work_ahead();
  LedTurns turns;
  ASSERT_TRUE(leader.lead(turns, 200, nullptr));
  const double later = leader.work_ahead();
  EXPECT_GT(expected, 0.7 * (200 + later));
  EXPECT_LT(expected, 1.2 * (200 + later));
  ASSERT_TRUE(leader.lead(turns, 300, nullptr));
  EXPECT_NEAR(later - leader.work_ahead(), 300, 100);
  ASSERT_FALSE(leader.lead(turns, 1000000, nullptr));
  EXPECT_NEAR(leader.work_ahead(), 0, 1);
}

// Threads that are late make no difference.
TEST(EngineSlices, Delays) {
  const Scene scene = reference(60, 0.2, 60);
  const RecordedRun whole = run(scene);
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    EngineOptions options = sliced(2 + seed % 3, 15, seed);
    const auto random = std::make_shared<Random>(seed);
    const auto mutex = std::make_shared<std::mutex>();
    options.slice_hooks.pause = [random, mutex] {
      std::unique_lock lock(*mutex);
      const std::chrono::microseconds time((*random)() % 4 == 0 ? (*random)() % 3000 : 0);
      lock.unlock();
      std::this_thread::sleep_for(time);
    };
    EXPECT_GE(expect_same(whole, run_with(scene, options)), 10u);
  }
}

TEST(EngineSlices, WithoutFilters) {
  MotionOptions options;
  options.filters = false;
  EXPECT_GE(expect_same(reference(12, 0.2, 40), 4, options), 2u);
}

}  // namespace
}  // namespace voroproof::internal::testing
