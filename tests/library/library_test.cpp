// The library as other programs see it: its headers alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "tests/library/scenes.h"
#include "voroproof/voroproof.h"

namespace {

using namespace voroproof;
using namespace voroproof::internal::testing;

class Folder : public testing::Test {
 protected:
  void SetUp() override {
    char name[] = "voroproof-library-XXXXXX";
    path_ = std::filesystem::temp_directory_path() / name;
    std::string text = path_.string();
    ASSERT_NE(mkdtemp(text.data()), nullptr);
    path_ = text;
  }
  void TearDown() override { std::filesystem::remove_all(path_); }
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

using LibraryFiles = Folder;

TEST(LibraryNumber, HoldsWhatItIsGivenExactly) {
  EXPECT_EQ(Number(0.5).text(), "0.5");
  EXPECT_EQ(Number("1/2"), Number(0.5));
  EXPECT_EQ(Number("0x1.8p-3").nearest(), 0.1875);
  EXPECT_FALSE(Number("0.1").is_double());
  EXPECT_EQ(Number("0.1").text(), "1/10");
  EXPECT_EQ(Number("2/6"), Number("1/3"));
  EXPECT_EQ(Number("0.1").nearest(), 0.1);
  EXPECT_NE(Number("0.1"), Number(0.1));
  EXPECT_EQ(Number(-0.0).text(), "0");
}

TEST(LibraryNumber, RefusesWhatIsNone) {
  EXPECT_THROW(Number("one"), std::invalid_argument);
  EXPECT_THROW(Number("1/0"), std::invalid_argument);
  EXPECT_THROW(Number{std::numeric_limits<double>::quiet_NaN()}, std::invalid_argument);
  EXPECT_THROW(Number{std::numeric_limits<double>::infinity()}, std::invalid_argument);
}

TEST(LibraryScene, TextAndBack) {
  Scene scene = two_disks();
  scene.disks[1].x = Number("10/3");
  scene.disks[0].mass = Number(5);
  scene.maneuvers = {{1, 0, 0, Number("1/7")}};
  scene.name = "a \"name\"";
  const Scene back = parse_scene(scene_text(scene));
  EXPECT_EQ(scene_text(back), scene_text(scene));
  EXPECT_EQ(back.disks[1].x, Number("10/3"));
  EXPECT_EQ(back.disks[0].mass, Number(5));
  EXPECT_FALSE(back.disks[1].mass.has_value());
  EXPECT_EQ(back.name, scene.name);
  EXPECT_EQ(scene_sha256(back), scene_sha256(scene));
}

TEST_F(LibraryFiles, ASceneKeepsTheIdentityOfItsFileUntilItIsChanged) {
  {
    std::ofstream out(file("a.json"));
    out << R"({"format":"voroproof-scene","version":1,"horizon":8.0,
      "container":{"center":[0,0],"radius":10},"restitution":1,
      "disks":[{"center":[-3,0],"radius":1,"velocity":[1,0]},{"center":[3,0],"radius":1,"velocity":[-1,0]}]})";
  }
  Scene scene = read_scene(file("a.json"));
  ASSERT_TRUE(scene.source.has_value());
  EXPECT_EQ(scene_sha256(scene), scene.source->file_sha256);
  EXPECT_NE(scene_sha256(scene), scene_sha256(two_disks()));
  const History history = simulate(scene);
  EXPECT_EQ(history.scene_sha256, scene.source->file_sha256);
  scene.disks[0].vx = 2;
  EXPECT_NE(scene_sha256(scene), scene.source->file_sha256);
  EXPECT_THROW(certify(scene, history), InputError);
}

TEST_F(LibraryFiles, AHistoryIsReadIntoASink) {
  struct Counting final : EventSink {
    void begin(const std::vector<Edge>& initial) override { edges = initial.size(); }
    void event(const Event& event) override {
      if (time(event) > 15) throw std::runtime_error("enough");
      ++events;
    }
    std::size_t edges = 0, events = 0;
  };
  const History history = simulate(reference(10, 15));
  write_history(file("a.jsonl"), history);
  Counting counting;
  const History head = read_history(file("a.jsonl"), counting);
  EXPECT_EQ(counting.events, history.events.size());
  EXPECT_EQ(counting.edges, history.initial->size());
  EXPECT_TRUE(head.events.empty() && head.scene_sha256 == history.scene_sha256);
  write_history(file("b.jsonl"), simulate(reference(10, 50)));
  EXPECT_THROW(read_history(file("b.jsonl"), counting), std::runtime_error);
}

