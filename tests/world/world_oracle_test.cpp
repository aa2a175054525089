// The judge of worlds against histories that are found by looking, and against wrong ones.
#include "tests/world/world_oracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <variant>

#include "tests/world/edge_set.h"
#include "tests/world/random_worlds.h"
#include "tests/world/sampled_history.h"
#include "tests/world/world_tools.h"

namespace voroproof::internal::testing {
namespace {

// In which things happen at different times.
constexpr std::array general_families{WorldFamily::overlapping, WorldFamily::growing,
                                      WorldFamily::equal_radii, WorldFamily::points,
                                      WorldFamily::nested,      WorldFamily::crossing_circle};

// Two disks of one radius meet at (x, y), at a time from 1 to 2, among others.
World world_of_swap(std::mt19937_64& random) {
  World world = random_world(WorldFamily::growing, random);
  while (world.horizon != 5 || world.disks.size() > 4) {
    world = random_world(WorldFamily::growing, random);
  }
  const auto draw = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
  };
  const Rational t(draw(33, 64), 32), x = draw(-20, 20), y = draw(-20, 20), r = draw(5, 9);
  for (int k = 0; k < 2; ++k) {
    const Rational vx = draw(-64, 64) / Rational(16), vy = draw(-64, 64) / Rational(16);
    const Rational growth = draw(-8, 8) / Rational(16);
    world.disks.push_back({0, {}, {x - vx * t, y - vy * t, r - growth * t, vx, vy, growth}});
  }
  make_valid(world);
  return world;
}

const char* kind_of(const WorldEvent& event) {
  constexpr std::array names{"flip", "hide", "appear", "swap", "turn", "jump"};
  return names[event.what.index()];
}

using Counts = std::map<std::string, int>;
void count(const SampledHistory& history, Counts& counts) {
  for (const WorldEvent& event : history.events) {
    ++counts[kind_of(event)];
    const auto* jump = std::get_if<Jump>(&event.what);
    if (jump == nullptr) continue;
    for (const auto* steps : {&jump->out, &jump->in}) {
      if (*steps) counts["steps"] += static_cast<int>((**steps).size());
    }
  }
}

void expect_right(const World& world, int samples, Counts& counts) {
  const SampledHistory history = sampled_history(world, samples);
  ASSERT_EQ(history.why_not, "") << text(world);
  const auto wrong = first_disagreement(world, history.initial, history.events);
  EXPECT_EQ(wrong.value_or(""), "") << text(world);
  count(history, counts);
}

TEST(WorldOracle, AgreesWithHistoriesFoundByLooking) {
  std::mt19937_64 random(1);
  Counts counts;
  for (int k = 0; k < 10; ++k) {
    for (const WorldFamily family : general_families) {
      expect_right(random_world(family, random), 40, counts);
    }
  }
  for (const char* kind : {"flip", "hide", "appear"}) EXPECT_GE(counts[kind], 40) << kind;
}

TEST(WorldOracle, AgreesWithSwaps) {
  std::mt19937_64 random(2);
  Counts counts;
  for (int k = 0; k < 60; ++k) expect_right(world_of_swap(random), 20, counts);
  EXPECT_GE(counts["swap"], 30);
}

// Disks jump, turn, come and go, each at a time of its own.
World world_of_jumps(std::mt19937_64& random) {
  World world = random_world(WorldFamily::overlapping, random);
  for (int g = 0; g < static_cast<int>(world.disks.size()); ++g) {
    const Rational t = world.horizon * Rational(2 * g + 1, 29);
    const GrowingDisk& s = world.disks[g].state;
    if (g % 4 == 0) world.maneuvers.push_back({t, g, Point2{s.y, s.x}, {}, s.radius / 2, {}});
    if (g % 4 == 1) world.disks[g].enter = t;
    if (g % 4 == 2) world.disks[g].leave = t;
    if (g % 4 == 3) world.maneuvers.push_back({t, g, {}, Point2{s.vy, s.vx}, {}, {}});
  }
  return world;
}

TEST(WorldOracle, AgreesWithJumpsAsRunsOfTheRadius) {
  std::mt19937_64 random(3);
  Counts counts;
  for (int k = 0; k < 20; ++k) expect_right(world_of_jumps(random), 40, counts);
  EXPECT_GE(counts["jump"], 60);
  EXPECT_GE(counts["turn"], 12);
  EXPECT_GE(counts["steps"], 300);
}

// ---- Wrong histories. ----

double next_to(const Rational& t, double towards) {
  return std::nextafter(round_nearest(t), towards);
}

struct JudgedWorld {
  World world;
  SampledHistory history;
};
const std::vector<JudgedWorld>& judged_worlds() {
  static const std::vector<JudgedWorld> all = [] {
    std::vector<JudgedWorld> worlds;
    std::mt19937_64 random(7);
    for (int k = 0; k < 3; ++k) {
      for (const WorldFamily family : general_families) {
        const World world = random_world(family, random);
        if (world.disks.size() <= 8) worlds.push_back({world, sampled_history(world, 40)});
      }
    }
    return worlds;
  }();
  return all;
}

const JudgeOptions no_random_times{std::nullopt, 0, 1};

// Calls `spoil` with each event of each history; where it returns true, the history must not pass.
template <class Spoil>
void expect_told(int least, const Spoil& spoil) {
  int tried = 0;
  for (const auto& [world, history] : judged_worlds()) {
    ASSERT_EQ(history.why_not, "");
    for (std::size_t at = 0; at < history.events.size(); ++at) {
      std::vector<WorldEvent> events = history.events;
      if (!spoil(events, at)) continue;
      ++tried;
      EXPECT_TRUE(first_disagreement(world, history.initial, events, no_random_times))
          << text(history.events[at]) << text(world);
    }
  }
  EXPECT_GE(tried, least);
}

using Events = std::vector<WorldEvent>;

TEST(WrongHistory, WithoutAnEvent) {
  expect_told(60, [](Events& events, std::size_t at) {
    events.erase(events.begin() + static_cast<std::ptrdiff_t>(at));
    return true;
  });
}

TEST(WrongHistory, ATimeTwoUnitsInTheLastPlaceTooLate) {
  constexpr double far = std::numeric_limits<double>::infinity();
  expect_told(60, [](Events& events, std::size_t at) {
    Rational& t = events[at].t;
    t = to_rational(next_to(to_rational(next_to(t, far)), far));
    return at + 1 == events.size() || t < events[at + 1].t;
  });
}

TEST(WrongHistory, ATimeTwoUnitsInTheLastPlaceTooEarly) {
  expect_told(60, [](Events& events, std::size_t at) {
    Rational& t = events[at].t;
    t = to_rational(next_to(to_rational(next_to(t, 0)), 0));
    return at == 0 || events[at - 1].t < t;
  });
}

TEST(WrongHistory, AnotherHost) {
  expect_told(5, [](Events& events, std::size_t at) {
    auto* h = std::get_if<Hide>(&events[at].what);
    if (h == nullptr) return false;
    h->j = h->j != container_id ? container_id : h->g == 0 ? 1 : 0;
    return true;
  });
}

TEST(WrongHistory, ANeighbourToAppearInWrongly) {
  expect_told(2, [](Events& events, std::size_t at) {
    auto* a = std::get_if<Appear>(&events[at].what);
    if (a == nullptr || !a->at) return false;
    *a->at = reversed(*a->at);
    a->j = a->at->l;
    return true;
  });
}

TEST(WrongHistory, AFlipThereAndBack) {
  expect_told(30, [](Events& events, std::size_t at) {
    const auto* q = std::get_if<Quad>(&events[at].what);
    if (q == nullptr) return false;
    const Quad there = canonical(flipped(*q)), back = *q;
    const Rational t = to_rational(next_to(to_rational(next_to(events[at].t, 1e300)), 1e300));
    if (at + 1 < events.size() && events[at + 1].t <= t) return false;
    const auto next = events.begin() + static_cast<std::ptrdiff_t>(at) + 1;
    events.insert(next, {{t, there}, {t, back}});
    return true;
  });
}

TEST(WrongHistory, AJumpWithoutItsLastStep) {
  std::mt19937_64 random(8);
  int tried = 0;
  for (int k = 0; k < 5; ++k) {
    const World world = world_of_jumps(random);
    const SampledHistory history = sampled_history(world, 40);
    for (std::size_t at = 0; at < history.events.size(); ++at) {
      std::vector<WorldEvent> events = history.events;
      auto* jump = std::get_if<Jump>(&events[at].what);
      if (jump == nullptr) continue;
      auto& steps = jump->in ? *jump->in : *jump->out;
      if (steps.empty()) continue;
      steps.pop_back();
      if (steps.empty() && !jump->in) continue;  // the last hide of two need not be told
      ++tried;
      EXPECT_TRUE(first_disagreement(world, history.initial, events, no_random_times))
          << text(history.events[at]) << text(world);
    }
  }
  EXPECT_GE(tried, 10);
}

TEST(WrongHistory, AnotherOrderAtOneInstant) {
  World world;
  world.horizon = 2;
  for (const int x : {0, 8, 16, 24}) world.disks.push_back({0, {}, {x, x % 5, 1, 0, 0, 0}});
  world.disks[0].leave = world.disks[1].enter = 1;
  world.maneuvers.push_back({1, 2, {}, Point2{0, 0}, {}, {}});
  world.maneuvers.push_back({1, 3, {}, Point2{0, 0}, {}, {}});
  SampledHistory history = sampled_history(world, 10);
  std::ranges::sort(history.events, {}, [](const WorldEvent& e) {
    const auto* jump = std::get_if<Jump>(&e.what);
    return jump != nullptr ? jump->g : 2 + std::get<PathTurn>(e.what).g;
  });
  const std::vector<Quad>& initial = history.initial;
  EXPECT_EQ(first_disagreement(world, initial, history.events).value_or(""), "");
  for (const int k : {0, 1, 2}) {
    std::vector<WorldEvent> events = history.events;
    std::swap(events[k], events[k + 1]);
    EXPECT_TRUE(first_disagreement(world, initial, events)) << k;
  }
}

TEST(WrongHistory, ATurnThatTheWorldDoesNotHave) {
  expect_told(60, [](Events& events, std::size_t at) {
    events.insert(events.begin() + static_cast<std::ptrdiff_t>(at),
                  {events[at].t, PathTurn{0, {}, {}, Rational(1)}});
    return true;
  });
}

// ---- By hand. ----

TEST(EdgeSet, ThreeDisksOneGoesAndComes) {
  // 0, 1 and the container, and 2 in the edge [0,1,-1,-1].
  EdgeSet set({{0, 1, -1, -1}, {-1, 0, 1, 1}, {-1, 1, 0, 0}});
  EXPECT_EQ(set.visible(), (std::set<GenId>{0, 1}));
  const EdgeSet two = set;
  set.appear({2, 1, Quad{1, 0, -1, -1}});
  EXPECT_EQ(
      set.edges(),
      (std::vector<Quad>{
          {-1, 0, 1, 1}, {-1, 1, 0, 0}, {0, 1, -1, 2}, {0, 1, 2, -1}, {0, 2, 1, 1}, {1, 2, 0, 0}}));
  EdgeSet back = set;
  back.hide({2, 1});
  EXPECT_EQ(back, two);
  set.flip({0, 1, -1, 2});
  EXPECT_EQ(set.edges(), (std::vector<Quad>{{-1, 0, 2, 1},
                                            {-1, 1, 0, 2},
                                            {-1, 2, 1, 0},
                                            {0, 1, 2, -1},
                                            {0, 2, -1, 1},
                                            {1, 2, 0, -1}}));
  EXPECT_THROW(set.hide({2, 1}), ImpossibleEvent);
  EXPECT_THROW(set.flip({0, 1, -1, 2}), ImpossibleEvent);
  set.swap(0, 2);
  EXPECT_EQ(std::ranges::count(set.edges(), Quad{-1, 0, 1, 2}), 1);
}

TEST(EdgeSet, LoneDisks) {
  EdgeSet set({});
  set.appear({3, container_id, std::nullopt});
  set.appear({1, 3, std::nullopt});
  EXPECT_EQ(set.edges(), (std::vector<Quad>{{-1, 1, 3, 3}, {-1, 3, 1, 1}, {1, 3, -1, -1}}));
  set.hide({3, 1});
  EXPECT_TRUE(set.edges().empty());
  EXPECT_EQ(set.visible(), (std::set<GenId>{1}));
  set.hide({1, container_id});
  EXPECT_TRUE(set.visible().empty());
}

TEST(WorldTools, DisksThatComeTogether) {
  World world;
  world.horizon = 4;
  for (const int k : {0, 1, 2}) {
    world.disks.push_back({0, {}, {k - 1, k == 1 ? -2 : 0, 1, 1 - k, k == 1 ? 2 : 0, 0}});
  }
  EXPECT_EQ(first_undecided(world), Rational(1));
  world.disks[2].leave = 1;
  EXPECT_EQ(first_undecided(world), std::nullopt);
  world.maneuvers.push_back({1, 0, {}, Point2{1, 1}, {}, {}});
  EXPECT_EQ(first_undecided(world), Rational(1));
  world.maneuvers[0].growth = 4;
  EXPECT_EQ(first_undecided(world), std::nullopt);
  world.disks[1] = world.disks[2] = world.disks[0];
  EXPECT_EQ(first_undecided(world), std::nullopt);
}

}  // namespace
}  // namespace voroproof::internal::testing
