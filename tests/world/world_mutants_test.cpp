// The certifier of worlds: it certifies what the engine writes, and of histories with one change
// those only that brute force finds right, too.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <variant>
#include <vector>

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

WorldVerdict verdict(const World& world, const WrittenWorld& history, const Rational& tolerance,
                     bool filters = true) {
  WorldCertifier certifier(world, history.initial, tolerance, {}, filters);
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

// A history that goes on as if nothing happened.
TEST(WorldMutants, NobodyDecidesWhatFollows) {
  int scenes = 0;
  for (const DegenerateWorld& scene : degenerate_worlds()) {
    if (!scene.undecided) continue;
    ++scenes;
    Written sink;
    run_world(scene.world.motion(), {}, sink);
    const WorldVerdict v = verdict(scene.world, sink.history, tolerance_of(scene.world));
    EXPECT_EQ(v.kind, Verdict::undecided) << scene.name << ": " << v.reason;
  }
  EXPECT_GE(scenes, 4);
}

// A point passes along the boundary of a disk, and its cell leads to a vertex at that instant.
TEST(WorldMutants, FlipsOfATouchAreMissed) {
  const World world = parse_world(R"({"format":"voroproof-scene","version":2,"horizon":4,
"contacts":"pass","frame":"none","disks":[{"center":[1,-1],"radius":1,"velocity":[-1,0]},
{"center":[3,-3],"radius":1,"velocity":[0,1]},{"center":[-2,-2],"radius":0,"velocity":[1,1]},
{"center":[1,1],"radius":0,"velocity":[0,-1]},{"center":[1,-3],"radius":1,"velocity":[0,1]},
{"center":[2,0],"radius":1,"velocity":[1,0]},{"center":[3,-2],"radius":0,"velocity":[0,1]}]})",
                                  "touch");
  const auto right = written(world);
  ASSERT_TRUE(right);
  EXPECT_EQ(verdict(world, *right, tolerance_of(world)).kind, Verdict::certified);
  WrittenWorld wrong = *right;
  const auto touches = [](const WorldEvent& event) { return event.t == 3; };
  ASSERT_GT(std::erase_if(wrong.events, touches), 0U);
  EXPECT_EQ(verdict(world, wrong, tolerance_of(world)).kind, Verdict::refuted);
}

// Lengths of about 1e38: their eighth power is near the largest double, and sums of coefficients
// are beyond it.
TEST(WorldMutants, FlipsOfHugeDisksAreMissed) {
  const World world = parse_world(
      R"({"format":"voroproof-scene","version":2,"horizon":0.459228515625,
"contacts":"pass","frame":"none","disks":[
{"center":["6683807545260413111147687926950789120","127734988642754561679711369270615080960"],
"radius":"92756395822558399731371802452905951232","growth":"-2896316602946179014830664768345341952",
"velocity":["-96840944877995318854850945074931433472","-129071750151806644301940906856005238784"]},
{"center":["-182393681457328606677541350539901534208","196875264472059501751694674381628243968"],
"radius":"38766083762510396044656589976314576896","growth":"1113967924210068851857947987825131520",
"velocity":["208014943714160190270274154259879559168","-190637044096483116181290165649807507456"]},
{"center":["-186775288625888210828182612625347051520","-30968308293039914081650954061538656256"],
"radius":"75155702620039311872016224245268873216","growth":"-2524993961542822730878015439070298112",
"velocity":["254430273889579725764355320419260039168","6089691319015043056823449000110718976"]},
{"center":["-303667656139664769016476621481130852352","-298840461801421137325092180200555282432"],
"radius":"46860917345103563034824345354510532608","growth":"-3267639244349535298783314097620385792",
"velocity":["290151511992582600280600185895519256576","184547352777468073124466716649696788480"]}]})",
      "huge");
  const auto right = written(world);
  ASSERT_TRUE(right);
  ASSERT_EQ(right->events.size(), 2U);
  EXPECT_EQ(verdict(world, *right, tolerance_of(world)).kind, Verdict::certified);
  WrittenWorld wrong = *right;
  wrong.events.pop_back();
  EXPECT_EQ(verdict(world, wrong, tolerance_of(world)).kind, Verdict::refuted);
}

// At the instant of a jump a swap that belongs there is told, and told once; no other is.
TEST(WorldMutants, SwapsAtAJumpAreNotAtWill) {
  int told = 0, untold = 0;
  for (const DegenerateWorld& scene : degenerate_worlds()) {
    const bool meets = scene.name.find(" where ") != std::string::npos ||
                       scene.name.find(" meet") != std::string::npos;
    if (!meets || scene.undecided) continue;
    const auto right = written(scene.world);
    ASSERT_TRUE(right) << scene.name;
    const auto expect_refuted = [&](const auto& spoil) {
      WrittenWorld wrong = *right;
      spoil(wrong.events);
      const WorldVerdict v = verdict(scene.world, wrong, tolerance_of(scene.world));
      EXPECT_EQ(v.kind, Verdict::refuted) << scene.name;
    };
    const auto is_swap = [](const WorldEvent& e) { return std::holds_alternative<Swap>(e.what); };
    const auto swap = std::find_if(right->events.begin(), right->events.end(), is_swap);
    const std::ptrdiff_t place = swap - right->events.begin();
    if (swap != right->events.end()) {
      ++told;
      expect_refuted([&](auto& events) { events.erase(events.begin() + place); });
      // There and back.
      expect_refuted([&](auto& events) { events.insert(events.begin() + place, 2, *swap); });
    } else {
      ++untold;
      expect_refuted([&](auto& events) { events.push_back({1, Swap{0, 1}}); });
    }
  }
  EXPECT_GT(told, 8);
  EXPECT_GT(untold, 8);
}