TEST(LibraryScene, IsCheckedAsAFileIs) {
  Scene scene = two_disks();
  scene.disks[1].x = -2;
  try {
    simulate(scene);
    FAIL() << "overlapping disks";
  } catch (const InputError& error) {
    EXPECT_EQ(error.file(), "scene");
    EXPECT_EQ(error.line(), 0);
    EXPECT_EQ(error.field(), "disks[1]");
    EXPECT_NE(error.reason().find("overlap"), std::string::npos) << error.what();
  }
  scene = two_disks();
  scene.horizon = -1;
  EXPECT_THROW(simulate(scene), InputError);
  scene = two_disks();
  scene.maneuvers = {{1, 2, 0, 0}};
  EXPECT_THROW(simulate(scene), InputError);
}

TEST(LibrarySimulate, NobodyOneAndTwo) {
  Scene scene;
  scene.horizon = 1;
  EXPECT_TRUE(simulate(scene).events.empty());
  scene.container_radius = 10;
  scene.horizon = 20;
  scene.disks = {disk(0, 0, 1, 1, 0)};
  const History one = simulate(scene);
  ASSERT_EQ(one.events.size(), 1u);  // at 9; at 27 the next
  const auto& wall = std::get<CollisionEvent>(one.events[0]);
  EXPECT_EQ(wall.t, 9);
  EXPECT_EQ(wall.i, container);
  EXPECT_FALSE(wall.velocity[0].has_value());
  EXPECT_EQ(wall.velocity[1], (Vector{-1, 0}));

  const History two = simulate(two_disks());
  const auto& hit = std::get<CollisionEvent>(two.events.at(0));
  EXPECT_EQ(hit.t, 2);
  EXPECT_EQ(hit.velocity[0], (Vector{-1, 0}));
  EXPECT_EQ(hit.center[1], (Vector{1, 0}));
  EXPECT_TRUE(two.ending.complete);
  EXPECT_EQ(two.ending.t, 8);
}

TEST(LibrarySimulate, TheSameHistoryByAnyWay) {
  const Scene scene = reference(40, 60);
  const History one = simulate(scene);
  SimulateOptions options;
  options.threads = 2;
  const History two = simulate(scene, options);
  ASSERT_EQ(one.events.size(), two.events.size());
  for (std::size_t k = 0; k < one.events.size(); ++k) {
    EXPECT_EQ(one.events[k].index(), two.events[k].index());
    EXPECT_EQ(time(one.events[k]), time(two.events[k]));
  }
}

TEST(LibrarySimulate, StopsWhereItIsTold) {
  SimulateOptions options;
  options.max_events = 10;
  const History history = simulate(reference(40, 60), options);
  EXPECT_FALSE(history.ending.complete);
  EXPECT_LE(history.events.size(), 10u);
  EXPECT_NE(history.ending.reason, "");
  options.max_events = 0;
  options.monitor = [](double, std::uint64_t) { return false; };
  const History interrupted = simulate(reference(40, 60), options);
  EXPECT_FALSE(interrupted.ending.complete);
  EXPECT_EQ(interrupted.ending.reason, "interrupted");
  options.max_bits = 8;
  EXPECT_THROW(simulate(two_disks(), options), std::invalid_argument);
  options = {};
  options.threads = 0;
  EXPECT_THROW(simulate(two_disks(), options), std::invalid_argument);
}

struct Refusal {};

TEST(LibrarySimulate, WhatASinkThrowsArrives) {
  struct Refusing : EventSink {
    void begin(const std::vector<Edge>&) override {}
    void event(const Event&) override { throw Refusal(); }
  } sink;
  EXPECT_THROW(simulate(two_disks(), sink), Refusal);
}

TEST_F(LibraryFiles, HistoriesAsFiles) {
  const Scene scene = reference(20, 40);
  const History history = simulate(scene);
  write_scene(file("s.json"), scene);
  write_history(file("h.jsonl"), history);
  EXPECT_EQ(certify_files(file("s.json"), file("h.jsonl")).verdict, Verdict::certified);
  const History back = read_history(file("h.jsonl"));
  EXPECT_EQ(back.rounded, 0);
  EXPECT_EQ(back.events.size(), history.events.size());
  EXPECT_EQ(certify(read_scene(file("s.json")), back).verdict, Verdict::certified);
  EXPECT_THROW(read_history(file("s.json")), InputError);
  EXPECT_THROW(read_scene(file("none")), InputError);
  EXPECT_THROW(write_history(file("no/where"), history), OutputError);
}

