// The movie: what the page computes in the browser against what the program computes of the same
// history, the picture against the definition of a Voronoi diagram, and the controls.
#include <cmath>
#include <map>
#include <set>

#include "history/diagram_file.h"
#include "tests/apps/verbs/browser.h"

namespace voroproof::internal {
namespace {

class Movie : public Cli, protected Browser {
 protected:
  void SetUp() override { require_browser(); }

  std::string simulated(const std::string& scene) const {
    const std::string path = file("a.history.jsonl");
    must({"simulate", scene, "-o", path, "--quiet"});
    return path;
  }

  std::string movie(const std::string& scene, const std::string& history,
                    const Arguments& more = {}) const {
    Arguments arguments{"movie", scene, history, "-o", file("a.html")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    must(arguments);
    return file("a.html");
  }

  DiagramFile diagram(const std::string& scene, const std::string& history, double t) const {
    must({"snapshot", scene, history, "--at", Json(t).dump(), "-o", file("a.diagram.json")});
    return read_diagram(file("a.diagram.json"));
  }

  std::string scene_file(const std::string& disks, const std::string& more = "") const {
    return directory_.write(
        "a.scene.json",
        R"({"format":"voroproof-scene","version":1,"container":{"center":[1,2],"radius":10},)"
        R"("horizon":20,)" +
            more + "\"disks\":[" + disks + "]}\n");
  }

  // The page, sought to these times one after the other, must have the edges, the vertices and the
  // centres that the program has.
  void expect_same(const std::string& scene, const std::string& history,
                   const std::vector<double>& times) {
    const Json page = run_in_page(movie(scene, history), R"js(
      return TIMES.map((t) => {
        player.seek(t);
        player.draw();
        const { diagram } = player.replay, { vertices } = player.painter;
        const { x, y, radius } = player.data.frame;
        const edges = [], circles = [];
        for (let h = 0; h < diagram.halves; h += 2) {
          edges.push(diagram.quad(h).map((site) => site - 1));
        }
        for (let h = 0; h < diagram.halves; ++h) {
          circles.push([[h, diagram.next[h], diagram.next[diagram.next[h]]]
            .map((side) => diagram.org[side] - 1),
            x + radius * vertices.x[h], y + radius * vertices.y[h], radius * vertices.radius[h]]);
        }
        return { edges, circles, x: Array.from(player.motion.x, (u) => x + radius * u),
          y: Array.from(player.motion.y, (u) => y + radius * u), fault: player.replay.fault, irregular: player.painter.curves.irregular };
      });)js",
                                  times);
    ASSERT_EQ(page.at("errors"), Json::array());
    for (std::size_t k = 0; k < times.size(); ++k) {
      const DiagramFile truth = diagram(scene, history, times[k]);
      expect_same(page.at("result").at(k), truth);
      if (HasFailure()) FAIL() << "t = " << times[k];
    }
  }

  // The same with the times put into the script.
  Json run_in_page(const std::string& page, const std::string& script,
                   const std::vector<double>& times) {
    return Browser::run_in_page(page, "const TIMES = " + Json(times).dump() + ";" + script);
  }
  using Browser::run_in_page;

