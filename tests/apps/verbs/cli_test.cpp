// The program as its users meet it: exit codes, messages, files that appear whole or not at all,
// bytes that depend on nothing but the scene.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/apps/verbs/cli.h"

namespace voroproof::internal {
namespace {

std::string scene_text(const std::string& disks, const std::string& more = "") {
  return R"({"format": "voroproof-scene", "version": 1,
 "container": {"center": [0, 0], "radius": 10},
 "horizon": 5,)" +
         more + R"(
 "disks": [
)" + disks +
         "]}\n";
}

const std::string two_disks =
    R"({"center": [-3, 0], "radius": 1, "velocity": [1, 0]},
{"center": [3, 1], "radius": 2, "velocity": [-1, 0]})";

TEST_F(Cli, EveryVerbHasHelpThatEndsInAnExample) {
  const std::vector<Arguments> verbs{{},
                                     {"generate"},
                                     {"generate", "reference"},
                                     {"generate", "grid"},
                                     {"generate", "swarm"},
                                     {"generate", "formation"},
                                     {"simulate"},
                                     {"snapshot"},
                                     {"query"},
                                     {"query", "nearest"},
                                     {"query", "neighbours"},
                                     {"query", "closest"},
                                     {"query", "offset"},
                                     {"query", "voids"},
                                     {"query", "critical"},
                                     {"query", "neighbours-over"},
                                     {"query", "gap-over"},
                                     {"query", "closest-over"},
                                     {"query", "tunnel"},
                                     {"query", "void"},
                                     {"render"},
                                     {"validate"}};
  for (Arguments verb : verbs) {
    std::string name = "voroproof";
    for (const std::string& word : verb) name += " " + word;
    verb.push_back("--help");
    const Result help = must(verb);
    const std::vector<std::string> lines = lines_of(help.out);
    ASSERT_GT(lines.size(), 5u) << name;
    EXPECT_EQ(lines[lines.size() - 2], "Example:") << name;
    EXPECT_EQ(lines.back().rfind("  " + name, 0), 0u) << lines.back();
    EXPECT_NE(help.out.find("Usage: " + name), std::string::npos) << help.out;
  }
  EXPECT_EQ(must({"--version"}).out.rfind("voroproof ", 0), 0u);
  for (const char* verb : {"generate", "simulate", "snapshot", "query", "render", "validate"}) {
    EXPECT_NE(must({"--help"}).out.find("\n  " + std::string(verb)), std::string::npos);
  }
}

