// clearance of billiards as its users meet it.
#include "tests/apps/verbs/certify_cli.h"

namespace voroproof::internal {
namespace {

constexpr const char* kBox = R"({"format":"voroproof-scene","version":2,"contacts":"bounce",
  "horizon":2,"frame":{"periodic":[10,null],
  "walls":[{"normal":[0,1],"offset":0},{"normal":[0,-1],"offset":-10}]},"disks":[
  {"center":[1,5],"radius":1,"velocity":[-2,0]},
  {"center":[7,5],"radius":1,"velocity":[0,0],"mass":1},
  {"center":[4,2],"radius":1,"fixed":true}],
  "maneuvers":[{"t":1.5,"disk":0,"velocity":[0,1]}]})";

// Two collide across the side of the box at t = 1, at the gap 2 - 2 t before.
TEST_F(CertifyCli, ClearanceOfABilliard) {
  const std::string scene = written("b.scene.json", kBox), history = file("b.history.jsonl");
  must({"simulate", scene, "-o", history});
  const std::string out = file("o.json");
  const Result told =
      run({"clearance", scene, history, "--required", "0", "--below", "1", "-o", out});
  EXPECT_EQ(told.code, 1);
  EXPECT_NE(told.out.find("c least gap 0, of 0 1[-1,0] at t = 1\n"
                          "c least gap to the walls 1, of 2 wall -1 at t = 0\n"),
            std::string::npos)
      << told.out;
  const Json answer = json("o.json");
  EXPECT_EQ(answer["least"]["distance_squared"], 4);
  EXPECT_EQ(answer["least"]["image"], Json::array({-1, 0}));
  ASSERT_EQ(answer["approaches"].size(), 1u);
  EXPECT_EQ(answer["approaches"][0]["from"], Json::array({0.5, 0.5}));
  EXPECT_EQ(answer["least_to_container"]["wall"], -1);
  EXPECT_EQ(answer["walls"][1]["offset"], -10);
  EXPECT_FALSE(answer.contains("container"));
  EXPECT_EQ(run({"clearance", scene, history, "--required", "0", "--may-touch"}).code, 0);
  EXPECT_EQ(run({"clearance", scene, history, "--required=-1e-9"}).code, 0);
  EXPECT_EQ(run({"clearance", scene, history, "--required", "1e-9", "--may-touch"}).code, 1);
  must({"clearance", scene, history, "--below", "2", "-o", file("o.csv")});
  EXPECT_NE(read_file(file("o.csv")).find("2,wall -1,0,0,0,2,1,0\n"), std::string::npos)
      << read_file(file("o.csv"));
}

// An engine in doubles rounds the horizon of its scene, perhaps up.
TEST_F(CertifyCli, ARoundedHorizonIsThatOfTheBilliard) {
  const auto told = [&](const std::string& horizon) {
    const std::string scene =
        written("r.scene.json",
                R"({"format":"voroproof-scene","version":2,"contacts":"bounce","horizon":"1/10",
           "frame":"none","disks":[{"center":[0,0],"radius":1,"velocity":[1,0]},
           {"center":["41/20",0],"radius":1,"velocity":[0,0]}]})");
    must({"simulate", scene, "-o", file("r.history.jsonl"), "--replace"});
    std::string text = read_file(file("r.history.jsonl"));
    for (std::size_t at = text.find("\"1/10\""); at != std::string::npos;
         at = text.find("\"1/10\""))
      text.replace(at, 6, horizon);
    const std::string history = written("r.history.jsonl", text);
    return std::array{run({"certify", scene, history}).code,
                      run({"certify", scene, history, "--truth", "recorded", "--kernel"}).code,
                      run({"clearance", scene, history, "--required", "0", "--may-touch"}).code};
  };
  EXPECT_EQ(told("0.1"), (std::array{0, 0, 0}));
  EXPECT_EQ(told("0.10000000000000002"), (std::array{2, 2, 2}));
}