TEST_F(LibraryFiles, ExactTimesOfAFileAreCountedAsRounded) {
  write_scene(file("s.json"), two_disks());
  {
    std::ofstream out(file("h.jsonl"));
    out << R"({"format":"voroproof-history","version":1,"scene_sha256":")"
        << scene_sha256(two_disks()) << R"(","horizon":8,"producer":"x 1"})"
        << "\n"
        << R"({"t":"20000000000000000000001/10000000000000000000000","collide":[0,1]})"
        << "\n"
        << R"({"end":{"t":8,"flips":0,"collisions":1,"maneuvers":0}})"
        << "\n";
  }
  EXPECT_EQ(read_history(file("h.jsonl")).rounded, 1);
}

TEST_F(LibraryFiles, TheDiagramAtATime) {
  const Scene scene = reference(20, 40);
  const History history = simulate(scene);
  for (const char* t : {"0", "25/2", "40"}) {
    const Diagram by_engine = diagram_at(scene, Number(t));
    const Diagram by_history = diagram_at(scene, history, Number(t));
    EXPECT_EQ(by_engine.edges, by_history.edges) << t;
    EXPECT_EQ(by_engine.edges.size(), 57u);
    EXPECT_EQ(by_engine.vertices.size(), 38u);
    write_diagram(file("d.json"), by_engine);
    const Diagram back = read_diagram(file("d.json"));
    EXPECT_EQ(back.edges, by_engine.edges);
    EXPECT_EQ(back.t, Number(t));
  }
  EXPECT_THROW(diagram_at(scene, history, 41), InputError);
  EXPECT_THROW(diagram_at(scene, -1), std::invalid_argument);
}

// A history without its last flip leads to an illegal edge.
TEST(LibraryDiagram, IllegalEdgesAreRefused) {
  const Scene scene = reference(20, 40);
  History history = simulate(scene);
  const auto last =
      std::find_if(history.events.rbegin(), history.events.rend(),
                   [](const Event& e) { return std::holds_alternative<FlipEvent>(e); });
  ASSERT_NE(last, history.events.rend());
  history.events.erase(std::next(last).base());
  EXPECT_THROW(diagram_at(scene, history, 40), InputError);
  EXPECT_EQ(diagram_at(scene, history, 40, 32768, false).edges.size(), 57u);
}

// Far from the origin the recorded places are coarse: next to a flip they put generators a little
// into circles that they leave.
TEST(LibraryDiagram, CoarsePlacesAreNotRefused) {
  Scene scene = reference(20, 40);
  const double far = 1e12;
  scene.container_x = scene.container_y = far;
  for (Disk& d : scene.disks) {
    d.x = d.x.nearest() + far;
    d.y = d.y.nearest() + far;
  }
  const History history = simulate(scene);
  int flips = 0;
  for (const Event& event : history.events) {
    const auto* flip = std::get_if<FlipEvent>(&event);
    if (flip == nullptr) continue;
    ++flips;
    for (const double later : {-4e-6, 4e-6, 4e-5}) {
      EXPECT_NO_THROW(diagram_at(scene, history, flip->t + later)) << flip->t;
    }
  }
  EXPECT_GT(flips, 30);
}

TEST(LibraryDiagram, NeighboursOfFew) {
  Scene scene;
  scene.container_radius = 10;
  EXPECT_TRUE(neighbours(diagram_at(scene, 0), container).empty());
  scene.disks = {disk(1, 0, 1, 0, 0)};
  EXPECT_EQ(neighbours(diagram_at(scene, 0), 0), std::vector<int>{container});
  scene = two_disks();
  EXPECT_EQ(neighbours(diagram_at(scene, 0), 0), (std::vector<int>{container, 1}));
}

TEST(LibraryInstant, Distances) {
  Instant instant(two_disks(), 1);  // at -2 and 2
  const auto near = instant.nearest(0, 0, 5);
  ASSERT_EQ(near.size(), 2u);
  EXPECT_EQ(near[0].disk, 0);
  EXPECT_FALSE(near[0].tied);
  EXPECT_TRUE(near[1].tied);
  EXPECT_LE(near[0].distance.lower, 1);
  EXPECT_GE(near[0].distance.upper, 1);
  const auto all = instant.neighbours(0);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].generator, container);
  EXPECT_EQ(instant.closest_disks().pairs, (std::vector<std::pair<int, int>>{{0, 1}}));
  EXPECT_EQ(instant.closest_generators().pairs.size(), 1u);
  EXPECT_THROW(instant.neighbours(2), std::invalid_argument);
  EXPECT_THROW(Instant(two_disks(), -1), std::invalid_argument);
}