TEST_F(Cli, UsageErrors) {
  const std::string scene = directory_.write("a.scene.json", scene_text(two_disks));
  const std::string out = file("out"), table = directory_.write("table.csv", "n,t\n1,2\n");
  struct Case {
    Arguments arguments;
    std::string message;
  };
  const std::vector<Case> cases{
      {{}, "no verb given"},
      {{"simulat"}, "unknown verb or option simulat"},
      {{"--loud"}, "unknown verb or option --loud"},
      {{"a\nb"}, "unknown verb or option a\\x0ab"},
      {{"generate"}, "no verb given (see voroproof generate --help)"},
      {{"generate", "cloud"}, "unknown verb or option cloud"},
      {{"generate", "grid"}, "--output is required"},
      {{"generate", "grid", "-o", out, "--n", "-1"}, "--n: -1 is not a whole number"},
      {{"generate", "grid", "-o", out, "--n", "1e3"}, "--n: 1e3 is not a whole number"},
      {{"generate", "grid", "-o", out, "--n", "010"}, "--n: 010 is not a whole number"},
      {{"generate", "grid", "-o", out, "--n", "2000001"}, "--n: "},
      {{"generate", "grid", "-o", out, "--seed", "18446744073709551616"}, "--seed: "},
      {{"generate", "grid", "-o", out, "--radius", "0"}, "radius must be positive"},
      {{"generate", "grid", "-o", out, "--radius", "nan"}, "--radius: nan"},
      {{"generate", "grid", "-o", out, "--speed", "1e999"}, "--speed: 1e999"},
      {{"generate", "grid", "-o", out, "--speed", "1e101"}, "no valid scene"},
      {{"generate", "grid", "-o", out, "--speed", "1 "}, "--speed: 1 "},
      {{"generate", "grid", "-o", out, "--motion", "2"}, "--motion: 2 not in"},
      {{"generate", "reference", "-o", out, "--radii", "big"}, "--radii: big not in"},
      {{"generate", "reference", "-o", out, "--density", "0.95", "--n", "50"}, "no free place"},
      {{"generate", "formation", "-o", out, "--n", "5001"}, "--n: "},
      {{"generate", "formation", "-o", out, "--flight", "east"}, "begins with a formation"},
      {{"generate", "formation", "-o", out, "--flight", "h,,y"}, "no formation is called ''"},
      {{"generate", "formation", "-o", out, "--radius", "3"}, "more than twice the radius"},
      {{"generate", "formation", "-o", out, "--preset", "h-to-y", "--n", "3"}, "--n excludes"},
      {{"generate", "reference", "-o", file("no/out")}, "no/out: cannot write"},
      {{"simulate"}, "scene is required"},
      {{"simulate", scene}, "--output is required"},
      {{"simulate", scene, "-o", out, "again"}, "not expected"},
      {{"simulate", scene, "-o", out, "-o", out}, "--output"},
      {{"simulate", scene, "-o", out, "--fast"}, "--fast"},
      {{"simulate", scene, "-o", scene}, "is an input as well as an output"},
      {{"simulate", scene, "-o", out, "--stats", out}, "is named for two outputs"},
      {{"simulate", scene, "-o", out, "--stats", file("./out")}, "is named for two outputs"},
      {{"simulate", scene, "-o", file("no/out")}, "no/out: cannot write"},
      {{"simulate", scene, "-o", out, "--stats", file("no/out")}, "no/out: cannot write"},
      {{"simulate", scene, "-o", "/dev/null"}, "is not a regular file"},
      {{"simulate", scene, "-o", out, "--horizon", "1/0"}, "--horizon: 1/0"},
      {{"simulate", scene, "-o", out, "--horizon", "-1"}, "--horizon: -1: negative"},
      {{"simulate", scene, "-o", out, "--horizon", "nan"}, "--horizon: nan"},
      {{"simulate", scene, "-o", out, "--horizon", "1e101"}, "--horizon: 1e101: beyond"},
      {{"simulate", scene, "-o", out, "--horizon", ""}, "--horizon: is empty"},
      {{"simulate", scene, "-o", ""}, "--output: is empty"},
      {{"simulate", scene, "-o", out, "--stats", ""}, "--stats: is empty"},
      {{"simulate", scene, "-o", out, "--threads", "0"}, "--threads"},
      {{"simulate", scene, "-o", out, "--threads", "two"}, "--threads"},
      {{"simulate", scene, "-o", out, "--start-bits", "63"}, "--start-bits"},
      {{"simulate", scene, "-o", out, "--start-bits", "500", "--max-bits", "400"}, "--max-bits"},
      {{"simulate", scene, "-o", out, "--filters", "maybe"}, "--filters: maybe"},
      {{"simulate", file("none"), "-o", out}, "none: cannot read"},
      {{"simulate", file(""), "-o", out}, "cannot read"},
      {{"snapshot", scene, "-o", out}, "--at is required"},
      {{"snapshot", scene, "-o", out, "--at", "soon"}, "--at: soon"},
      {{"snapshot", scene, "-o", out, "--at", "1", "--move", "1"}, "--move and --construct are"},
      {{"snapshot", scene, scene, "-o", out, "--at", "1", "--move", "4"}, "--move"},
      {{"snapshot", scene, "-o", out, "--at", "-1"}, "--at: -1: negative"},
      {{"snapshot", scene, "-o", scene, "--at", "1"}, "is an input as well as an output"},
      {{"snapshot", scene, scene, "-o", out, "--at", "1"}, "a.scene.json:1: "},
      {{"render", scene, "-o", file("a.svg")}, "a.scene.json:1: format: "},
      {{"render", scene, "-o", file("a.svg"), "--size", "15"}, "--size"},
      {{"validate"}, "files is required"},
      {{"validate", file("none")}, "none: cannot read"},
      {{"validate", table}, "table.csv:1: expected an object, found 'n'"},
      {{"snapshot", scene, file(""), "-o", out, "--at", "1"}, file("") + ": cannot read"},
  };
  for (const Case& c : cases) refused(c.arguments, c.message);
}