TEST_F(CertifyCli, NoHistoryOfABilliardIsFreeOfWhatItDoesNotTell) {
  const std::string scene = written("b.scene.json", kBox), right = file("b.history.jsonl");
  must({"simulate", scene, "-o", right});
  const std::vector<std::string> lines = lines_of(read_file(right));
  ASSERT_EQ(lines.size(), 4u);
  const auto lacks = [&](std::vector<std::string> text, const std::string& what) {
    std::string all;
    for (const std::string& line : text) all += line + "\n";
    const Result result = run(
        {"clearance", scene, written("s.history.jsonl", all), "--required", "0", "--may-touch"});
    EXPECT_EQ(result.code, 3) << result.out << result.err;
    EXPECT_NE(result.out.find("c missing: " + what + "\n"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("\ns UNDECIDED\n"), std::string::npos) << result.out;
  };
  lacks({lines[0], lines[1], R"({"stopped":{"t":1.25,"reason":"x"}})"},
        "the time from t = 1.25, where the history stops, to the scene's horizon, 2");
  std::string header = lines[0];
  header.replace(header.find("\"horizon\":2"), 11, "\"horizon\":1");
  lacks({header, lines[1], R"({"end":{"t":1,"collisions":1,"maneuvers":0}})"},
        "the time from t = 1, where the history ends, to the scene's horizon, 2");
  lacks({lines[0], lines[1], R"({"end":{"t":2,"collisions":1,"maneuvers":0}})"},
        "a maneuver of the scene, not in the history as scheduled: disk 0 at t = 1.5");
  lacks({lines[0], lines[1], lines[2], R"({"end":{"t":2,"collisions":2,"maneuvers":1}})"},
        "events: the last line of the history counts others than it has");
  lacks({lines[0], R"({"t":0.75,"collide":[0,1],"image":[-1,0],"v":[[0,0],[-2,0]]})", lines[2],
         lines[3]},
        "the contact of a collision of two that do not touch on these paths: [0,1] at t = 0.75");
  lacks({lines[0], R"({"t":1,"collide":[-1,0],"v":[null,[0,0]]})", lines[2], lines[3]},
        "the contact of a collision of two that do not touch on these paths: [-1,0] at t = 1");
}

// The radii grow towards each other while the disks are at rest: 8 - 3 t is 2 at the horizon.
TEST_F(CertifyCli, ClearanceOfDisksThatGrow) {
  const std::string scene = written("g.scene.json", R"({"format":"voroproof-scene","version":2,
    "contacts":"bounce","dimension":3,"horizon":2,"frame":{"center":[0,0,0],"radius":20},"disks":[
    {"center":[0,0,0],"radius":1,"growth":1,"velocity":[0,0,0]},
    {"center":[10,0,0],"radius":1,"growth":2,"velocity":[0,0,0]}]})");
  const std::string history = file("g.history.jsonl"), out = file("o.json");
  must({"simulate", scene, "-o", history});
  const Result told = run({"clearance", scene, history, "--required", "2", "-o", out});
  EXPECT_EQ(told.code, 0) << told.out;
  EXPECT_NE(told.out.find("c least gap 2, of 0 1 at t = 2\n"
                          "c least gap to the container 5, of 1 wall at t = 2\ns FREE\n"),
            std::string::npos)
      << told.out;
  EXPECT_EQ(json("o.json")["least"]["disks"][1]["radius"], 5);
  EXPECT_EQ(json("o.json")["container"]["center"], Json::array({0, 0, 0}));
  EXPECT_EQ(run({"clearance", scene, history, "--required", "2.0000001"}).code, 1);
}

TEST_F(CertifyCli, ClearanceOfBilliardsRefusesBadInput) {
  const std::string scene = written("b.scene.json", kBox), history = file("b.history.jsonl");
  must({"simulate", scene, "-o", history});
  refused({"clearance", scene, history, "--height", "1"}, "--height");
  refused({"clearance", scene, history, "--frames-only"}, "--frames-only");
  std::string text = kBox;
  text.replace(text.find("\"horizon\":2"), 11, "\"horizon\":1");
  refused({"clearance", written("c.scene.json", text), history}, "scene_sha256");
  const std::string lines = read_file(history);
  std::string none = lines;
  const auto v = none.find(",\"v\":"), p = none.find(",\"p\":", v);
  none.erase(v, p - v);
  refused({"clearance", scene, written("n.history.jsonl", none)}, "collide: its v is needed");
  const std::string sheared = written("l.scene.json", R"({"format":"voroproof-scene","version":2,
    "contacts":"bounce","horizon":1,"frame":{"periodic":[9,9],"shear":0.1},"disks":[
    {"center":[0,0],"radius":1,"velocity":[0,0]}]})");
  must({"simulate", sheared, "-o", file("l.history.jsonl")});
  const Result moving = run({"clearance", sheared, file("l.history.jsonl"), "--required", "0"});
  EXPECT_EQ(moving.code, 2);
  EXPECT_EQ(moving.out, "s INVALID\n");
  EXPECT_NE(moving.err.find("frame.shear: clearance knows no images that move"), std::string::npos)
      << moving.err;
}

}  // namespace
}  // namespace voroproof::internal