TEST(LibraryPlan, TwoThatWouldMeet) {
  PlanTask task;
  task.container_radius = 20;
  task.arrive = 10;
  task.vehicles = {{1, -10, 0, 10, 0}, {1, 0, -10, 0, 10}};
  const Plan plan = make_plan(task);
  ASSERT_TRUE(plan.found);
  EXPECT_EQ(plan.avoided, 1u);
  ASSERT_TRUE(plan.nearest.has_value());
  EXPECT_GT(plan.nearest->gap.lower, 0);
  const History history = simulate(plan.scene);
  for (const Event& event : history.events) {
    EXPECT_FALSE(std::holds_alternative<CollisionEvent>(event));
  }
  task.vehicles[1] = task.vehicles[0];
  const Plan none = make_plan(task);
  EXPECT_FALSE(none.found);
  EXPECT_TRUE(none.conflict.has_value());
  task.arrive = 0;
  EXPECT_THROW(make_plan(task), InputError);
}

TEST_F(LibraryFiles, ExtensionsAreKept) {
  Scene scene = two_disks();
  scene.extensions["x-of-scene"] = R"({"a": [1, 2]})";
  scene.disk_extensions[1]["x-of-disk"] = "\"red\"";
  write_scene(file("x.json"), scene);
  Scene back = read_scene(file("x.json"));
  EXPECT_EQ(back.extensions.at("x-of-scene"), R"({"a":[1,2]})");
  EXPECT_EQ(back.disk_extensions, scene.disk_extensions);

  History history = simulate(back);
  ASSERT_FALSE(history.events.empty());
  history.extensions["x-of-header"] = "1";
  history.event_extensions[0]["x-of-event"] = "2";
  history.ending.extensions["x-of-end"] = "3";
  write_history(file("x.jsonl"), history);
  const History again = read_history(file("x.jsonl"));
  EXPECT_EQ(again.extensions, history.extensions);
  EXPECT_EQ(again.event_extensions, history.event_extensions);
  EXPECT_EQ(again.ending.extensions, history.ending.extensions);
  EXPECT_EQ(certify(back, again).verdict, Verdict::certified);

  Diagram diagram = diagram_at(back, 1);
  diagram.extensions["x-of-diagram"] = "4";
  write_diagram(file("x.diagram.json"), diagram);
  EXPECT_EQ(read_diagram(file("x.diagram.json")).extensions, diagram.extensions);

  // They are ignored, but a part of the scene's identity; and nothing but a field of its own.
  const std::string hash = scene_sha256(back);
  back.extensions.clear();
  EXPECT_NE(scene_sha256(back), hash);
  back.extensions["x-a"] = R"(1, "comment": "mine")";
  EXPECT_THROW(write_scene(file("y.json"), back), InputError);
}

TEST(LibraryGenerators, RefuseWhatHasNoMeaning) {
  ReferenceOptions options;
  options.n = -1;
  EXPECT_THROW(reference_scene(options), std::invalid_argument);
  options = {};
  options.n = 50;
  options.density = 0.95;
  EXPECT_THROW(reference_scene(options), Error);
  GridOptions grid;
  grid.n = 9;
  grid.motion = GridOptions::Motion::common;
  grid.horizon = 10;
  const Scene scene = grid_scene(grid);
  EXPECT_EQ(certify(scene, simulate(scene)).verdict, Verdict::certified);
  SwarmOptions swarm;
  swarm.n = 5;
  EXPECT_EQ(swarm_scene(swarm).maneuvers.size(), 5u);
}

TEST(LibraryArithmetic, OtherRoundingIsRefused) {
  const Scene scene = two_disks();
  std::fesetround(FE_UPWARD);
  EXPECT_THROW(simulate(scene), std::runtime_error);
  std::fesetround(FE_TONEAREST);
  EXPECT_NO_THROW(simulate(scene));
}

TEST(LibraryVersion, IsThatOfTheHeaders) { EXPECT_STREQ(version(), VOROPROOF_VERSION); }

}  // namespace