TEST_F(Cli, BadScenesAreRefusedWithLineAndField) {
  const auto disk = [](const std::string& center, const std::string& radius,
                       const std::string& velocity, const std::string& more = "") {
    return R"({"center": )" + center + R"(, "radius": )" + radius + R"(, "velocity": )" + velocity +
           more + "}";
  };
  const std::string good = disk("[0, 0]", "1", "[1, 0]");
  const std::string whole = scene_text(two_disks);
  struct Case {
    std::string text, message;
  };
  const std::vector<Case> cases{
      {scene_text(good + ",\n" + disk("[1.5, 0]", "1", "[0, 0]")), ":6: disks[1]: "},  // overlap
      {scene_text(good + ",\n" + disk("[9.5, 0]", "1", "[0, 0]")), ":6: disks[1]: "},  // outside
      {scene_text(disk("[NaN, 0]", "1", "[0, 0]")), ":5: disks[0].center[0]: "},
      {scene_text(disk("[0, 0]", "Infinity", "[0, 0]")), ":5: disks[0].radius: "},
      {scene_text(disk("[0, 0]", "1", "[1e999, 0]")), ":5: disks[0].velocity[0]: "},
      {scene_text(disk("[0, 0]", "1", R"(["1e101", 0])")), ":5: disks[0].velocity[0]: "},
      {scene_text(disk("[0, 0]", "1", R"(["1/0", 0])")), ":5: disks[0].velocity[0]: "},
      {scene_text(disk("[0, 0]", "-1", "[0, 0]")), ":5: disks[0].radius: negative"},
      {scene_text(disk("[0, 0]", "1", "[0, 0]", R"(, "mass": 0)")), ":5: disks[0].mass: "},
      {scene_text(disk("[0, 0]", "1", "[0, 0]", R"(, "radius": 2)")), "disks[0].radius: appears"},
      {scene_text(disk("[0, 0]", "1", "[0, 0]", R"(, "color": 2)")), ":5: disks[0]"},
      {scene_text(disk("[0]", "1", "[0, 0]")), ":5: disks[0].center: "},
      {scene_text(disk("7", "1", "[0, 0]")), ":5: disks[0].center: "},
      {scene_text(disk("[0, 0]", "true", "[0, 0]")), ":5: disks[0].radius: "},
      {scene_text(good, R"( "maneuvers": [{"t": 1, "disk": 3, "velocity": [0, 0]}],)"),
       "maneuvers[0].disk: no such disk"},
      {scene_text(good, R"( "restitution": 1.5,)"), ":3: restitution: not in [0, 1]"},
      {scene_text(good, R"( "horizon": 6,)"), "horizon: appears twice"},
      {whole.substr(0, whole.size() * 3 / 4),
       ":5: disks[0]: unexpected end of input"},  // truncated
      {whole + "{}", ":7: "},
      {"", ":1: "},
      {"[]", ":1: "},
      {std::string(100000, '['), ":1: "},
      {std::string("\0\xff", 2), ":1: "},
  };
  for (const Case& c : cases) {
    const std::string path = directory_.write("bad.scene.json", c.text);
    refused({"simulate", path, "-o", file("out"), "--stats", file("stats")}, c.message);
    refused({"snapshot", path, "-o", file("out"), "--at", "0"}, c.message);
    refused({"simulate", path, "-o", file("out")}, path);
    EXPECT_EQ(run({"validate", path}).code, 2) << c.text.substr(0, 500);
  }
}

TEST_F(Cli, AnOutputThatStoodThereStaysWhereTheRunFails) {
  const std::string scene = directory_.write("a.scene.json", scene_text("nonsense"));
  const std::string out = directory_.write("out", "before");
  EXPECT_EQ(run({"simulate", scene, "-o", out}).code, 2);
  EXPECT_EQ(directory_.read("out"), "before");
}

