// The certifier of worlds: it certifies what the engine writes, and of histories with one change
// those only that brute force finds right, too.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <random>
#include <string>

#include "certify/world/world_certifier.h"
#include "engine/world/world_run.h"
#include "tests/world/degenerate_worlds.h"
#include "tests/world/mutants.h"
#include "tests/world/random_worlds.h"
#include "tests/world/world_oracle.h"
#include "tests/world/world_tools.h"

namespace voroproof::internal::testing {
namespace {

class Written final : public WorldSink {
 public:
  void begin(const std::vector<Quad>& initial) override { history.initial = initial; }
  void event(const WorldEvent& event) override { history.events.push_back(event); }

  WrittenWorld history;
};

WorldVerdict verdict(const World& world, const WrittenWorld& history, const Rational& tolerance) {
  WorldCertifier certifier(world, history.initial, tolerance);
  WorldEnd end;
  std::int64_t line = 1;
  for (const WorldEvent& event : history.events) {
    end.counts.add(event);
    certifier.event(event, ++line);
  }
  return certifier.finish(end, line + 1);
}

// In any unit of time.
Rational tolerance_of(const World& world) {
  return sgn(world.horizon) > 0 ? Rational(world.horizon / 1'000'000'000) : Rational(1);
}

std::optional<WrittenWorld> written(const World& world) {
  Written sink;
  if (run_world(world.motion(), {}, sink).kind != WorldOutcome::Kind::complete) return std::nullopt;
  return std::move(sink.history);
}

TEST(WorldMutants, DegenerateHistoriesAreCertified) {
  for (const DegenerateWorld& scene : degenerate_worlds()) {
    const auto history = written(scene.world);
    EXPECT_EQ(history.has_value(), !scene.undecided) << scene.name;
    if (!history) continue;
    const WorldVerdict v = verdict(scene.world, *history, tolerance_of(scene.world));
    EXPECT_EQ(v.kind, Verdict::certified) << scene.name << ", line " << v.line << ": " << v.reason;
  }
}

class RandomMutants : public ::testing::TestWithParam<WorldFamily> {};

// VOROPROOF_WORLDS: so many worlds of the family; VOROPROOF_WORLD_SEED: the first seed.
TEST_P(RandomMutants, AreCertifiedOnlyIfRight) {
  const auto number = [](const char* variable, int usual) {
    const char* given = std::getenv(variable);
    return given == nullptr ? usual : std::atoi(given);
  };
  const int worlds = number("VOROPROOF_WORLDS", 12), first = number("VOROPROOF_WORLD_SEED", 1);
  std::map<std::string, int> counts;
  for (int seed = first; seed < first + worlds; ++seed) {
    std::mt19937_64 random(static_cast<unsigned>(seed));
    const World world = random_world(GetParam(), random);
    const auto right = written(world);
    if (!right) continue;
    const Rational tolerance = tolerance_of(world);
    const WorldVerdict v = verdict(world, *right, tolerance);
    EXPECT_EQ(v.kind, Verdict::certified)
        << "seed " << seed << ", line " << v.line << ": " << v.reason << "\n"
        << text(world);
    for (int tries = 0; tries < 12; ++tries) {
      const auto wrong = mutant(world, *right, tolerance, random);
      if (!wrong) continue;
      ++counts[wrong->kind];
      if (verdict(world, wrong->history, tolerance).kind != Verdict::certified) continue;
      const auto why = first_disagreement(world, wrong->history.initial, wrong->history.events);
      EXPECT_FALSE(why) << "seed " << seed << ", " << wrong->kind << ": " << *why << "\n"
                        << text(world);
    }
  }
  int all = 0;
  for (const auto& [kind, n] : counts) {
    RecordProperty(kind, n);
    all += n;
  }
  EXPECT_GT(all, 2 * worlds);
}

INSTANTIATE_TEST_SUITE_P(Families, RandomMutants, ::testing::ValuesIn(world_families),
                         [](const auto& tested) {
                           std::string name = name_of(tested.param);
                           std::erase(name, ' ');
                           return name;
                         });

}  // namespace
}  // namespace voroproof::internal::testing
