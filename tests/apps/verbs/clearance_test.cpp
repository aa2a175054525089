// clearance as its users meet it.
#include "tests/apps/verbs/certify_cli.h"

namespace voroproof::internal {
namespace {

constexpr const char* kInterpolation =
    "c judged are the piecewise linear paths between the waypoints of the file\n";

TEST_F(CertifyCli, ClearanceOfATable) {
  const std::string table =
      written("a.csv", "disk,t,x,y,radius\na,0,0,0,1\na,2,4,0,1\nb,0,2,3,1\nb,2,2,3,1\n");
  const std::string out = file("o.json");
  EXPECT_EQ(must({"clearance", table, "--required", "1", "-o", out}).out,
            std::string(kInterpolation) + "c least gap 1, of a b at t = 1\ns FREE\n");
  EXPECT_EQ(json("o.json")["verdict"], "FREE");
  EXPECT_EQ(json("o.json")["least"]["distance_squared"], 9);
  const Result refuted = run({"clearance", table, "--required", "1.0000000000000000001"});
  EXPECT_EQ(refuted.code, 1);
  EXPECT_EQ(refuted.out,
            std::string(kInterpolation) + "c least gap 1, of a b at t = 1\ns REFUTED\n");
  const std::string near = must({"clearance", table, "--below", "2", "-o", out}).out;
  EXPECT_NE(near.find("a b"), std::string::npos);
  EXPECT_EQ(json("o.json")["approaches"].size(), 1u);
  EXPECT_EQ(json("o.json")["approaches"][0]["least"]["t"], 1);
}

// What a table says of itself is said wherever something is said of its paths.
TEST_F(CertifyCli, RemarksOfATableAreRepeated) {
  const std::string table =
      written("r.csv", "# remark: walls are left out\ndisk,t,x,y,radius\na,0,0,0,1\na,1,0,1,1\n");
  EXPECT_EQ(
      must({"clearance", table, "-o", file("o.json")}).out,
      std::string(kInterpolation) + "c walls are left out\nc no two disks are there at one time\n");
  EXPECT_EQ(json("o.json")["remarks"][1], "walls are left out");
  const std::string told = must({"convert", table, "-o", file("r.scene.json")}).out;
  EXPECT_NE(told.find("\nwalls are left out\n"), std::string::npos) << told;
}

// The scene of given paths meets their waypoints exactly, at times that are no binary64.
TEST_F(CertifyCli, ScenesOfPaths) {
  const std::string table = written(
      "p.csv",
      "disk,t,x,y,radius\na,1,0,0,1/3\nb,1,9,9,0\na,4/3,0.1,0.7,1/3\na,2,3,1,1/3\nb,2,9,9,0\n");
  const std::string scene = file("p.scene.json"), path = file("p.history.jsonl");
  must({"convert", table, "-o", scene});
  EXPECT_EQ(json("p.scene.json")["horizon"], 1);
  must({"simulate", scene, "-o", path});
  EXPECT_EQ(verdict({scene, path, "--kernel"}), "s CERTIFIED");
  must({"snapshot", scene, "--at", "1/3", "-o", file("d.json")});
  EXPECT_EQ(json("d.json")["disks"][0]["center"], Json::array({0.1, 0.7}));
  must({"snapshot", scene, "--at", "1", "-o", file("d.json")});
  EXPECT_EQ(json("d.json")["disks"][0]["center"], Json::array({3, 1}));
  EXPECT_EQ(json("d.json")["disks"][1]["center"], Json::array({9, 9}));
  const auto convert = [&](const char* text) -> Arguments {
    return {"convert", written("q.csv", text), "--radius", "1", "-o", file("q.scene.json")};
  };
  refused(convert("disk,t,x,y\na,0,0,0\na,1,4,0\nb,0,3,1\nb,1,3,1\n"), "disks a and b: touch");
  refused(convert("disk,t,x,y\na,0,0,0\na,1,4,0\nb,0,3,9\nb,2,3,1\n"),
          "disk b: is there from 0 to 2");
}

constexpr const char* kScene = R"({"format":"voroproof-scene","version":1,
  "container":{"center":[0,0],"radius":10},"horizon":6,"disks":[
  {"center":[-4,0],"radius":1,"velocity":[1,0]},{"center":[4,0],"radius":1,"velocity":[-1,0]}]})";

