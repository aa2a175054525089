// Movies of histories that stop, are refuted or have no diagram at the beginning, and of few disks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/apps/movie/movie.h"

namespace voroproof::internal {
namespace {

// A history without one of its flips, and its report in w.report.json.
class BrokenMovie : public Movie {
 protected:
  struct Wrong {
    std::string history;
    std::ptrdiff_t event;  // the number of the flip that is left out, from 0
    double t;              // its time
  };
  Wrong without_a_flip(const std::string& scene) const {
    std::vector<std::string> lines = lines_of(read_bytes(simulated(scene)));
    const auto flip = std::find_if(lines.begin() + 40, lines.end(), [](const std::string& line) {
      return line.find("flip") != std::string::npos;
    });
    const double t = Json::parse(*flip).at("t");
    const auto event = flip - lines.begin() - 1;
    lines.erase(flip);
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    const std::string history = directory_.write("w.history.jsonl", text);
    EXPECT_EQ(run({"certify", scene, history, "--report", file("w.report.json")}).code, 1);
    return {history, event, t};
  }
};

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

TEST_F(BrokenMovie, ARefutedHistoryShowsItsFaultAndWhereTheReplayBreaks) {
  const std::string scene = reference(30, "50");
  // Somewhere later another flip is not possible.
  const auto [wrong, event, t] = without_a_flip(scene);
  const Json page = run_in_page(movie(scene, wrong, {"--report", file("w.report.json")}), R"js(
    const { data, replay, painter, state, view } = player;
    player.toFault();
    Object.assign(state, { velocities: false, labels: false });
    player.draw();
    const count = () => {  // pixels in the colour of the refutation
      const colour = [1, 3, 5].map((k) => parseInt(painter.theme.refuted.slice(k, k + 2), 16));
      const image = painter.context.getImageData(0, 0, view.canvas.width, view.canvas.height);
      let red = 0;
      for (let k = 0; k < image.data.length; k += 4) {
        const off = colour.reduce((sum, c, i) => sum + Math.abs(image.data[k + i] - c), 0);
        red += off < 30;
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

// The report counts the events of the whole history.
TEST_F(BrokenMovie, ARefutedHistoryIsShownFromTheMiddle) {
  const std::string scene = reference(30, "50");
  const auto [wrong, event, t] = without_a_flip(scene);
  const auto standing = [&, &history = wrong](const std::string& from) {
    const Json page = run_in_page(
        movie(scene, history, {"--report", file("w.report.json"), "--from", from}), R"js(
      const { data, list } = player, certified = [], faults = [];
      for (let k = 0; k < Math.min(data.events, 60); ++k) {
        if (list.standing(k) === "certified") certified.push(k + data.facts.leftOut);
        if (list.standing(k).includes("missing")) faults.push(k + data.facts.leftOut);
      }
      return { certified, faults, leftOut: data.facts.leftOut };)js");
    EXPECT_EQ(page.at("errors"), Json::array());
    return page.at("result");
  };
  const Json before = standing(Json(t / 2).dump());
  const auto left_out = before.at("leftOut").get<std::int64_t>();
  EXPECT_GT(left_out, 0);
  ASSERT_LT(left_out, event);
  EXPECT_EQ(before.at("faults"), Json({event}));
  EXPECT_EQ(before.at("certified").size(), event - left_out);
  EXPECT_EQ(before.at("certified").front(), left_out);
  const Json after = standing(Json(t + 1).dump());
  EXPECT_EQ(after.at("faults"), Json::array());
  EXPECT_EQ(after.at("certified"), Json::array());
}

// What happens before a movie begins may be what makes no sense.
TEST_F(Movie, AHistoryThatBreaksBeforeTheMovieBeginsHasNoDiagram) {
  const std::string scene = reference(30, "50");
  std::vector<std::string> lines = lines_of(read_bytes(simulated(scene)));
  const auto flip = std::find_if(lines.begin(), lines.end(), [](const std::string& line) {
    return line.find("\"flip\"") != std::string::npos;
  });
  const auto number = flip - lines.begin() + 2;
  lines.insert(flip, *flip);
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  const std::string wrong = directory_.write("w.history.jsonl", text);
  const Json page = run_in_page(movie(scene, wrong, {"--from", "40"}), R"js(
    player.seek(player.data.end);
    player.draw();
    return { words: element("broken").textContent, x: Array.from(player.motion.x) };)js");
  ASSERT_EQ(page.at("errors"), Json::array());
  EXPECT_NE(page.at("result").at("words").get<std::string>().find(
                "the flip on line " + std::to_string(number) + " is of no edge"),
            std::string::npos)
      << page;
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

}  // namespace
}  // namespace voroproof::internal
