// The movie: what the page computes in the browser against what the program computes of the same
// history, and the picture against the definition of a Voronoi diagram.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "history/diagram_file.h"
#include "tests/apps/movie/movie.h"

namespace voroproof::internal {
namespace {

TEST_F(Movie, ReplaysTheDiagramsOfTheHistoryInAnyOrder) {
  const std::string scene = reference(40, "40");
  expect_same(scene, simulated(scene), {0, 40, 17.5, 3.25, 33.125, 0.5, 40, 0});
}

TEST_F(Movie, ReplaysFormationsWithManeuvers) {
  must({"generate", "formation", "--n", "12", "--flight", "square,turn,circle", "--horizon", "24",
        "-o", file("f.scene.json")});
  const std::string scene = file("f.scene.json");
  expect_same(scene, simulated(scene), {24, 11.375, 5.0625, 19.84375, 0.125});
}

TEST_F(Movie, ReplaysPointsAndTinyDisks) {
  const std::string scene =
      scene_file(R"({"center":[1,3],"radius":0,"velocity":[1,0.5],"mass":1},)"
                 R"({"center":[4,2],"radius":2,"velocity":[-1,0.25]},)"
                 R"({"center":[-3,1],"radius":0.125,"velocity":[0.5,-1]},)"
                 R"({"center":[1,-3],"radius":0,"velocity":[0.25,1],"mass":2},)"
                 R"({"center":[3,7],"radius":0.0625,"velocity":[0,-1]})");
  expect_same(scene, simulated(scene), {0.5, 20, 7.75, 13.0625});
}

TEST_F(Movie, BeginsInTheMiddle) {
  const std::string scene = reference(40, "40");
  const std::string history = simulated(scene);
  expect_same(scene, history, {17.5, 40, 25, 17.5, 33.125}, {"--from", "17.5"});
  expect_same(scene, history, {40}, {"--from", "40"});
  const Json page = run_in_page(movie(scene, history, {"--from", "35/2", "--horizon", "30"}), R"js(
    const { data, motion, timeline, state } = player, seen = [];
    for (const t of [-1, 0, 20, 35]) { player.seek(t); player.draw(); seen.push(state.t); }
    player.look(-1);
    player.draw();
    return { seen, start: state.t, first: data.times[0], last: data.times[data.events - 1],
      middle: data.timeAt(0.5), ends: [timeline.place(17.5), timeline.place(30)],
      strip: [timeline.left, timeline.width - timeline.left],
      low: timeline.canvas.getAttribute("aria-valuemin"),
      notes: element("notes").textContent };)js");
  ASSERT_EQ(page.at("errors"), Json::array());
  const Json& result = page.at("result");
  EXPECT_EQ(result.at("seen"), Json({17.5, 17.5, 20, 30}));
  EXPECT_EQ(result.at("start"), 17.5);
  EXPECT_GT(result.at("first"), 17.5);
  EXPECT_LE(result.at("last"), 30);
  EXPECT_EQ(result.at("middle"), 23.75);
  EXPECT_EQ(result.at("ends"), result.at("strip"));
  EXPECT_EQ(result.at("low"), "17.5");
  EXPECT_NE(result.at("notes").get<std::string>().find("up to t = 17.5 is left out: "),
            std::string::npos);
}

// Such a history has neither an initial diagram nor velocities.
TEST_F(Movie, ReplaysEventSequences) {
  const std::string scene = reference(15, "20");
  const std::string history = simulated(scene), events = file("a.evtsq");
  const DiagramFile truth = diagram(scene, history, 13.5);
  must({"convert", history, "--scene", scene, "-o", events});
  for (const Arguments& more : {Arguments{}, Arguments{"--from", "12"}}) {
    const Json page = run_in_page(movie(scene, events, more), R"js(
    player.seek(13.5);
    player.draw();
    const { diagram } = player.replay, edges = [];
    for (let h = 0; h < diagram.halves; h += 2) edges.push(diagram.quad(h).map((s) => s - 1));
    const { x, radius } = player.data.frame;
    return { edges, x: Array.from(player.motion.x, (u) => x + radius * u) };)js");
    ASSERT_EQ(page.at("errors"), Json::array());
    std::set<Quad> edges;
    for (const Json& q : page.at("result").at("edges")) {
      edges.insert(canonical(Quad{q.at(0), q.at(1), q.at(2), q.at(3)}));
    }
    EXPECT_EQ(edges, std::set<Quad>(truth.edges.begin(), truth.edges.end()));
    for (std::size_t i = 0; i < truth.disks.size(); ++i) {
      EXPECT_NEAR(page.at("result").at("x").at(i + 1), truth.disks[i].center[0], 1e-6);
    }
  }
}

// A flip drawn back and forth leaves each incidence as it was.
TEST_F(Movie, EveryEventIsTakenBackAsItWasMade) {
  const std::string scene = reference(25, "30");
  const Json page = run_in_page(movie(scene, simulated(scene)), R"js(
    const { replay, data } = player, picture = () => replay.diagram.next.join();
    const states = [];
    for (let k = 0; k <= data.events; ++k) { replay.moveTo(k); states.push(picture()); }
    let same = 0;
    for (let k = data.events; k >= 0; --k) { replay.moveTo(k); same += picture() === states[k]; }
    return { same, events: data.events, distinct: new Set(states).size };)js");
  ASSERT_EQ(page.at("errors"), Json::array());
  const Json& result = page.at("result");
  EXPECT_EQ(result.at("same").get<int>(), result.at("events").get<int>() + 1);
  EXPECT_GT(result.at("distinct"), 20);
}

// Pixels of a grid against the disk that is nearest by definition.
TEST_F(Movie, TheCellsAreWhereTheirDisksAreNearest) {
  const std::string scene = reference(20, "40");
  const std::string history = simulated(scene);
  const DiagramFile truth = diagram(scene, history, 27.25);
  const Json page = run_in_page(movie(scene, history), R"js(
    const { state, view, painter } = player;
    Object.assign(state, { velocities: false, labels: false, flash: 1e-9 });
    player.seek(27.25);
    player.draw();
    const samples = [], { x, y, radius } = player.data.frame;
    for (let i = -30; i <= 30; ++i) for (let j = -30; j <= 30; ++j) {
      const at = view.canvasPoint(i / 30, j / 30).map(Math.floor);
      const place = view.plane(at[0] + 0.5, at[1] + 0.5);
      samples.push([x + radius * place[0], y + radius * place[1], ...painter.context.getImageData(...at, 1, 1).data]);
    }
    return { samples, scale: view.scale / radius, colours: Array.from(painter.colours.own),
      palette: player.data.facts.palette, share: painter.theme.cell };)js");
  ASSERT_EQ(page.at("errors"), Json::array());
  const Json& result = page.at("result");
  const double pixel = 1 / result.at("scale").get<double>(), share = result.at("share");
  int in_cells = 0, in_disks = 0, outside = 0;
  for (const Json& sample : result.at("samples")) {
    const Vec2 place{sample.at(0), sample.at(1)};
    const double wall = truth.container_radius - std::hypot(place[0] - truth.container_center[0],
                                                            place[1] - truth.container_center[1]);
    std::vector<std::pair<double, int>> gaps{{wall, -1}};
    for (std::size_t i = 0; i < truth.disks.size(); ++i) {
      const DiagramDisk& disk = truth.disks[i];
      gaps.emplace_back(
          std::hypot(place[0] - disk.center[0], place[1] - disk.center[1]) - disk.radius, i);
    }
    std::sort(gaps.begin(), gaps.end());
    const auto [gap, nearest] = gaps[0];
    const auto shown = [&](int k) { return sample.at(2 + k).get<int>(); };
    if (wall < -3 * pixel) {
      ++outside;
      EXPECT_EQ(shown(3), 0) << sample;
    }
    // The ink of edges and rims is about two pixels wide.
    if (wall < 3 * pixel || gaps[1].first - gap < 6 * pixel || std::fabs(gap) < 3 * pixel) continue;
    for (int k = 0; k < 3; ++k) {
      double wanted = 255;
      if (nearest >= 0) {
        const std::size_t colour = result.at("colours").at(nearest + 1);
        const double own = result.at("palette").at(colour).at(k);
        wanted = gap < 0 ? own : 255 * (1 - share) + own * share;
      }
      EXPECT_NEAR(shown(k), wanted, 2) << sample << " nearest " << nearest << ", gap " << gap;
    }
    in_disks += nearest >= 0 && gap < 0;
    in_cells += nearest >= 0 && gap > 0;
  }
  EXPECT_GT(outside, 500);
  EXPECT_GT(in_cells, 500);
  EXPECT_GT(in_disks, 100);
}

// Wherever a scene lies and whatever its unit, it is drawn the same.
TEST_F(Movie, FarAndHugeScenesAreDrawnAsNearOnes) {
  const std::string script = R"js(
    player.seek(1.5);
    player.draw();
    const { width, height } = player.view.canvas;
    const { data } = player.painter.context.getImageData(0, 0, width, height);
    const rows = [];
    for (let k = 0; k < data.length; k += 4 * width) {
      rows.push(data.subarray(k, k + 4 * width).reduce((sum, value) => sum + value, 0));
    }
    return rows;)js";
  std::vector<Json> pictures;
  for (const auto& [x, y, unit] : {std::array{0.0, 0.0, 1.0}, std::array{0x1p40, -0x1p41, 1.0},
                                   std::array{0.0, 0.0, 0x1p300}}) {
    Json disks = Json::array();
    for (const auto& [cx, cy, r, vx, vy] :
         {std::array{1.0, 3.5, 1.0, 1.0, 0.5}, std::array{-4.0, 2.0, 2.0, -0.5, 1.0},
          std::array{2.0, -5.0, 0.5, 0.25, -1.0}, std::array{-3.0, -4.0, 1.5, 1.0, 1.0}}) {
      disks.push_back({{"center", {x + unit * cx, y + unit * cy}},
                       {"radius", unit * r},
                       {"velocity", {unit * vx, unit * vy}},
                       {"mass", 1}});
    }
    const Json scene{{"format", "voroproof-scene"},
                     {"version", 1},
                     {"horizon", 4},
                     {"container", {{"center", {x, y}}, {"radius", 10 * unit}}},
                     {"disks", disks}};
    const std::string path = directory_.write("a.scene.json", scene.dump());
    const Json page = run_in_page(movie(path, simulated(path)), script);
    ASSERT_EQ(page.at("errors"), Json::array());
    pictures.push_back(page.at("result"));
  }
  ASSERT_GT(pictures[0].size(), 200);
  EXPECT_NE(pictures[0].at(50), pictures[0].at(100));
  // Positions are rounded far away: some pixels differ by a shade.
  for (const Json& other : {pictures[1], pictures[2]}) {
    ASSERT_EQ(other.size(), pictures[0].size());
    for (std::size_t row = 0; row < other.size(); ++row) {
      EXPECT_NEAR(other.at(row), pictures[0].at(row), 200) << row;
    }
  }
}

}  // namespace
}  // namespace voroproof::internal