TEST_F(Cli, GeneratedScenesAreValidAndDependOnTheirOptionsAlone) {
  struct Family {
    Arguments words, defaults;
  };
  const std::vector<Family> families{
      {{"generate", "reference", "--n", "20", "--radii", "log", "--speed", "0.1"}, {"--seed", "1"}},
      {{"generate", "grid", "--n", "9", "--motion", "shear"}, {"--seed", "1"}},
      {{"generate", "swarm", "--n", "5"}, {"--seed", "1"}},
      {{"generate", "formation", "--n", "5"}, {"--flight", "frame,circle"}}};
  for (const auto& [words, defaults] : families) {
    Arguments family = words, twice = words, other = words;
    family.insert(family.end(), {"-o", file("a.scene.json")});
    twice.insert(twice.end(), {"-o", file("b.scene.json")});
    twice.insert(twice.end(), defaults.begin(), defaults.end());
    other.insert(other.end(), {"-o", file("c.scene.json"), "--horizon", "7"});
    must(family);
    must(twice);
    must(other);
    EXPECT_EQ(directory_.read("a.scene.json"), directory_.read("b.scene.json"));
    EXPECT_NE(directory_.read("a.scene.json"), directory_.read("c.scene.json"));
    EXPECT_EQ(json("c.scene.json")["horizon"], 7);
    must({"validate", file("a.scene.json"), file("c.scene.json")});
  }
}

TEST_F(Cli, TheHistoryDependsOnTheSceneAlone) {
  const std::string scene = reference(40, "30");
  const Result first = must({"simulate", scene, "-o", file("a.history.jsonl")});
  EXPECT_EQ(std::count(first.out.begin(), first.out.end(), '\n'), 1);
  const std::string bytes = directory_.read("a.history.jsonl");
  EXPECT_GT(lines_of(bytes).size(), 100u);
  const std::vector<Arguments> variants{{"--threads", "2"},
                                        {"--threads", "8", "--stats", file("stats.json")},
                                        {"--start-bits", "64"},
                                        {"--start-bits", "4096"},
                                        {"--quiet"},
                                        {"--horizon", "30"},
                                        {"--horizon", "0xfp1"},
                                        {"--filters", "off"}};
  for (const Arguments& variant : variants) {
    Arguments arguments{"simulate", scene, "-o", file("b.history.jsonl")};
    arguments.insert(arguments.end(), variant.begin(), variant.end());
    const Result result = must(arguments);
    EXPECT_TRUE(directory_.read("b.history.jsonl") == bytes) << ::testing::PrintToString(variant);
    EXPECT_EQ(result.out.empty(), variant.front() == "--quiet");
  }
}

TEST_F(Cli, TheHorizonMayBeExactAndIsRecorded) {
  const std::string scene = directory_.write("a.scene.json", scene_text(two_disks));
  must({"simulate", scene, "-o", file("a.history.jsonl"), "--horizon", "10/3"});
  const std::vector<std::string> lines = lines_of(directory_.read("a.history.jsonl"));
  EXPECT_EQ(Json::parse(lines.front())["horizon"], "10/3");
  EXPECT_DOUBLE_EQ(Json::parse(lines.back())["end"]["t"].is_string()
                       ? 10.0 / 3
                       : Json::parse(lines.back())["end"]["t"].get<double>(),
                   10.0 / 3);
  must({"validate", file("a.history.jsonl")});
  // A prefix of what a longer run says: the same events up to there.
  must({"simulate", scene, "-o", file("b.history.jsonl")});
  const std::vector<std::string> longer = lines_of(directory_.read("b.history.jsonl"));
  ASSERT_LE(lines.size(), longer.size());
  EXPECT_TRUE(std::equal(lines.begin() + 1, lines.end() - 1, longer.begin() + 1));
}

TEST_F(Cli, StatisticsAgreeWithTheHistory) {
  const std::string scene = reference(30, "20");
  must({"simulate", scene, "-o", file("a.history.jsonl"), "--stats", file("stats.json"),
        "--threads", "2"});
  std::int64_t flips = 0, wall = 0, disks = 0;
  for (const std::string& line : lines_of(directory_.read("a.history.jsonl"))) {
    const Json event = Json::parse(line);
    flips += event.contains("flip");
    if (event.contains("collide")) ++(event["collide"][0] == -1 ? wall : disks);
  }
  EXPECT_GT(flips, 0);
  EXPECT_GT(wall, 0);
  EXPECT_GT(disks, 0);
  const Json stats = json("stats.json");
  EXPECT_EQ(stats["outcome"], "complete");
  EXPECT_EQ(stats["disks"], 30);
  EXPECT_EQ(stats["events"]["flips"]["all"], flips);
  std::int64_t sum = 0;
  for (const auto& [kind, number] : stats["events"]["flips"].items()) {
    if (kind != "all") sum += number.get<std::int64_t>();
  }
  EXPECT_EQ(sum, flips);
  EXPECT_EQ(stats["events"]["collisions"]["container"], wall);
  EXPECT_EQ(stats["events"]["collisions"]["disks"], disks);
  EXPECT_GE(stats["predicted"]["flips"], flips);
  EXPECT_GE(stats["predicted"]["collisions"], wall + disks);
  EXPECT_EQ(stats["options"]["threads"], 2);
  for (const char* step : {"step1_flip_times", "step2_collision_times", "step3_queue", "step4_move",
                           "initial_diagram"}) {
    EXPECT_GT(stats["seconds"][step], 0) << step;
    EXPECT_LT(stats["seconds"][step], stats["seconds"]["total"]) << step;
  }
}

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

