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

TEST_F(CertifyCli, ClearanceRefusesBadInput) {
  refused({"clearance", written("b.csv", "disk,t,x,y\na,0,0,0\n")}, "no radius is given");
  refused({"clearance", written("b.csv", "disk,t,x,y\na,0,0\n"), "--radius", "1"}, "b.csv:2");
  refused({"clearance", written("b.csv", "disk,t,x,y\na,0,0,0\n"), "--radius", "-1"}, "--radius");
  refused({"clearance", file("none.csv"), "--radius", "1"}, "none.csv");
}

}  // namespace
}  // namespace voroproof::internal