  void expect_same(const Json& shown, const DiagramFile& truth) {
    EXPECT_EQ(shown.at("fault"), Json());
    EXPECT_EQ(shown.at("irregular"), 0);
    std::set<Quad> edges;
    for (const Json& q : shown.at("edges")) {
      edges.insert(canonical(Quad{q.at(0), q.at(1), q.at(2), q.at(3)}));
    }
    EXPECT_EQ(edges, std::set<Quad>(truth.edges.begin(), truth.edges.end()));
    const double near = 1e-7 * truth.container_radius;
    std::map<Triple, DiagramVertex> vertices;
    for (const DiagramVertex& v : truth.vertices) vertices.emplace(v.generators, v);
    EXPECT_EQ(shown.at("circles").size(), 3 * vertices.size());
    for (const Json& c : shown.at("circles")) {
      const Json& g = c.at(0);
      const auto found = vertices.find(canonical(Triple{g.at(0), g.at(1), g.at(2)}));
      ASSERT_NE(found, vertices.end()) << c;
      EXPECT_NEAR(c.at(1), found->second.center[0], near) << c;
      EXPECT_NEAR(c.at(2), found->second.center[1], near) << c;
      EXPECT_NEAR(c.at(3), found->second.radius, near) << c;
    }
    for (std::size_t i = 0; i < truth.disks.size(); ++i) {
      EXPECT_NEAR(shown.at("x").at(i + 1), truth.disks[i].center[0], near);
      EXPECT_NEAR(shown.at("y").at(i + 1), truth.disks[i].center[1], near);
    }
  }
};

// Without a browser.
class MovieFile : public Cli {};

TEST_F(MovieFile, IsOneFileThatNeedsNothingElse) {
  const std::string scene = reference(12, "30");
  must({"simulate", scene, "-o", file("a.history.jsonl")});
  must({"movie", scene, file("a.history.jsonl"), "-o", file("a.html")});
  const std::string page = directory_.read("a.html");
  for (const char* reference : {"http:", "https:", "src=", "@import", "url(", "fetch("}) {
    EXPECT_EQ(page.find(reference), std::string::npos) << reference;
  }
  for (const char* part : {"class Player", "class Diagram", "#picture", "id=\"movie-times\""}) {
    EXPECT_NE(page.find(part), std::string::npos) << part;
  }
  must({"movie", scene, file("a.history.jsonl"), "-o", file("b.html")});
  EXPECT_EQ(page, directory_.read("b.html"));
}

TEST_F(MovieFile, TextOfFilesCannotEndAnElement) {
  const std::string scene = directory_.write(
      "a.scene.json",
      R"({"format":"voroproof-scene","version":1,"name":"</script></title><b>","horizon":1,)"
      R"("container":{"center":[0,0],"radius":10},"disks":[]})");
  must({"simulate", scene, "-o", file("a.history.jsonl")});
  must({"movie", scene, file("a.history.jsonl"), "-o", file("a.html")});
  const std::string page = directory_.read("a.html");
  EXPECT_EQ(page.find("</script></title>"), std::string::npos);
  EXPECT_NE(page.find("<title>&lt;/script&gt;"), std::string::npos);
}

TEST_F(MovieFile, BadRequestsAreRefused) {
  const std::string scene = reference(5, "10");
  must({"simulate", scene, "-o", file("a.history.jsonl")});
  must({"certify", scene, file("a.history.jsonl"), "--report", file("a.report.json")});
  must({"generate", "reference", "--n", "5", "--seed", "9", "-o", file("b.scene.json")});
  must({"simulate", file("b.scene.json"), "-o", file("b.history.jsonl")});
  const std::string page = file("a.html");
  refused({"movie", scene, file("a.history.jsonl"), "-o", page, "--follow", "5"}, "--follow");
  refused({"movie", scene, file("b.history.jsonl"), "-o", page}, "scene_sha256");
  refused({"movie", file("b.scene.json"), file("b.history.jsonl"), "-o", page, "--report",
           file("a.report.json")},
          "another scene");
  refused({"movie", scene, file("a.history.jsonl"), "-o", scene}, "an input as well");
  refused({"movie", scene, file("a.history.jsonl"), "-o", page, "--until", "soon"}, "--until");
}

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

// Such a history has neither an initial diagram nor velocities.
TEST_F(Movie, ReplaysEventSequences) {
  const std::string scene = reference(15, "20");
  const std::string history = simulated(scene), events = file("a.evtsq");
  const DiagramFile truth = diagram(scene, history, 13.5);
  must({"convert", history, "--scene", scene, "-o", events});
  const Json page = run_in_page(movie(scene, events), R"js(
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

TEST_F(Movie, ClicksKeysAndDragsMoveIt) {
  const std::string scene = reference(30, "50");
  const std::string history = simulated(scene);
  const Json page = run_in_page(movie(scene, history, {"--follow", "7"}), R"js(
    const { state, data } = player, at = () => [state.t, state.applied, state.selected];
    const press = (key, more) =>
      window.dispatchEvent(new KeyboardEvent("keydown", { key, ...more }));
    const pointer = (canvas, type, x, y) => canvas.dispatchEvent(new PointerEvent(type,
      { clientX: x + canvas.getBoundingClientRect().x, clientY: y +
        canvas.getBoundingClientRect().y, buttons: 1, bubbles: true }));
    const said = {};
    player.draw();
    said.follow = state.follow;
    const rows = document.querySelectorAll("#events .row");
    said.rows = rows.length;
    rows[3].click();
    said.clicked = at();
    press("ArrowRight");
    said.right = at();
    press("ArrowLeft");
    press("ArrowLeft");
    said.left = at();
    press("Home");
    said.home = at();
    press("ArrowRight", { shiftKey: true });
    said.jump = state.t;
    press("End");
    said.end = at();
    press(" ");  // from the start again
    said.playing = [state.playing, state.t];
    player.last = 1000;
    player.tick(1050);
    said.ticked = state.t / state.rate;
    press(" ");
    said.paused = state.playing;
    const strip = element("timeline"), middle = strip.clientWidth / 2;
    pointer(strip, "pointerdown", middle, 20);
    said.dragged = state.t;
    press("+");
    said.rate = state.rate / player.natural;
    press("Escape");
    said.unfollowed = state.follow;
    player.draw();
    const [x, y] = player.view.canvasPoint(player.motion.x[5], player.motion.y[5]);
    pointer(element("picture"), "pointerdown", x, y);
    pointer(element("picture"), "pointerup", x, y);
    said.chosen = state.follow;
    player.draw();
    said.chips = element("neighbours").children.length;
    element("filter").value = "collisions";
    element("filter").dispatchEvent(new Event("change"));
    said.filtered = [...document.querySelectorAll("#events .row.flip")].length;
    said.times = Array.from(data.times.subarray(0, 6));
    return said;)js");
  ASSERT_EQ(page.at("errors"), Json::array());
  const Json& said = page.at("result");
  const Json& times = said.at("times");
  EXPECT_EQ(said.at("follow"), 7);
  EXPECT_GT(said.at("rows"), 8);
  EXPECT_EQ(said.at("clicked"), Json::array({times.at(3), 4, 3}));
  EXPECT_EQ(said.at("right"), Json::array({times.at(4), 5, 4}));
  EXPECT_EQ(said.at("left"), Json::array({times.at(2), 3, 2}));
  EXPECT_EQ(said.at("home"), Json::array({0, 0, nullptr}));
  EXPECT_EQ(said.at("jump"), 0.5);
  EXPECT_EQ(said.at("end").at(0), 50);
  EXPECT_EQ(said.at("playing"), Json::array({true, 0}));
  EXPECT_NEAR(said.at("ticked"), 0.05, 1e-9);
  EXPECT_EQ(said.at("paused"), false);
  EXPECT_NEAR(said.at("dragged"), 25, 0.1);
  EXPECT_EQ(said.at("rate"), 2);
  EXPECT_EQ(said.at("unfollowed"), Json());
  EXPECT_EQ(said.at("chosen"), 4);
  EXPECT_GE(said.at("chips"), 2);
  EXPECT_EQ(said.at("filtered"), 0);
}

// Two events at one instant are stepped through one by one, and both have happened at its time.
TEST_F(Movie, EventsOfOneInstantAreSteppedThroughOneByOne) {
  const std::string scene = scene_file(
      R"({"center":[-3,2],"radius":1,"velocity":[1,0]},{"center":[5,2],"radius":1,"velocity":[-1,0]},)"
      R"({"center":[1,7],"radius":1,"velocity":[0,1]})");
  const Json page = run_in_page(movie(scene, simulated(scene)), R"js(
    const { data, state } = player;
    const k = data.times.findIndex((t, k) => k > 0 && t === data.times[k - 1]);
    player.look(k - 1);
    const one = state.applied;
    player.step(1);
    const two = state.applied;
    player.seek(data.times[k]);
    return { k, one, two, all: state.applied };)js");
  ASSERT_EQ(page.at("errors"), Json::array());
  const Json& result = page.at("result");
  const int k = result.at("k");
  ASSERT_GT(k, 0);
  EXPECT_EQ(result.at("one"), k);
  EXPECT_EQ(result.at("two"), k + 1);
  EXPECT_GE(result.at("all"), k + 1);
}

TEST_F(Movie, FewDisksAndStoppedHistoriesPlay) {
  const std::string script = R"js(
    for (let k = 0; k <= 20; ++k) { player.seek(player.data.end * k / 20); player.draw(); }
    player.step(-1); player.draw(); player.step(1); player.draw();
    return { end: player.data.end, irregular: player.painter.curves.irregular,
      notes: element("notes").textContent };)js";
  const std::string one = R"({"center":[4,2],"radius":1,"velocity":[1,0.5]})";
  for (const std::string& disks :
       {std::string(), one, one + R"(,{"center":[-3,2],"radius":2,"velocity":[1,1]})"}) {
    const std::string scene = scene_file(disks);
    const Json page = run_in_page(movie(scene, simulated(scene)), script);
    EXPECT_EQ(page.at("errors"), Json::array()) << disks;
    EXPECT_EQ(page.at("result").at("end"), 20);
    EXPECT_EQ(page.at("result").at("irregular"), 0);
  }
  const std::string scene = scene_file(one);
  std::vector<std::string> lines = lines_of(read_bytes(simulated(scene)));
  directory_.write("s.history.jsonl",
                   lines[0] + "\n{\"stopped\":{\"t\":2.5,\"reason\":\"too <hard>\"}}\n");
  const Json page = run_in_page(movie(scene, file("s.history.jsonl")), script);
  EXPECT_EQ(page.at("errors"), Json::array());
  EXPECT_EQ(page.at("result").at("end"), 2.5);
  EXPECT_NE(page.at("result").at("notes").get<std::string>().find("too <hard>"), std::string::npos);
}

TEST_F(Movie, ARefutedHistoryShowsItsFaultAndWhereTheReplayBreaks) {
  const std::string scene = reference(30, "50");
  std::vector<std::string> lines = lines_of(read_bytes(simulated(scene)));
  // One flip is left out. Somewhere later another one is not possible.
  const auto flip = std::find_if(lines.begin() + 40, lines.end(), [](const std::string& line) {
    return line.find("flip") != std::string::npos;
  });
  const auto event = flip - lines.begin() - 1;
  lines.erase(flip);
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  const std::string wrong = directory_.write("w.history.jsonl", text);
  EXPECT_EQ(run({"certify", scene, wrong, "--report", file("w.report.json")}).code, 1);
  const Json page = run_in_page(movie(scene, wrong, {"--report", file("w.report.json")}), R"js(
    const { data, replay, painter, state, view } = player;
    player.toFault();
    Object.assign(state, { velocities: false, labels: false });
    player.draw();
    const count = () => {  // pixels in the colour of the refutation
      const image = painter.context.getImageData(0, 0, view.canvas.width, view.canvas.height);
      let red = 0;
      for (let k = 0; k < image.data.length; k += 4) {
        const [r, g, b] = image.data.subarray(k, k + 3);
        red += Math.abs(r - 216) + Math.abs(g - 52) + Math.abs(b - 43) < 30;
      }
      return red;
    };
    const evidence = count(), faultT = state.t;
    player.seek(0);
    player.draw();
    const before = count();
    player.seek(data.end);
    player.draw();
    return { evidence, before, faultT, badge: element("verdict").textContent,
      event: data.facts.report.fault.event, broken: replay.broken, events: data.events,
      words: element("broken").textContent, whole: replay.whole };)js");
  ASSERT_EQ(page.at("errors"), Json::array());
  const Json& result = page.at("result");
  const Json report = json("w.report.json");
  EXPECT_EQ(result.at("badge"), "refuted");
  EXPECT_EQ(result.at("event"), event);
  EXPECT_NEAR(result.at("faultT"), report.at("divergence").at("t"), 1e-6);
  EXPECT_GT(result.at("evidence"), 200);
  EXPECT_EQ(result.at("before"), 0);
  EXPECT_FALSE(result.at("whole"));
  EXPECT_GT(result.at("broken"), event);
  EXPECT_LE(result.at("broken"), result.at("events"));
  EXPECT_NE(result.at("words").get<std::string>().find("has no edge"), std::string::npos);
}

// The disk slides along the wall at once: there is no diagram to construct.
TEST_F(Movie, AHistoryWithoutAnInitialDiagramIsPlayedAsFarAsItGoes) {
  const std::string scene = scene_file(R"({"center":[1,-7],"radius":1,"velocity":[0,-1]},)"
                                       R"({"center":[3,2],"radius":1,"velocity":[0,0]})",
                                       R"("maneuvers":[{"t":0,"disk":0,"velocity":[1,0]}],)");
  const Result result = run({"simulate", scene, "-o", file("a.history.jsonl"), "--quiet"});
  ASSERT_EQ(result.code, 3) << result.err;
  const Json page = run_in_page(movie(scene, file("a.history.jsonl")), R"js(
    player.draw();
    return element("broken").textContent;)js");
  ASSERT_EQ(page.at("errors"), Json::array());
  EXPECT_NE(page.at("result").get<std::string>().find("slides along"), std::string::npos);
}

TEST_F(Movie, AWrongInitialDiagramIsNoDiagram) {
  const std::string scene = reference(6, "10");
  std::string text = read_bytes(simulated(scene));
  const auto at = text.find("\"initial\":[") + 11;
  text.erase(at, text.find(']', at) + 2 - at);
  const std::string wrong = directory_.write("w.history.jsonl", text);
  const Json page = run_in_page(movie(scene, wrong), R"js(
    player.seek(5);
    player.draw();
    player.follow(2);
    player.draw();
    player.step(1);
    player.draw();
    return element("broken").textContent;)js");
  ASSERT_EQ(page.at("errors"), Json::array());
  EXPECT_NE(page.at("result").get<std::string>().find("initial diagram"), std::string::npos);
}

TEST_F(Movie, AnAddressOpensItAtAPlace) {
  const std::string scene = reference(10, "30");
  const std::string page = movie(scene, simulated(scene), {"--until", "20"});
  const std::string script =
      "return [player.data.end, player.state.t, player.state.applied, player.state.follow, "
      "player.data.times[1], player.data.times.at(-1), innerHeight - "
      "element('picture').clientHeight];";
  Json said = run_in_page(page, script, "#t=12.5&follow=3").at("result");
  EXPECT_EQ(said.at(0), 20);
  EXPECT_EQ(said.at(1), 12.5);
  EXPECT_EQ(said.at(3), 3);
  EXPECT_LE(said.at(5), 20);
  // Wide or narrow, the whole window is the picture's.
  for (const char* window : {"1000,700", "600,600"}) {
    said = run_in_page(page, script, "#event=2&bare", window).at("result");
    EXPECT_EQ(said.at(1), said.at(4));
    EXPECT_EQ(said.at(2), 2);
    EXPECT_EQ(said.at(6), 0) << window;
  }
}

}  // namespace
}  // namespace voroproof::internal
