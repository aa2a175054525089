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

TEST_F(CertifyCli, ClearanceRefusesBadInput) {
  refused({"clearance", written("b.csv", "disk,t,x,y\na,0,0,0\n")}, "no radius is given");
  refused({"clearance", written("b.csv", "disk,t,x,y\na,0,0\n"), "--radius", "1"}, "b.csv:2");
  refused({"clearance", written("b.csv", "disk,t,x,y\na,0,0,0\n"), "--radius", "-1"}, "--radius");
  refused({"clearance", file("none.csv"), "--radius", "1"}, "none.csv");
}

}  // namespace
}  // namespace voroproof::internal
