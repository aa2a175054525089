// The program as its users meet it: help, messages and exit codes, generated scenes, pictures.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "tests/apps/verbs/cli.h"
#include "tests/apps/verbs/small_scenes.h"

namespace voroproof::internal {
namespace {

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
      {{"simulat"}, "unknown verb simulat; did you mean simulate? (see voroproof --help)"},
      {{"--loud"}, "unknown option --loud (see voroproof --help)"},
      {{"a\nb"}, "unknown verb a\\x0ab"},
      {{"generate"}, "no verb given (see voroproof generate --help)"},
      {{"generate", "cloud"}, "unknown verb cloud"},
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
      {{"simulate", out + ".partial", "-o", out}, "is an input as well as an output"},
      {{"simulate", scene, "-o", out, "--stats", out + ".partial"}, "is named for two outputs"},
      {{"simulate", scene, "-o", out, "--stats", out}, "is named for two outputs"},
      {{"simulate", scene, "-o", out, "--stats", file("./out")}, "is named for two outputs"},
      {{"simulate", scene, "-o", file("no/out")}, "no/out: cannot write"},
      {{"simulate", scene, "-o", out, "--stats", file("no/out")}, "no/out: cannot write"},
      {{"simulate", scene, "-o", file("")}, "is not a regular file"},
      {{"simulate", scene, "-o", out, "--horizon", "1/0"}, "--horizon: 1/0"},
      {{"simulate", scene, "-o", out, "--horizon", "-1"}, "--horizon: -1: negative"},
      {{"simulate", scene, "-o", out, "--horizon", "nan"}, "--horizon: nan"},
      {{"simulate", scene, "-o", out, "--horizon", "1e101"}, "--horizon: 1e101: beyond"},
      {{"simulate", scene, "-o", out, "--horizon", ""}, "--horizon: is empty"},
      {{"simulate", scene, "-o", ""}, "--output: is empty"},
      {{"simulate", scene, "-o", out, "--stats", ""}, "--stats: is empty"},
      {{"simulate", scene, "-o", out, "--threads", "0"}, "--threads"},
      {{"simulate", scene, "-o", out, "--threads", "two"}, "--threads"},
      {{"simulate", scene, "-o", out, "--max-bits", "63"}, "--max-bits"},
      {{"simulate", file("none"), "-o", out}, "none: cannot read"},
      {{"simulate", file(""), "-o", out}, "cannot read"},
      {{"snapshot", scene, "-o", out}, "--at is required"},
      {{"snapshot", scene, "-o", out, "--at", "soon"}, "--at: soon"},
      {{"snapshot", scene, "-o", out, "--at", "1", "--move", "1"},
       "--move, --construct, --unchecked and --index say"},
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

TEST_F(Cli, RendersAndValidates) {
  const std::string scene = reference(20, "5");
  must({"simulate", scene, "-o", file("a.history.jsonl")});
  must({"snapshot", scene, "--at", "2", "-o", file("a.diagram.json")});
  must({"render", file("a.diagram.json"), "-o", file("a.svg")});
  must({"render", file("a.diagram.json"), "-o", file("a.png"), "--size", "64"});
  EXPECT_NE(directory_.read("a.svg").find("<svg"), std::string::npos);
  EXPECT_EQ(directory_.read("a.png").substr(1, 3), "PNG");
  refused({"render", file("a.diagram.json"), "-o", file("a.gif")}, ".svg, .png or .pdf");
  const Result valid = must({"validate", scene, file("a.history.jsonl"), file("a.diagram.json")});
  const std::vector<std::string> lines = lines_of(valid.out);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0].rfind(scene + ": scene: 20 disks", 0), 0u) << lines[0];
  EXPECT_EQ(lines[1].rfind(file("a.history.jsonl") + ": history: ", 0), 0u) << lines[1];
  EXPECT_EQ(lines[2].rfind(file("a.diagram.json") + ": diagram: 20 disks", 0), 0u) << lines[2];
  // Those behind one that is not valid are checked, too.
  const Result mixed =
      run({"validate", scene, file("a.svg"), file("none"), file("a.history.jsonl")});
  EXPECT_EQ(mixed.code, 2);
  EXPECT_EQ(lines_of(mixed.out).size(), 2u);
  EXPECT_EQ(lines_of(mixed.err).size(), 2u);
  EXPECT_NE(mixed.err.find("a.svg:1: "), std::string::npos);
  EXPECT_NE(mixed.err.find("none: cannot read"), std::string::npos);
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
