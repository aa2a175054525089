// The verb snapshot: diagrams from a history and from scratch, and histories that it refuses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "tests/apps/verbs/cli.h"
#include "tests/apps/verbs/small_scenes.h"

namespace voroproof::internal {
namespace {

TEST_F(Cli, SnapshotsFromTheHistoryAndFromScratchHaveTheSameEdges) {
  const std::string scene = reference(40, "20", "8");
  const std::string history = file("a.history.jsonl");
  must({"simulate", scene, "-o", history});
  std::set<std::string> seen;
  for (const char* t : {"0", "1/3", "0.1", "7.5", "0x1.8p3", "16", "19.99", "20"}) {
    must({"snapshot", scene, "--at", t, "-o", file("a.diagram.json")});
    must({"snapshot", scene, history, "--at", t, "-o", file("b.diagram.json")});
    must({"validate", file("a.diagram.json"), file("b.diagram.json")});
    const Json a = json("a.diagram.json"), b = json("b.diagram.json");
    EXPECT_EQ(a["edges"], b["edges"]) << t;
    EXPECT_EQ(a["t"], b["t"]);
    EXPECT_EQ(a["scene_sha256"], b["scene_sha256"]);
    EXPECT_EQ(a["edges"].size(), 3u * 41 - 6);
    for (std::size_t i = 0; i < 40; ++i) {
      for (const int k : {0, 1}) {
        EXPECT_EQ(a["disks"][i]["velocity"][k], b["disks"][i]["velocity"][k]);
        EXPECT_NEAR(a["disks"][i]["center"][k], b["disks"][i]["center"][k], 1e-9);
      }
    }
    ASSERT_EQ(a["vertices"].size(), b["vertices"].size());
    for (std::size_t i = 0; i < a["vertices"].size(); ++i) {
      EXPECT_EQ(a["vertices"][i]["generators"], b["vertices"][i]["generators"]);
      // Each circle touches its generators.
      const Json& v = a["vertices"][i];
      const double x = v["center"][0], y = v["center"][1], radius = v["radius"];
      for (const int g : v["generators"]) {
        const Json& generator = g < 0 ? a["container"] : a["disks"][g];
        const double distance = std::hypot(x - generator["center"][0].get<double>(),
                                           y - generator["center"][1].get<double>());
        const double reach = generator["radius"];
        EXPECT_NEAR(radius, g < 0 ? reach - distance : distance - reach, 1e-8);
      }
    }
    seen.insert(a["edges"].dump());
  }
  EXPECT_GT(seen.size(), 4u);  // there was something to follow
  EXPECT_EQ(json("b.diagram.json")["t"], 20);
}

TEST_F(Cli, SnapshotsAtAnEventShowWhatIsJustAfterIt) {
  const std::string scene = directory_.write(
      "a.scene.json", scene_text(R"({"center": [0, 0], "radius": 1, "velocity": [1, 0]},
{"center": [6, 0], "radius": 1, "velocity": [-1, 0]})",
                                 R"( "maneuvers": [{"t": 3, "disk": 0, "velocity": [0, 0.5]}],)"));
  const std::string history = file("a.history.jsonl");
  must({"simulate", scene, "-o", history});
  // They meet at t = 2 at x = 2 and x = 4 and turn back.
  for (const bool recorded : {false, true}) {
    const auto velocities = [&](const char* t) {
      Arguments arguments{"snapshot", scene, "--at", t, "-o", file("a.diagram.json")};
      if (recorded) arguments.insert(arguments.begin() + 2, history);
      must(arguments);
      const Json diagram = json("a.diagram.json");
      return Json{diagram["disks"][0]["velocity"], diagram["disks"][1]["velocity"]};
    };
    EXPECT_EQ(velocities("1.999999999999999999999"), Json::parse("[[1,0],[-1,0]]"));
    EXPECT_EQ(velocities("2"), Json::parse("[[-1,0],[1,0]]"));
    EXPECT_EQ(json("a.diagram.json")["disks"][0]["center"], Json::parse("[2,0]"));
    EXPECT_EQ(velocities("3"), Json::parse("[[0,0.5],[1,0]]"));
    EXPECT_EQ(velocities("3.5"), Json::parse("[[0,0.5],[1,0]]"));
    EXPECT_EQ(json("a.diagram.json")["disks"][0]["center"], Json::parse("[1,0.25]"));
  }
}

TEST_F(Cli, SnapshotsOfFewDisks) {
  for (const int n : {0, 1, 2, 3}) {
    const std::string scene = reference(n, "30");
    must({"simulate", scene, "-o", file("a.history.jsonl")});
    must({"snapshot", scene, "--at", "30", "-o", file("a.diagram.json")});
    must({"snapshot", scene, file("a.history.jsonl"), "--at", "30", "-o", file("b.diagram.json")});
    const Json a = json("a.diagram.json"), b = json("b.diagram.json");
    EXPECT_EQ(a["edges"], b["edges"]);
    EXPECT_EQ(a["edges"].size(), n < 2 ? 0u : 3u * (n + 1) - 6);
    EXPECT_EQ(a["disks"].size(), static_cast<std::size_t>(n));
    must({"render", file("a.diagram.json"), "-o", file("a.svg")});
  }
}

TEST_F(Cli, SnapshotsDoWithoutWhatAHistoryLeavesOut) {
  const std::string scene = reference(20, "20");
  must({"simulate", scene, "-o", file("a.history.jsonl")});
  std::string bare;
  for (const std::string& line : lines_of(directory_.read("a.history.jsonl"))) {
    nlohmann::ordered_json json = nlohmann::ordered_json::parse(line);
    for (const char* key : {"initial", "v", "p"}) json.erase(key);
    bare += json.dump() + "\n";
  }
  const std::string history = directory_.write("bare.history.jsonl", bare);
  must({"snapshot", scene, "--at", "13", "-o", file("a.diagram.json")});
  must({"snapshot", scene, history, "--at", "13", "-o", file("b.diagram.json")});
  EXPECT_EQ(directory_.read("a.diagram.json"), directory_.read("b.diagram.json"));
}

TEST_F(Cli, SnapshotsRefuseHistoriesThatDoNotFit) {
  const std::string scene = reference(20, "20");
  const std::string out = file("out");
  const std::string history = file("a.history.jsonl");
  must({"simulate", scene, "-o", history});
  const std::string bytes = directory_.read("a.history.jsonl");
  refused({"snapshot", scene, history, "--at", "20.5", "-o", out}, "a.history.jsonl:1: horizon: ");

  const std::string other = directory_.write("other.scene.json", scene_text(two_disks));
  refused({"snapshot", other, history, "--at", "1", "-o", out}, "a.history.jsonl:1: ");

  // One flip left out: a later one names an edge that has not come to be.
  std::vector<std::string> lines = lines_of(bytes);
  const auto is_flip = [](const std::string& line) {
    return line.find("\"flip\":") != std::string::npos;
  };
  const auto first = std::find_if(lines.begin(), lines.end(), is_flip);
  ASSERT_NE(first, lines.end());
  const std::string repeated = *first;
  lines.insert(first + 1, repeated);
  const auto place = std::find(lines.begin(), lines.end(), repeated) - lines.begin() + 2;
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  const std::string twice = directory_.write("twice.history.jsonl", text);
  refused({"snapshot", scene, twice, "--at", "20", "-o", out},
          "twice.history.jsonl:" + std::to_string(place) + ": flip: ");

  // An initial diagram without its last edge.
  std::string torn = bytes;
  const std::size_t end = torn.find("]]}");
  const std::size_t comma = torn.rfind(",[", end);
  torn.erase(comma, end + 1 - comma);
  const std::string initial = directory_.write("torn.history.jsonl", torn);
  refused({"snapshot", scene, initial, "--at", "1", "-o", out}, "torn.history.jsonl:1: initial: ");

  // A history that was cut off.
  const std::string cut = directory_.write("cut.history.jsonl", bytes.substr(0, bytes.size() / 2));
  refused({"snapshot", scene, cut, "--at", "0", "-o", out}, "cut.history.jsonl:");
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

// A history whose last flip is missing leads to an edge that is illegal from there on.
TEST_F(Cli, SnapshotsRefuseWhatIsNoDiagramOfTheDisks) {
  const std::string scene = reference(30, "20"), out = file("a.diagram.json");
  must({"simulate", scene, "-o", file("a.history.jsonl")});
  std::vector<std::string> lines = lines_of(directory_.read("a.history.jsonl"));
  const auto is_flip = [](const std::string& line) {
    return line.find("\"flip\":") != std::string::npos;
  };
  const auto last = std::find_if(lines.rbegin(), lines.rend(), is_flip);
  ASSERT_NE(last, lines.rend());
  const Json flip = Json::parse(*last);
  lines.erase(std::next(last).base());
  Json end = Json::parse(lines.back());
  end["end"]["flips"] = end["end"]["flips"].get<int>() - 1;
  lines.back() = end.dump();
  const std::string wrong = directory_.write("wrong.history.jsonl", joined(lines));

  const std::string before = Json(flip["t"].get<double>() - 1e-3).dump();
  must({"snapshot", scene, wrong, "--at", before, "-o", out});
  const Result result = run({"snapshot", scene, wrong, "--at", "20", "-o", file("b.json")});
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(
      result.err.find("wrong.history.jsonl: its diagram at t = 20 is not that of the disks: "),
      std::string::npos)
      << result.err;
  EXPECT_NE(result.err.find(" deep inside the circle of ["), std::string::npos) << result.err;
  EXPECT_FALSE(std::filesystem::exists(file("b.json")));
  must({"snapshot", scene, wrong, "--at", "20", "--unchecked", "-o", out});
  must({"snapshot", scene, wrong, "--at", "20", "--construct", "1", "-o", out});
  refused({"snapshot", scene, "--at", "20", "--unchecked", "-o", out}, "none is given");
}

// Times that are off by less than the tolerance of certificates are no reason to refuse a history.
TEST_F(Cli, SnapshotsTakeTimesWithinTheTolerance) {
  const std::string scene = reference(30, "20"), history = file("a.history.jsonl");
  must({"simulate", scene, "-o", history});
  std::vector<std::string> lines = lines_of(directory_.read("a.history.jsonl"));
  std::vector<double> times;
  for (std::string& line : lines) {
    Json json = Json::parse(line);
    if (!json.contains("flip")) continue;
    const double t = json["t"];
    const double off = times.size() % 2 == 0 ? 4e-7 : -4e-7;
    json["t"] = t + off;
    times.push_back(t + 0.5 * off);
    line = json.dump();
  }
  std::stable_sort(lines.begin() + 1, lines.end() - 1, [](const auto& a, const auto& b) {
    return Json::parse(a)["t"].template get<double>() < Json::parse(b)["t"].template get<double>();
  });
  const std::string moved = directory_.write("moved.history.jsonl", joined(lines));
  ASSERT_EQ(run({"certify", scene, moved}).code, 0);
  ASSERT_GT(times.size(), 20u);
  for (const double t : times) {
    must({"snapshot", scene, moved, "--at", Json(t).dump(), "-o", file("a.diagram.json")});
  }
}

}  // namespace
}  // namespace voroproof::internal
