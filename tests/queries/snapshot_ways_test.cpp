// Six ways from a history to a diagram, one diagram.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "history/error.h"
#include "library/snapshot.h"
#include "tests/queries/scene_history.h"
#include "tests/support/formation_scene.h"
#include "tests/support/lattice_scene.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
namespace {

namespace fs = std::filesystem;

// The instants of some events, between them, and the ends.
std::set<Rational> instants(const Scene& scene, const std::string& path, std::size_t most) {
  HistoryReader history(path, static_cast<int>(scene.disks.size()));
  std::vector<Rational> times{0};
  while (const auto event = history.next()) {
    const Rational t = exact_time(*event);
    if (t != times.back() && t <= history.header().horizon) times.push_back(t);
  }
  std::set<Rational> some{0, history.header().horizon};
  const std::size_t step = 1 + times.size() / most;
  for (std::size_t k = 1; k < times.size(); k += step) {
    some.insert(times[k]);
    some.insert(Rational((times[k] + times[k - 1]) / 2));
  }
  return some;
}

// The number of instants tried.
int expect_one_diagram(const Scene& scene, const std::string& history, std::size_t most) {
  TemporaryDirectory directory;
  int tried = 0;
  for (const Rational& t : instants(scene, history, most)) {
    std::string first;
    for (const Move move : {Move::all_at_events, Move::all_at_collisions, Move::colliding}) {
      for (const Construct construct : {Construct::from_scratch, Construct::by_flips}) {
        write_diagram(directory.file("d"), snapshot(scene, history, t, {}, {move, construct}));
        const std::string bytes = directory.read("d");
        if (first.empty()) first = bytes;
        EXPECT_EQ(bytes, first) << "t = " << t << ", move " << static_cast<int>(move)
                                << ", construct " << static_cast<int>(construct);
      }
    }
    ++tried;
  }
  return tried;
}

TEST(SnapshotWays, RandomScenes) {
  Random random(11);
  for (int k = 0; k < 6; ++k) {
    const SceneHistory run(
        random_scene({.n = 4 + 3 * k, .horizon = 20, .density = 0.2, .maneuvers = k % 3}, random));
    ASSERT_TRUE(run.complete);
    EXPECT_GT(expect_one_diagram(run.scene, run.history, 12), 3);
  }
}

RC_GTEST_PROP(SnapshotWays, LatticesWithTies, ()) {
  const auto lattice = *lattice_scenes({.maneuvers = true});
  const SceneHistory run(scene_of(lattice));
  if (run.complete) expect_one_diagram(run.scene, run.history, 4);
}

RC_GTEST_PROP(SnapshotWays, FormationsWithTies, ()) {
  const auto formation = *formation_scenes(6);
  const SceneHistory run(scene_of(formation));
  if (run.complete) expect_one_diagram(run.scene, run.history, 4);
}

TEST(SnapshotWays, DegenerateCases) {
  int cases = 0, undefined = 0;
  for (const auto& entry : fs::recursive_directory_iterator(VOROPROOF_CASES)) {
    if (entry.path().filename() != "exact.history.jsonl") continue;
    const std::string folder = entry.path().parent_path().string();
    const Scene scene = read_scene(folder + "/scene.scene.json");
    if (scene.disks.size() > 40) continue;
    ++cases;
    SCOPED_TRACE(folder);
    try {
      expect_one_diagram(scene, entry.path().string(), 2);
    } catch (const InputError& stopped_before) {
      ++undefined;
    } catch (const Undecided& touching_points) {
      ++undefined;
    }
  }
  EXPECT_GT(cases, 50);
  EXPECT_LT(undefined, cases / 5) << cases;
}

// A wall, a disk and the wall again at one instant that is no binary64: none of it has happened at
// the recorded time.
TEST(SnapshotWays, ChainOfCollisionsJustBehindItsRecordedTime) {
  const SceneHistory run(scene_of(12, 6, {disk(-6, 3, 3, -1, -2), disk(-9, -1, 2, -1, -2)}));
  ASSERT_TRUE(run.complete);
  EXPECT_GT(expect_one_diagram(run.scene, run.history, 100), 5);
}

// A history whose collisions are not those of the scene's motion.
TEST(SnapshotWays, FromScratchRefusesAMotionThatIsNotTheScenes) {
  const SceneHistory run(scene_of(10, 5, {disk(-3, 0, 1, 1, 0), disk(3, 0, 1, -1, 0)}));
  ASSERT_TRUE(run.complete);
  std::string bytes = run.directory.read("history");
  const std::string right = "{\"t\":2,\"collide\":[0,1]";
  ASSERT_NE(bytes.find(right), std::string::npos) << bytes;
  bytes.replace(bytes.find(right), 6, "{\"t\":1");
  const std::string wrong = run.directory.write("wrong", bytes);
  snapshot(run.scene, wrong, 3);
  EXPECT_THROW(snapshot(run.scene, wrong, 3, {}, {Move::colliding, Construct::from_scratch}),
               InputError);
}

// Three disks around a circle whose centre and radius are half way between two binary64, or are one
// exactly, and which no enclosure tells from their neighbours: ties go to the even one.
TEST(SnapshotWays, CentresHalfWayBetweenTwoNumbers) {
  const Rational ulp(0x1p-52);
  int half_way = 0;
  for (int k = 0; k < 12; ++k) {
    const Rational x = 1 + Rational(k, 2) * ulp, rho = 2 + Rational(k) * ulp, reach = rho + 1;
    const auto at = [&](const Rational& u, const Rational& v) {
      return disk(x + reach * u, reach * v, 1, 1, 0);
    };
    const SceneHistory run(
        scene_of(20, 1,
                 {at(Rational(3, 5), Rational(4, 5)), at(Rational(-5, 13), Rational(12, 13)),
                  at(Rational(8, 17), Rational(-15, 17))}));
    ASSERT_TRUE(run.complete);
    for (const Rational& t : {Rational(0), Rational(ulp / 2), Rational(1, 2)}) {
      half_way += to_rational(round_nearest(Rational(x + t))) != x + t;
      for (const DiagramFile& d : {snapshot(run.scene, t), snapshot(run.scene, run.history, t)}) {
        const auto vertex = std::find_if(d.vertices.begin(), d.vertices.end(), [](const auto& v) {
          return v.generators == Triple{0, 1, 2};
        });
        ASSERT_NE(vertex, d.vertices.end());
        EXPECT_EQ(vertex->center, (Vec2{round_nearest(Rational(x + t)), 0})) << k << ", t = " << t;
        EXPECT_EQ(vertex->radius, round_nearest(rho)) << k;
      }
    }
  }
  EXPECT_GT(half_way, 6);
}

}  // namespace
}  // namespace voroproof::internal::testing
