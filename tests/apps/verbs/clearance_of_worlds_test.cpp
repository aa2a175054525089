// clearance of worlds as its users meet it.
#include "tests/apps/verbs/certify_cli.h"

namespace voroproof::internal {
namespace {

std::string world(const std::string& horizon, const std::string& disks,
                  const std::string& maneuvers = "") {
  return R"({"format":"voroproof-scene","version":2,"contacts":"pass","frame":"none","horizon":)" +
         horizon + R"(,"disks":[)" + disks + R"(],"maneuvers":[)" + maneuvers + "]}";
}

// One comes to another at rest, which grows from t = 1 to 3: the gap is 6 - t, then 7 - 2 t, then
// 4 - t, and after a jump of the other at t = 5 by 3 it is 7 - t.
TEST_F(CertifyCli, ClearanceOfAWorld) {
  const std::string scene =
      written("w.scene.json", world("6", R"({"center":[0,0],"radius":1,"velocity":[0,0]},
                                    {"center":[8,0],"radius":1,"velocity":[-1,0]})",
                                    R"({"t":1,"disk":0,"growth":1},{"t":3,"disk":0,"growth":0},
                               {"t":5,"disk":0,"center":[-3,0]})"));
  const std::string out = file("o.json");
  const Result told = run({"clearance", scene, "--required=-1", "--below", "4.5", "-o", out});
  EXPECT_EQ(told.code, 0) << told.out << told.err;
  EXPECT_NE(told.out.find("c least gap -1 (they overlap), of 0 1 at t = 5\n"), std::string::npos)
      << told.out;
  const Json answer = json("o.json");
  EXPECT_EQ(answer["disks"], 2);
  EXPECT_EQ(answer["least"]["disks"][0]["center"], Json::array({0, 0}));
  EXPECT_EQ(answer["least"]["disks"][0]["radius"], 3);
  // One spell, over both changes of growth and the jump.
  ASSERT_EQ(answer["approaches"].size(), 1u);
  EXPECT_EQ(answer["approaches"][0]["from"], Json::array({1.25, 1.25}));
  EXPECT_EQ(answer["approaches"][0]["to"], Json::array({6, 6}));
  EXPECT_EQ(run({"clearance", scene, "--required=-0.999"}).code, 1);
  // With the jump the gap is 2 and falls to 1.
  const std::string later =
      written("l.scene.json", world("6", R"({"center":[-3,0],"radius":3,"velocity":[0,0],"enter":5},
                                    {"center":[8,0],"radius":1,"velocity":[-1,0]})"));
  EXPECT_EQ(run({"clearance", later, "--required", "1"}).code, 0);
  EXPECT_EQ(run({"clearance", later, "--required", "1.001"}).code, 1);
}

// What a disk has left is not where it is: a gap that is only approached is kept.
TEST_F(CertifyCli, ClearanceOfDisksThatLeave) {
  const auto code = [&](const std::string& member, const std::string& maneuvers) {
    const std::string scene =
        written("w.scene.json", world("2",
                                      R"({"center":[0,0],"radius":1,"velocity":[0,0])" + member +
                                          R"(},{"center":[4,0],"radius":1,"velocity":[-2,0]})",
                                      maneuvers));
    return run({"clearance", scene, "--required", "0"}).code;
  };
  EXPECT_EQ(code("", ""), 1);
  // The two touch at t = 1.
  EXPECT_EQ(code(R"(,"leave":1)", ""), 0);
  EXPECT_EQ(code(R"(,"leave":"1000001/1000000")", ""), 1);
  EXPECT_EQ(code("", R"({"t":1,"disk":0,"center":[9,9]})"), 0);
  EXPECT_EQ(code("", R"({"t":1.000001,"disk":0,"center":[9,9]})"), 1);
  EXPECT_EQ(code("", R"({"t":1,"disk":0,"radius":0.5},{"t":1.25,"disk":0,"center":[9,9]})"), 0);
  EXPECT_EQ(code("", R"({"t":1,"disk":0,"velocity":[-2,0]})"), 1);
  // A jump at the horizon is there for an instant.
  EXPECT_EQ(code("", R"({"t":0.5,"disk":0,"center":[9,9]},{"t":2,"disk":0,"center":[0,0]})"), 1);
  // One leaves when the other enters: there is no pair, and nothing is free.
  const std::string scene =
      written("n.scene.json", world("2", R"({"center":[0,0],"radius":1,"velocity":[0,0],"leave":1},
                                    {"center":[0,0],"radius":1,"velocity":[0,0],"enter":1})"));
  const Result none = run({"clearance", scene, "--required", "0"});
  EXPECT_EQ(none.code, 3);
  EXPECT_NE(none.out.find("no two disks are there at one time"), std::string::npos) << none.out;
}

TEST_F(CertifyCli, ClearanceOfAWorldTakesNoOtherWord) {
  const std::string scene =
      written("w.scene.json", world("2", R"({"center":[0,0],"radius":1,"velocity":[0,0]})"));
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"--radius", "1"}, {"--stay"}, {"--frames-only"}, {scene}}) {
    std::vector<std::string> words{"clearance", scene};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(run(words).code, 2) << more.front();
  }
}

}  // namespace
}  // namespace voroproof::internal