TEST_F(Cli, RendersAndValidates) {
  const std::string scene = reference(20, "5");
  must({"simulate", scene, "-o", file("a.history.jsonl")});
  must({"snapshot", scene, "--at", "2", "-o", file("a.diagram.json")});
  must({"render", file("a.diagram.json"), "-o", file("a.svg")});
  must({"render", file("a.diagram.json"), "-o", file("a.png"), "--size", "64"});
  EXPECT_NE(directory_.read("a.svg").find("<svg"), std::string::npos);
  EXPECT_EQ(directory_.read("a.png").substr(1, 3), "PNG");
  refused({"render", file("a.diagram.json"), "-o", file("a.gif")}, ".svg or .png");
  const Result valid = must({"validate", scene, file("a.history.jsonl"), file("a.diagram.json")});
  const std::vector<std::string> lines = lines_of(valid.out);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0].rfind(scene + ": scene: 20 disks", 0), 0u) << lines[0];
  EXPECT_EQ(lines[1].rfind(file("a.history.jsonl") + ": history: ", 0), 0u) << lines[1];
  EXPECT_EQ(lines[2].rfind(file("a.diagram.json") + ": diagram: 20 disks", 0), 0u) << lines[2];
  // The first that is not valid ends it.
  const Result mixed = run({"validate", scene, file("a.svg"), file("a.history.jsonl")});
  EXPECT_EQ(mixed.code, 2);
  EXPECT_EQ(lines_of(mixed.out).size(), 1u);
  EXPECT_NE(mixed.err.find("a.svg:1: "), std::string::npos);
}

TEST_F(Cli, ARunThatStopsSaysWhere) {
  // The disk loses the normal part of its velocity at ever shorter intervals.
  const std::string scene = directory_.write("lone.scene.json",
                                             R"({"format": "voroproof-scene", "version": 1,
 "container": {"center": [0, 0], "radius": 10, "restitution": 0.5}, "horizon": 1000,
 "disks": [{"center": [3, 0], "radius": 1, "velocity": [0.25, 1]}]})");
  const std::string history = file("a.history.jsonl");
  const Result result = run({"simulate", scene, "-o", history, "--stats", file("stats.json")});
  EXPECT_EQ(result.code, 3);
  EXPECT_EQ(result.err.rfind("voroproof: stopped at t = ", 0), 0u) << result.err;
  EXPECT_EQ(lines_of(result.err).size(), 1u);
  const std::vector<std::string> lines = lines_of(directory_.read("a.history.jsonl"));
  const Json stop = Json::parse(lines.back())["stopped"];
  EXPECT_NE(stop["reason"].get<std::string>().find("inelastic collapse"), std::string::npos);
  EXPECT_LT(stop["t"], 1000);
  EXPECT_GT(lines.size(), 10u);
  EXPECT_EQ(json("stats.json")["outcome"], "stopped");
  EXPECT_EQ(json("stats.json")["reason"], stop["reason"]);
  must({"validate", history});

  // Before the stop there are diagrams, from then on there are none.
  const std::string out = file("a.diagram.json");
  must({"snapshot", scene, history, "--at", "1", "-o", out});
  refused({"snapshot", scene, history, "--at", "999", "-o", file("b")}, "stopped.t: ");
  refused({"snapshot", scene, history, "--at", Json(stop["t"]).dump(), "-o", file("b")},
          "stopped.t: ");
  const Result beyond = run({"snapshot", scene, "--at", "999", "-o", file("b")});
  EXPECT_EQ(beyond.code, 3);
  EXPECT_NE(beyond.err.find("inelastic collapse"), std::string::npos) << beyond.err;
  EXPECT_FALSE(std::filesystem::exists(file("b")));
}