// An edge of a disk that has just jumped flips and flips back.
TEST(WorldMutants, IdleFlipsOfAJumpAreRefused) {
  int told = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    std::mt19937_64 random(seed);
    const World world = random_world(WorldFamily::jumping, random);
    const auto right = written(world);
    if (!right) continue;
    for (std::size_t k = 0; k < right->events.size(); ++k) {
      const auto* jump = std::get_if<Jump>(&right->events[k].what);
      if (jump == nullptr || !jump->in || jump->in->empty()) continue;
      const auto* last = std::get_if<Quad>(&jump->in->back());
      if (last == nullptr) continue;
      WrittenWorld idle = *right;
      const Rational t = right->events[k].t;
      const WorldEvent back{t, canonical(flipped(*last))}, again{t, *last};
      idle.events.insert(idle.events.begin() + static_cast<std::ptrdiff_t>(k) + 1, {back, again});
      EXPECT_EQ(verdict(world, idle, tolerance_of(world)).kind, Verdict::refuted) << text(world);
      ++told;
    }
  }
  EXPECT_GT(told, 5);
}

// ---- One history in two ways. ----

// Seen in a mirror, with lengths and times so many times as large: powers of two, so that what is
// rounded stays rounded.
struct Image {
  Rational length, time;

  World of(World world) const {
    if (world.circle) world.circle->center.x = -world.circle->center.x;
    for (WorldDisk& disk : world.disks) {
      disk.state.x = -disk.state.x;
      disk.state.vx = -disk.state.vx;
    }
    for (WorldManeuver& m : world.maneuvers) {
      for (auto* p : {&m.center, &m.velocity}) {
        if (*p) (*p)->x = -(*p)->x;
      }
    }
    return in_units(world, length, time);
  }
  WrittenWorld of(WrittenWorld history) const {
    for (Quad& q : history.initial) q = canonical(of(q));
    std::sort(history.initial.begin(), history.initial.end());
    for (WorldEvent& event : history.events) {
      event.t *= time;
      std::visit([&](auto& what) { turn(what); }, event.what);
    }
    return history;
  }

 private:
  static Quad of(const Quad& q) { return {q.l, q.r, q.e, q.s}; }
  static void turn(Quad& q) { q = canonical(of(q)); }
  static void turn(Hide&) {}
  static void turn(Swap&) {}
  static void turn(Appear& appear) {
    if (appear.at) appear.at = of(*appear.at);
  }
  void turn(std::optional<Point2>& p, const Rational& unit) const {
    if (p) p = Point2{-p->x * unit, p->y * unit};
  }
  void turn(PathTurn& turned) const {
    turn(turned.center, length);
    turn(turned.velocity, length / time);
    if (turned.growth) *turned.growth *= length / time;
  }
  void turn(Jump& jump) const {
    for (auto* steps : {&jump.out, &jump.in}) {
      if (!*steps) continue;
      for (Step& step : **steps) std::visit([&](auto& what) { turn(what); }, step);
    }
    turn(jump.center, length);
    turn(jump.velocity, length / time);
    if (jump.radius) *jump.radius *= length;
  }
};

TEST(WorldMutants, MirrorsAndUnitsChangeNoVerdict) {
  const Rational large = to_rational(0x1p70), small = to_rational(0x1p-90);
  std::array<int, 3> kinds{};
  for (const WorldFamily family : world_families) {
    for (unsigned seed = 1; seed <= 4; ++seed) {
      std::mt19937_64 random(seed + 50);
      const World world = random_world(family, random);
      const auto right = written(world);
      if (!right) continue;
      const Rational tolerance = tolerance_of(world);
      std::vector<WrittenWorld> histories{*right};
      for (int k = 0; k < 4; ++k) {
        if (auto wrong = mutant(world, *right, tolerance, random)) {
          histories.push_back(std::move(wrong->history));
        }
      }
      for (const Image& image : {Image{1, 1}, Image{large, small}, Image{small, large}}) {
        const World other = image.of(world);
        for (const WrittenWorld& history : histories) {
          const WorldVerdict v = verdict(world, history, tolerance);
          const WorldVerdict seen = verdict(other, image.of(history), tolerance_of(other));
          ++kinds[static_cast<int>(v.kind)];
          EXPECT_EQ(v.kind, seen.kind) << v.reason << "\n" << seen.reason << "\n" << text(world);
          EXPECT_EQ(v.line, seen.line) << v.reason << "\n" << seen.reason << "\n" << text(world);
        }
      }
    }
  }
  EXPECT_GT(kinds[static_cast<int>(Verdict::certified)], 60);
  EXPECT_GT(kinds[static_cast<int>(Verdict::refuted)], 200);
}

TEST(WorldMutants, FiltersChangeNoVerdict) {
  for (const WorldFamily family : world_families) {
    for (unsigned seed = 1; seed <= 4; ++seed) {
      std::mt19937_64 random(seed);
      const World world = random_world(family, random);
      const auto right = written(world);
      if (!right) continue;
      const Rational tolerance = tolerance_of(world);
      std::vector<WrittenWorld> histories{*right};
      for (int k = 0; k < 4; ++k) {
        if (auto wrong = mutant(world, *right, tolerance, random)) {
          histories.push_back(std::move(wrong->history));
        }
      }
      for (const WrittenWorld& history : histories) {
        const WorldVerdict v = verdict(world, history, tolerance);
        const WorldVerdict exact = verdict(world, history, tolerance, false);
        EXPECT_EQ(v.kind, exact.kind) << text(world);
        EXPECT_EQ(v.line, exact.line) << v.reason << "\n" << exact.reason << "\n" << text(world);
      }
    }
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
                         [](const auto& tested) { return name_of(tested.param); });

}  // namespace
}  // namespace voroproof::internal::testing
