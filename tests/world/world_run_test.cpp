// The engine of worlds, against brute force, known histories, and itself in other units.
#include "engine/world/world_run.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "engine/world/moving_edge.h"
#include "tests/world/degenerate_worlds.h"
#include "tests/world/edge_set.h"
#include "tests/world/random_worlds.h"
#include "tests/world/world_oracle.h"
#include "tests/world/world_tools.h"

namespace voroproof::internal::testing {
namespace {

int number_from(const char* variable, int usual) {
  const char* given = std::getenv(variable);
  return given == nullptr ? usual : std::atoi(given);
}

class WorldRecorder : public WorldSink {
 public:
  void begin(const std::vector<Quad>& edges) override { initial = edges; }
  void event(const WorldEvent& event) override { events.push_back(event); }

  std::vector<Quad> initial;
  std::vector<WorldEvent> events;
};

struct RecordedWorld {
  WorldRecorder history;
  WorldOutcome outcome;
};
RecordedWorld record(const World& world, const WorldOptions& options = {}) {
  RecordedWorld run;
  run.outcome = run_world(world.motion(), options, run.history);
  return run;
}

// Why the run is wrong; empty if it is right. It may stop only where nobody decides what follows.
std::string fault(const World& world, const RecordedWorld& run, unsigned seed) {
  JudgeOptions options;
  options.seed = seed;
  if (run.outcome.kind != WorldOutcome::Kind::complete) {
    options.until = to_rational(run.outcome.t);
    const auto undecided = first_undecided(world);
    const std::string reason = run.outcome.reason + " at " + std::to_string(run.outcome.t);
    const bool stopped = run.outcome.kind == WorldOutcome::Kind::stopped;
    if (stopped && !undecided) return "it stopped: " + reason;
    if (undecided && run.outcome.t > round_nearest(*undecided)) return "it stopped late: " + reason;
  } else if (run.outcome.t != round_nearest(world.horizon)) {
    return "it ended at another time";
  }
  return first_disagreement(world, run.history.initial, run.history.events, options).value_or("");
}

using Counts = std::map<std::string, int>;
void count(const RecordedWorld& run, Counts& counts) {
  constexpr std::array names{"flip", "hide", "appear", "swap", "turn", "jump"};
  for (const WorldEvent& event : run.history.events) ++counts[names[event.what.index()]];
  ++counts[run.outcome.kind == WorldOutcome::Kind::complete ? "complete" : "stopped"];
}

// VOROPROOF_WORLDS: so many worlds of the family; VOROPROOF_WORLD_SEED: the first seed.
class RandomWorlds : public ::testing::TestWithParam<WorldFamily> {};

TEST_P(RandomWorlds, AreThoseOfBruteForce) {
  const int worlds = number_from("VOROPROOF_WORLDS", 25);
  const int first = number_from("VOROPROOF_WORLD_SEED", 1);
  Counts counts;
  for (int seed = first; seed < first + worlds; ++seed) {
    std::mt19937_64 random(static_cast<unsigned>(seed));
    const World world = random_world(GetParam(), random);
    const RecordedWorld run = record(world);
    count(run, counts);
    EXPECT_EQ(fault(world, run, static_cast<unsigned>(seed)), "") << "seed " << seed << "\n"
                                                                  << text(world);
  }
  for (const auto& [kind, n] : counts) RecordProperty(kind, n);
  EXPECT_GT(counts["complete"], worlds / 3);
  EXPECT_GT(counts["flip"], worlds / 3);
}

INSTANTIATE_TEST_SUITE_P(Families, RandomWorlds, ::testing::ValuesIn(world_families),
                         [](const auto& tested) { return name_of(tested.param); });

TEST(DegenerateWorlds, HaveTheirHistories) {
  for (const DegenerateWorld& scene : degenerate_worlds()) {
    SCOPED_TRACE(scene.name);
    const RecordedWorld run = record(scene.world);
    EXPECT_EQ(fault(scene.world, run, 1), "");
    if (scene.undecided) {
      EXPECT_EQ(run.outcome.kind, WorldOutcome::Kind::stopped);
      EXPECT_LE(run.outcome.t, round_nearest(*scene.undecided));
      EXPECT_GE(run.outcome.t, 0.75 * round_nearest(*scene.undecided));
      continue;
    }
    ASSERT_EQ(run.outcome.kind, WorldOutcome::Kind::complete) << run.outcome.reason;
    int flips = 0;
    std::string found, expected;
    const auto line = [](const ExpectedLine& l) {
      return std::to_string(round_nearest(l.t)) + " " + l.what + "\n";
    };
    for (const WorldEvent& event : run.history.events) {
      const auto seen = line_of(event);
      if (seen) found += line(*seen);
      flips += !seen;
    }
    if (scene.lines) {
      for (const ExpectedLine& l : *scene.lines) expected += line(l);
      EXPECT_EQ(found, expected);
    }
    if (scene.flips) {
      EXPECT_EQ(flips, *scene.flips);
    }
  }
}

// Two disks leave another at one place: what is told must be right, up to where the run stops.
TEST(WorldRun, DoesNotErrWhereTwoLeaveAnother) {
  World world;
  world.horizon = 2;
  for (const GrowingDisk& d :
       {GrowingDisk{0, 0, 5, 0, 0, 0}, GrowingDisk{3, 0, 1, 1, 0, 0},
        GrowingDisk{2, 1, 1, 2, -1, 0}, GrowingDisk{-12, 5, 1, 0, 0, 0},
        GrowingDisk{10, 8, 2, 0, Rational(1, 7), 0}, GrowingDisk{3, -13, 1, Rational(1, 9), 0, 0},
        GrowingDisk{-7, -9, 3, 0, 0, 0}}) {
    world.disks.push_back({0, {}, d});
  }
  const RecordedWorld run = record(world);
  JudgeOptions judge;
  if (run.outcome.kind != WorldOutcome::Kind::complete) judge.until = to_rational(run.outcome.t);
  EXPECT_GE(run.outcome.t, 1);
  const auto wrong = first_disagreement(world, run.history.initial, run.history.events, judge);
  EXPECT_EQ(wrong.value_or(""), "");
}

// The hull of three disks, at the instant at which a point on it touches the disk 1 from inside and
// the disk 2 has the same tangent line there, has two edges with 1, and one of them has a length.
TEST(MovingEdges, OfTwoWithOneNameOneHasNoLength) {
  for (const int side : {1, -1}) {
    for (const int radius : {6, 8, 11}) {
      MovingRows rows({}, 3, true);
      rows.set(0, 4, {side * 4, 12, 0, side, -1, 0});
      rows.set(1, 4, {side * 4, 4, 8, -side, -1, 0});
      rows.set(2, 4, {side * 28, 12 - radius, radius, side, 1, 0});
      const auto may_be_point = [&](GenId s, GenId e) {
        return MovingEdge(rows, side > 0 ? Quad{1, -1, s, e} : Quad{1, -1, e, s})
            .may_be_point_at(WorldTime(Rational(4)));
      };
      EXPECT_TRUE(may_be_point(2, 0)) << side << " " << radius;
      EXPECT_FALSE(may_be_point(0, 2)) << side << " " << radius;
    }
  }
}

// ---- One world in two ways. ----

// The times, and what happens.
std::vector<std::string> lines(const RecordedWorld& run) {
  std::vector<std::string> all{std::to_string(run.history.initial.size())};
  for (const Quad& q : run.history.initial) all.push_back(text(q));
  for (const WorldEvent& event : run.history.events) all.push_back(text(event));
  return all;
}

std::vector<World> worlds_of(WorldFamily family, int count) {
  std::vector<World> worlds;
  for (int seed = 1; seed <= count; ++seed) {
    std::mt19937_64 random(static_cast<unsigned>(1000 + seed));
    worlds.push_back(random_world(family, random));
  }
  return worlds;
}

TEST(WorldFilters, ChangeNothing) {
  WorldOptions exact;
  exact.filters = false;
  for (const WorldFamily family : world_families) {
    for (const World& world : worlds_of(family, 6)) {
      EXPECT_EQ(lines(record(world)), lines(record(world, exact))) << text(world);
    }
  }
}

TEST(WorldSymmetry, UnitsOfLengthDoNotMatter) {
  for (const WorldFamily family : world_families) {
    for (const World& world : worlds_of(family, 4)) {
      const RecordedWorld run = record(world);
      EXPECT_EQ(lines(run), lines(record(in_units(world, Rational(1, 3), 1)))) << text(world);
      EXPECT_EQ(lines(run), lines(record(in_units(world, 1024, 1)))) << text(world);
    }
  }
}

TEST(WorldSymmetry, OneRateOfAllDisksAndTheOppositeOfTheCircleDoNotMatter) {
  for (World world : worlds_of(WorldFamily::crossing_circle, 12)) {
    world.maneuvers.clear();
    World growing = world;
    const Rational rate = world.circle->radius / world.horizon / 8;
    growing.circle->growth -= rate;
    for (WorldDisk& disk : growing.disks) {
      disk.state.growth += rate;
      // As if it had been there from the start.
      disk.state.radius += rate * disk.enter;
    }
    EXPECT_EQ(lines(record(world)), lines(record(growing))) << text(world);
  }
}

TEST(WorldSymmetry, EqualRadiiAndRatesAreAsGoodAsPointsInThePlane) {
  for (World world : worlds_of(WorldFamily::equal_radii, 16)) {
    world.circle.reset();
    World points = world;
    for (WorldDisk& disk : points.disks) disk.state.radius = disk.state.growth = 0;
    EXPECT_EQ(lines(record(world)), lines(record(points))) << text(world);
  }
}

// Whether the run ended early, in the given way; what it told must be right up to its time.
bool expect_right_until(const World& world, const WorldOptions& options, WorldOutcome::Kind kind) {
  RecordedWorld run;
  run.outcome = run_world(world.motion(), options, run.history);
  if (run.outcome.kind == WorldOutcome::Kind::complete) return false;
  EXPECT_EQ(run.outcome.kind, kind) << run.outcome.reason;
  if (run.outcome.t == 0) return true;
  JudgeOptions judge;
  judge.until = to_rational(run.outcome.t);
  const auto wrong = first_disagreement(world, run.history.initial, run.history.events, judge);
  EXPECT_EQ(wrong.value_or(""), "") << text(world);
  return true;
}

TEST(WorldRun, IsRightUpToWhereItIsInterrupted) {
  int ended = 0;
  for (const World& world : worlds_of(WorldFamily::growing, 12)) {
    for (const int questions : {0, 1, 3, 10}) {
      int asked = 0;
      WorldOptions options;
      options.monitor = [&](double, std::uint64_t) { return asked++ < questions; };
      ended += expect_right_until(world, options, WorldOutcome::Kind::interrupted);
    }
  }
  RecordProperty("ended", ended);
}

TEST(WorldRun, IsRightUpToItsLimitOfEvents) {
  int ended = 0;
  for (const WorldFamily family : {WorldFamily::growing, WorldFamily::simultaneous}) {
    for (const World& world : worlds_of(family, 12)) {
      for (const int most : {1, 2, 5}) {
        WorldOptions options;
        options.max_events = static_cast<std::uint64_t>(most);
        ended += expect_right_until(world, options, WorldOutcome::Kind::stopped);
      }
    }
  }
  EXPECT_GT(ended, 20);
}

}  // namespace
}  // namespace voroproof::internal::testing
