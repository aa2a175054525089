// clearance in space, of curves, across the sides of periodic boxes and between frames.
#include "tests/apps/verbs/certify_cli.h"

namespace voroproof::internal {
namespace {

TEST_F(CertifyCli, ClearanceInSpace) {
  const std::string table =
      written("f.csv", "disk,t,x,y,z\na,0,0,0,10\na,1,8,0,10\nb,0,8,0,14\nb,1,0,0,14\n");
  const std::string out = file("o.json");
  must({"clearance", table, "--radius", "1", "--required", "2", "-o", out});
  EXPECT_EQ(json("o.json")["least"]["distance_squared"], 16);
  EXPECT_EQ(json("o.json")["least"]["disks"][1]["center"], Json::array({4, 0, 14}));
  const Result near =
      run({"clearance", table, "--radius", "1", "--height", "5", "--required", "0", "-o", out});
  EXPECT_EQ(near.code, 1);
  EXPECT_EQ(json("o.json")["least"]["distance_squared"], 0);
  EXPECT_EQ(json("o.json")["height"], 5);
  const Result far = run({"clearance", table, "--radius", "1", "--height", "4", "--required", "0"});
  EXPECT_EQ(far.code, 3);
  EXPECT_NE(far.out.find("c no two disks are near each other in height at one time\n"),
            std::string::npos);
  refused({"clearance", table, "--radius", "1", "--height", "0"}, "--height");
  refused({"clearance", written("p.csv", "disk,t,x,y\n"), "--radius", "1", "--height", "1"},
          "no column z");
  refused({"convert", table, "--radius", "1", "-o", file("f.scene.json")}, "move in a plane");
  refused({"convert", table, "--radius", "1", "--contacts", "pass", "-o", file("f.scene.json")},
          "move in a plane");
}

TEST_F(CertifyCli, ClearanceOfCurves) {
  const std::string table = written("c.csv",
                                    "disk,t,duration,x^0,x^1,y^0,y^2\n"
                                    "flies,-2,4,-2,1,0,0\nstill,-2,4,0,0,3,0\n");
  const std::string out = file("o.json");
  EXPECT_EQ(must({"clearance", table, "--radius", "1", "--required", "1", "-o", out}).code, 0);
  EXPECT_EQ(json("o.json")["least"]["t"], 0);
  EXPECT_EQ(json("o.json")["remarks"][0], "judged are the piecewise polynomial paths of the file");
  // y = (t + 2)^2 and the distance from (0, 3): an algebraic time.
  const std::string curved = written("d.csv",
                                     "disk,t,duration,x^0,x^1,y^0,y^2\n"
                                     "flies,-2,4,-2,1,0,1\nstill,-2,4,0,0,3,0\n");
  must({"clearance", curved, "--radius", "0", "--required", "0", "-o", out});
  EXPECT_TRUE(json("o.json")["least"]["t"].is_array());
  EXPECT_TRUE(json("o.json")["least"]["distance_squared"].is_array());
  refused({"convert", curved, "--radius", "0", "-o", file("c.scene.json")}, "straight ways");
}

TEST_F(CertifyCli, ClearanceAcrossASide) {
  const std::string table =
      written("p.csv", "# periodic: 10,none\ndisk,t,x,y\na,0,1,0\na,1,1,0\nb,0,9,0\nb,1,9,0\n");
  const Result touching = run({"clearance", table, "--radius", "1", "--required", "0"});
  EXPECT_EQ(touching.code, 1);
  EXPECT_NE(touching.out.find("c touching is too near\nc least gap 0, of a b[-1,0] at t = 0\n"),
            std::string::npos)
      << touching.out;
  EXPECT_NE(must({"clearance", table, "--radius", "1", "--required", "0", "--may-touch"})
                .out.find("c touching is allowed\n"),
            std::string::npos);
  EXPECT_NE(must({"clearance", table, "--radius", "1.25", "--required=-1/2", "-o", file("o.json")})
                .out.find("c overlaps of up to 0.5 are allowed\n"),
            std::string::npos);
  EXPECT_EQ(json("o.json")["least"]["image"], Json::array({-1, 0}));
  EXPECT_EQ(run({"clearance", table, "--radius", "1.25", "--required=-0.49"}).code, 1);
  const std::string out_csv = file("o.csv");
  must({"clearance", table, "--radius", "1", "--below", "1", "-o", out_csv});
  EXPECT_EQ(read_file(out_csv), "first,second,image_x,image_y,from,to,gap,t\na,b,-1,0,0,1,0,0\n");
  refused({"clearance", table, "--radius", "1", "-o", file("o.csv")}, "--below");
  refused({"clearance", table, "--radius", "1", "--below", "10001"}, "1000 sides");
  refused({"clearance", table, "--radius", "1e12", "--below", "1"}, "1000 sides");
  refused({"convert", table, "--radius", "1", "-o", file("p.scene.json")}, "no images");
}

// The smallest gap comes first, and frames are no motion.
TEST_F(CertifyCli, ClearanceOfFrames) {
  const std::string table =
      written("m.csv", "disk,t,x,y\na,0,0,0\na,1,9,0\nb,0,9,0\nb,1,0,0\nc,0,0,5\nc,1,9,4\n");
  EXPECT_EQ(run({"clearance", table, "--radius", "1", "--required", "0"}).code, 1);
  const std::string out = file("o.json");
  must({"clearance", table, "--radius", "1", "--frames-only", "--required", "1", "--below", "4",
        "-o", out});
  EXPECT_EQ(json("o.json")["frames_only"], true);
  ASSERT_EQ(json("o.json")["approaches"].size(), 2u);
  EXPECT_EQ(json("o.json")["approaches"][0]["least"]["t"], 1);
  EXPECT_EQ(json("o.json")["approaches"][1]["least"]["t"], 0);
  // One that stays is there at the instants of others.
  const std::string buoy =
      written("s.csv", "disk,t,x,y\nbuoy,0,0,0\nship,0,-10,0\nship,5,0,0\nship,10,10,0\n");
  const std::vector<std::string> stays{"clearance", buoy,         "--radius", "1",  "--frames-only",
                                       "--stay",    "--required", "0",        "-o", out};
  EXPECT_EQ(run(stays).code, 1);
  EXPECT_EQ(json("o.json")["least"]["t"], 5);
  // One that may move meanwhile is anywhere.
  const std::string lacking = written(
      "l.csv", "disk,t,x,y\nbuoy,0,0,9\nbuoy,10,0,9\nship,0,-10,0\nship,5,0,0\nship,10,10,0\n");
  const Result undecided =
      run({"clearance", lacking, "--radius", "1", "--frames-only", "--required", "0"});
  EXPECT_EQ(undecided.code, 3);
  EXPECT_NE(undecided.out.find(
                "1 of 2 disks have no waypoint at an instant of others, disk buoy at t = 5"),
            std::string::npos);
}

}  // namespace
}  // namespace voroproof::internal