// Two that collide at t = 3, at the gap 6 - 2t before and 2(t - 3) after; the wall is 5 away at
// first.
TEST_F(CertifyCli, ClearanceOfAHistory) {
  const std::string scene = written("c.scene.json", kScene), history = file("c.history.jsonl");
  must({"simulate", scene, "-o", history});
  const std::string out = file("o.json");
  const Result told =
      run({"clearance", scene, history, "--required", "0", "--below", "2", "-o", out});
  EXPECT_EQ(told.code, 1);
  EXPECT_NE(told.out.find("c the history is not judged: certify does that\n"), std::string::npos);
  EXPECT_NE(told.out.find("c least gap 0, of 0 1 at t = 3\n"
                          "c least gap to the container 5, of 0 wall at t = 0\n"),
            std::string::npos)
      << told.out;
  EXPECT_NE(told.out.find("s REFUTED"), std::string::npos);
  const Json answer = json("o.json");
  EXPECT_EQ(answer["least"]["distance_squared"], 4);
  EXPECT_EQ(answer["container"]["radius"], 10);
  EXPECT_EQ(answer["approaches"].size(), 1u);
  EXPECT_EQ(answer["approaches"][0]["from"], Json::array({2, 2}));
  EXPECT_EQ(answer["approaches"][0]["to"], Json::array({4, 4}));
  EXPECT_EQ(answer["approaches_to_container"].size(), 0u);
  must({"clearance", scene, history, "--below", "6", "-o", out});
  EXPECT_EQ(json("o.json")["approaches_to_container"].size(), 4u);
}

// By all legs here, by the diagram there.
TEST_F(CertifyCli, ClearanceAgreesWithTheClosestPair) {
  for (const char* kind : {"swarm", "reference"}) {
    const std::string scene = file("s.scene.json"), history = file("s.history.jsonl");
    must({"generate", kind, "--n", "9", "--seed", "2", "--horizon", "5", "-o", scene});
    must({"simulate", scene, "-o", history});
    must({"clearance", scene, history, "-o", file("o.json")});
    must({"query", "closest-over", scene, history, "-o", file("q.json")});
    const Json least = json("o.json")["least"], closest = json("q.json");
    EXPECT_EQ(least["disks"][0]["disk"], std::to_string(closest["pair"][0].get<int>()));
    EXPECT_EQ(least["disks"][1]["disk"], std::to_string(closest["pair"][1].get<int>()));
    EXPECT_NEAR(least["gap"][0].get<double>(), closest["gap"][0].get<double>(), 1e-14);
  }
}

TEST_F(CertifyCli, ClearanceOfAHistoryRefusesBadInput) {
  const std::string scene = written("c.scene.json", kScene), history = file("c.history.jsonl");
  must({"simulate", scene, "-o", history});
  refused({"clearance", scene, history, "--radius", "1"}, "--radius");
  refused({"clearance", history, scene}, "the scene comes first");
  const std::string other = file("other.scene.json");
  must({"generate", "grid", "--n", "4", "-o", other});
  refused({"clearance", other, history}, "scene_sha256");
}

TEST_F(CertifyCli, ClearanceRefusesBadInput) {
  refused({"clearance", written("b.csv", "disk,t,x,y\na,0,0,0\n")}, "no radius is given");
  refused({"clearance", written("b.csv", "disk,t,x,y\na,0,0\n"), "--radius", "1"}, "b.csv:2");
  refused({"clearance", written("b.csv", "disk,t,x,y\na,0,0,0\n"), "--radius", "-1"}, "--radius");
  refused({"clearance", file("none.csv"), "--radius", "1"}, "none.csv");
}

}  // namespace
}  // namespace voroproof::internal