TEST_F(Cli, AnInterruptedRunLeavesAHistoryUpToThere) {
  // More events than anyone waits for.
  const std::string scene = reference(100, "1e6");
  for (const int signal : {SIGINT, SIGTERM}) {
    const std::string history = file("a.history.jsonl");
    const pid_t child =
        start({"simulate", scene, "-o", history, "--max-bits", "10000000", "--threads", "2"});
    // Signals are handled when the output has been begun, under a name for the time being.
    while (directory_.number_of_files() < 2) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      ASSERT_EQ(waitpid(child, nullptr, WNOHANG), 0);
    }
    kill(child, signal);
    const Result result = finish(child);
    EXPECT_EQ(result.code, 6);
    EXPECT_EQ(result.err.rfind("voroproof: interrupted at t = ", 0), 0u) << result.err;
    EXPECT_EQ(directory_.number_of_files(), 2u);
    const Json last = Json::parse(lines_of(directory_.read("a.history.jsonl")).back());
    EXPECT_EQ(last["stopped"]["reason"], "interrupted");
    must({"validate", history});
    std::filesystem::remove(history);
  }
}

// A complete history is worth more than the beginning of the same one.
TEST_F(Cli, ARunThatStopsLeavesACompleteHistoryAlone) {
  const std::string scene = reference(30, "50"), history = file("a.history.jsonl");
  must({"simulate", scene, "-o", history});
  const std::string complete = directory_.read("a.history.jsonl");
  const Result result = run({"simulate", scene, "-o", history, "--max-events", "5"});
  EXPECT_EQ(result.code, 3);
  EXPECT_NE(result.err.find("a.history.jsonl: is complete and stays"), std::string::npos)
      << result.err;
  EXPECT_EQ(directory_.read("a.history.jsonl"), complete);
  const std::string begun = directory_.read("a.history.jsonl.partial");
  EXPECT_NE(lines_of(begun).back().find("stopped"), std::string::npos);
  // Again: what stopped is replaced by what stopped. And where it is asked for, the complete one.
  EXPECT_EQ(run({"simulate", scene, "-o", history, "--max-events", "3"}).code, 3);
  EXPECT_NE(directory_.read("a.history.jsonl.partial"), begun);
  EXPECT_EQ(run({"simulate", scene, "-o", history, "--max-events", "5", "--replace"}).code, 3);
  EXPECT_EQ(directory_.read("a.history.jsonl"), begun);
  // A complete run replaces whatever there is.
  must({"simulate", scene, "-o", history});
  EXPECT_EQ(directory_.read("a.history.jsonl"), complete);
}

TEST_F(Cli, OutOfMemory) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers need more address space than the test leaves";
#endif
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
  GTEST_SKIP() << "sanitizers need more address space than the test leaves";
#endif
#endif
  // Enough for the program itself.
  const auto limited = [&](const std::string& arguments) {
    const std::string command = "ulimit -v 65536; '" VOROPROOF_PROGRAM "' " + arguments + " 2> '" +
                                streams_.file("err") + "'";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
  };
  EXPECT_EQ(limited("generate grid --n 2000000 -o '" + file("a.scene.json") + "'"), 5);
  EXPECT_EQ(streams_.read("err"), "voroproof: out of memory\n");
  EXPECT_EQ(directory_.number_of_files(), 0u);
  // Here it is the numbers that find no memory.
  const std::string scene = reference(100, "30");
  EXPECT_EQ(limited("simulate '" + scene + "' -o '" + file("a.history.jsonl") +
                    "' --start-bits 16000000 --max-bits 16000000"),
            5);
  EXPECT_EQ(streams_.read("err"), "voroproof: out of memory\n");
  EXPECT_EQ(directory_.number_of_files(), 1u);
}

TEST_F(Cli, OutputThatNobodyTakesIsAnError) {
  const std::string scene = reference(3, "1");
  const std::string command = "'" VOROPROOF_PROGRAM "' validate '" + scene + "' > /dev/full 2> '" +
                              streams_.file("err") + "'";
  const int status = std::system(command.c_str());
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 2);
  EXPECT_EQ(streams_.read("err"), "voroproof: standard output: cannot write\n");
}

}  // namespace
}  // namespace voroproof::internal
