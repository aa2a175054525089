// voroproof query and render --probe, as users meet them.
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "tests/apps/verbs/cli.h"

namespace voroproof::internal {
namespace {

class QueryCli : public Cli {
 protected:
  void SetUp() override {
    scene_ = reference(12, "20");
    history_ = file("a.history.jsonl");
    must({"simulate", scene_, "-o", history_});
  }
  // Runs the query, with its answer in a file as well.
  Json ask(Arguments arguments) {
    arguments.insert(arguments.begin(), "query");
    arguments.insert(arguments.end(), {"-o", file("answer.json")});
    const Result result = must(arguments);
    EXPECT_NE(result.out, "");
    Json answer = json("answer.json");
    EXPECT_EQ(answer["format"], "voroproof-answer");
    EXPECT_EQ(answer["query"], arguments[1]);
    return answer;
  }
  static void expect_narrow(const Json& enclosure) {
    ASSERT_EQ(enclosure.size(), 2u) << enclosure;
    const double lo = enclosure[0], hi = enclosure[1];
    EXPECT_LE(lo, hi);
    EXPECT_LE(hi - lo, 1e-12 * (1 + std::abs(hi)));
  }

  std::string scene_, history_;
};

TEST_F(QueryCli, AnInstantByTheEngineAndByAHistory) {
  for (const Arguments& query : {Arguments{"nearest", "--point", "-1/3", "2.5", "--count", "5"},
                                 {"neighbours", "--disk", "3"},
                                 {"closest"},
                                 {"offset", "--probe", "2"},
                                 {"voids", "--probe", "2"},
                                 {"critical"}}) {
    Arguments alone = query, with = query;
    alone.insert(alone.end(), {scene_, "--at", "17/2"});
    with.insert(with.end(), {scene_, history_, "--at", "17/2"});
    EXPECT_EQ(ask(alone), ask(with));
  }
  const Json nearest = ask({"nearest", scene_, "--at", "1/3", "--point", "0", "-1e-3"});
  EXPECT_EQ(nearest["t"], "1/3");
  EXPECT_EQ(nearest["point"], Json::parse("[0,\"-1/1000\"]"));
  ASSERT_EQ(nearest["disks"].size(), 1u);
  expect_narrow(nearest["disks"][0]["distance"]);
  const Json voids = ask({"voids", scene_, "--at", "3", "--probe", "1"});
  ASSERT_GE(voids["voids"].size(), 1u);
  expect_narrow(voids["voids"][0]["vanishes"]);
  EXPECT_EQ(ask({"critical", scene_, "--at", "3"})["tunnels"].size(), 33u);
}

TEST_F(QueryCli, AWindowOfTime) {
  const Json closest = ask({"closest-over", scene_, history_});
  EXPECT_EQ(closest["to"], 20);
  EXPECT_EQ(closest["contact"], true);  // a dense scene
  EXPECT_EQ(closest["gap"], Json::parse("[0,0]"));
  const Json gap = ask({"gap-over", scene_, history_, "--pair", "-1", "4", "--horizon", "1/2"});
  expect_narrow(gap["gap"]);
  expect_narrow(gap["t"]);
  EXPECT_GE(ask({"neighbours-over", scene_, history_, "--disk", "4"})["neighbours"].size(), 2u);
  // The points of the gap's gate are passed by a probe of radius 0 whenever the two are neighbours.
  const Json open = ask({"tunnel", scene_, history_, "--pair", "-1", "4", "--probe", "0"});
  ASSERT_GE(open["open"].size(), 1u);
  expect_narrow(open["open"][0]["from"]);
  ask({"void", scene_, history_, "--vertex", "0", "1", "2", "--probe", "1"});
  const Json voids = ask({"voids-over", scene_, history_, "--probe", "2"})["voids"];
  ASSERT_GE(voids.size(), 1u);
  EXPECT_EQ(voids[0]["from"], Json::parse("[0,0]"));
  expect_narrow(voids[0]["to"]);
}

// A history of half the time: its own horizon is where questions end that name no other.
TEST_F(QueryCli, UpToTheHistorysHorizon) {
  const std::string half = file("half.history.jsonl");
  must({"simulate", scene_, "--horizon", "10", "-o", half});
  EXPECT_EQ(ask({"closest-over", scene_, half})["to"], 10);
  refused({"query", "closest-over", scene_, half, "--horizon", "11"}, "horizon: ");
}

// The table of critical radii is in their order, the answer in that of the edges.
TEST_F(QueryCli, CriticalRadiiInOrder) {
  std::istringstream table(must({"query", "critical", scene_, "--at", "3"}).out);
  std::string line;
  std::getline(table, line);
  double last = -1;
  int rows = 0;
  for (; std::getline(table, line); ++rows) {
    const double radius = std::stod(line);
    EXPECT_GE(radius, last);
    last = radius;
  }
  EXPECT_GT(rows, 33);
}

TEST_F(QueryCli, Refusals) {
  const std::string out = file("out.json");
  struct Case {
    Arguments arguments;
    std::string message;
  };
  for (const Case& c : std::vector<Case>{
           {{"query"}, "no verb given"},
           {{"query", "farthest", scene_}, "unknown verb farthest"},
           {{"query", "closest", scene_, "--at", "-1"}, "--at: -1: negative"},
           {{"query", "closest", scene_, "--at", "1", "-o", scene_}, "is an input as well"},
           {{"query", "closest", scene_, scene_, "--at", "1", "-o", out}, ":1: "},
           {{"query", "closest", scene_, history_, "--at", "21", "-o", out}, "horizon: "},
           {{"query", "nearest", scene_, "--at", "1", "--point", "a", "b"}, "--point: a: "},
           {{"query", "neighbours", scene_, "--at", "1", "--disk", "12"}, "--disk: "},
           {{"query", "voids", scene_, "--at", "1", "--probe", "-1"}, "--probe: -1: negative"},
           {{"query", "gap-over", scene_, history_, "--pair", "3", "3"}, "--pair: "},
           {{"query", "gap-over", scene_, history_, "--pair", "3", "12"}, "--pair: "},
           {{"query", "gap-over", scene_, history_, "--pair", "3", "4", "--horizon", "21"},
            "horizon: "},
           {{"query", "closest-over", scene_, history_, "--from", "2", "--horizon", "1"},
            "--horizon: "},
           {{"query", "tunnel", scene_, history_, "--pair", "3", "4", "--probe", "1", "--from", "2",
             "--horizon", "2"},
            "--horizon: not after --from"},
           {{"query", "voids-over", scene_, history_, "--probe", "-1"}, "--probe: -1: negative"},
           {{"query", "neighbours-over", scene_, history_, "--disk", "-1"}, "--disk: "}}) {
    refused(c.arguments, c.message);
  }
}

// A disk that is claimed to fly far out of the container has no cell on the recorded paths.
TEST_F(QueryCli, PathsThatDoNotFitTheDiagramAreTheHistorysFault) {
  std::string text;
  bool leapt = false;
  for (const std::string& line : lines_of(directory_.read("a.history.jsonl"))) {
    Json json = Json::parse(line);
    if (!leapt && json.contains("collide") && json["collide"] == Json::parse("[7,8]")) {
      json["v"][1][0] = -4e16;
      leapt = true;
    }
    text += json.dump() + '\n';
  }
  ASSERT_TRUE(leapt);
  const std::string leap = directory_.write("leap.history.jsonl", text);
  refused({"query", "voids-over", scene_, leap, "--probe", "1"},
          leap + ": the recorded paths do not fit the claimed diagram");
}

TEST_F(QueryCli, FewDisks) {
  for (const std::string& disks :
       {std::string(), std::string(R"({"center":[1,0],"radius":1,"velocity":[0,0]})")}) {
    const std::string scene = directory_.write(
        "few.scene.json", R"({"format":"voroproof-scene","version":1,"container":{"center":[0,0],)"
                          R"("radius":10},"horizon":1,"disks":[)" +
                              disks + "]}");
    for (const Arguments& query : {Arguments{"nearest", "--point", "0", "0"},
                                   {"closest"},
                                   {"offset", "--probe", "1"},
                                   {"voids", "--probe", "1"},
                                   {"critical"}}) {
      Arguments arguments{"query"};
      arguments.insert(arguments.end(), query.begin(), query.end());
      arguments.insert(arguments.end(), {scene, "--at", "0"});
      must(arguments);
    }
    must({"snapshot", scene, "--at", "0", "-o", file("few.diagram.json")});
    must({"render", file("few.diagram.json"), "--probe", "1", "-o", file("few.svg")});
  }
}

TEST_F(QueryCli, APictureOfAProbe) {
  must({"snapshot", scene_, "--at", "3", "-o", file("d.json")});
  must({"render", file("d.json"), "-o", file("plain.svg")});
  must({"render", file("d.json"), "--probe", "2", "-o", file("probe.svg")});
  must({"render", file("d.json"), "--probe", "2", "-o", file("again.svg")});
  EXPECT_NE(directory_.read("plain.svg"), directory_.read("probe.svg"));
  EXPECT_EQ(directory_.read("again.svg"), directory_.read("probe.svg"));
  must({"render", file("d.json"), "--probe", "1e9", "-o", file("wide.svg")});
  refused({"render", file("d.json"), "--probe", "-2", "-o", file("x.svg")}, "--probe: -2");
}

// The paths alone tell the gap; but flips that cannot be are no history.
TEST_F(QueryCli, TheClosestOverTimeOfFlipsThatDoNotFitAreRefused) {
  std::vector<std::string> lines = lines_of(directory_.read("a.history.jsonl")), flips;
  std::size_t first = 0;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    if (lines[k].find("\"flip\"") == std::string::npos) continue;
    if (first == 0) first = k;
    flips.push_back(Json::parse(lines[k])["flip"].dump());
  }
  Json changed = Json::parse(lines[first]);
  changed["flip"] = Json::parse(flips.back());
  ASSERT_NE(flips.front(), flips.back());
  lines[first] = changed.dump();
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  directory_.write("a.history.jsonl", text);
  refused({"query", "closest-over", scene_, history_}, "flip: the diagram has no edge");
}

}  // namespace
}  // namespace voroproof::internal
