// certify --diagram: diagrams at rest, ours and those of others.
#include <gtest/gtest.h>

#include <string>

#include "tests/apps/verbs/cli.h"

namespace voroproof::internal {
namespace {

class CertifyDiagramCli : public Cli {
 protected:
  void SetUp() override {
    directory_.write("towns.csv",
                     "name,x,y,r\na,0,0,1\nb,4,0,2\nc,1,3,0.5\nd,2,1,0\ne,4.1,0.2,0.3\n");
  }
  Result judged(const Arguments& files) const {
    Arguments all{"certify", "--diagram"};
    all.insert(all.end(), files.begin(), files.end());
    return run(all);
  }
};

TEST_F(CertifyDiagramCli, OursIsCertified) {
  must({"diagram", file("towns.csv"), "-o", file("a.json")});
  const Result result = judged({file("a.json")});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.out.substr(0, 9), "c sha256 ");
  EXPECT_NE(result.out.find("c about the diagram of 5 disks in the plane: edges, hidden disks, "
                            "vertices within 1e-9 of their numbers\ns CERTIFIED\n"),
            std::string::npos)
      << result.out;
  // A table with a list of edges, in a frame.
  must({"diagram", file("towns.csv"), "--frame", "2,1,5", "-o", file("b.csv")});
  EXPECT_EQ(judged({file("towns.csv"), file("b.csv"), "--frame", "2,1,5"}).code, 0);
  EXPECT_EQ(judged({file("towns.csv"), file("b.csv"), "--frame", "0,0,1.5"}).code, 1);
  // And in a rectangle.
  const std::string walls = "--frame=-2,-3,7,5";
  must({"diagram", file("towns.csv"), walls, "-o", file("c.csv")});
  EXPECT_EQ(judged({file("towns.csv"), file("c.csv"), walls}).code, 0);
  EXPECT_EQ(judged({file("towns.csv"), file("c.csv"), "--frame=-2,-3,70,5"}).code, 1);
  must({"diagram", file("towns.csv"), walls, "-o", file("c.json")});
  EXPECT_EQ(judged({file("c.json")}).code, 0);
}

TEST_F(CertifyDiagramCli, NeighboursOfAnybodyAreJudged) {
  directory_.write("pairs.txt", "0 1\n0 2\n0 3\n1 2\n1 3\n2 3\n");
  EXPECT_EQ(judged({file("towns.csv"), file("pairs.txt")}).code, 0);
  directory_.write("pairs.csv", "left,right\n0,1\n0,2\n0,3\n1,2\n1,4\n1,3\n2,3\n");
  const Result result = judged({file("towns.csv"), file("pairs.csv"), "--quiet"});
  EXPECT_EQ(result.code, 1);
  EXPECT_EQ(result.out,
            "c about the diagram of 5 disks in the plane: neighbours\n"
            "c 3 neighbours of the frame are not claimed\ns REFUTED\n");
  EXPECT_NE(result.err.find("the cells of [1,4] have no edge in common"), std::string::npos);
  directory_.write("min.json",
                   R"({"format":"voroproof-static-diagram","version":1,"frame":"none",
                   "disks":[{"center":[0,0],"radius":1},{"center":[4,0],"radius":1}],
                   "neighbours":[[1,0]]})");
  EXPECT_EQ(judged({file("min.json")}).code, 0);
}

TEST_F(CertifyDiagramCli, BadInputIsRefused) {
  directory_.write("bad.csv", "0 1\n0 1 2\n");
  Result result = judged({file("towns.csv"), file("bad.csv")});
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.out, "s INVALID\n");
  EXPECT_NE(result.err.find("bad.csv:2: neither two numbers nor four"), std::string::npos);
  directory_.write("bad.csv", "0 1\n0 9\n");
  result = judged({file("towns.csv"), file("bad.csv")});
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(result.err.find("there is no 9"), std::string::npos) << result.err;
  directory_.write("bad.json", R"({"format":"voroproof-static-diagram","version":1,"frame":"none",
                   "disks":[{"center":[0],"radius":1}],"edges":[]})");
  result = judged({file("bad.json")});
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(result.err.find("bad.json:2: disks[0].center: "), std::string::npos) << result.err;
  // An exact number that is no binary64 would be another disk.
  directory_.write("bad.json", R"({"format":"voroproof-static-diagram","version":1,"frame":"none",
                   "disks":[{"center":[0,"1/3"],"radius":1}],"edges":[]})");
  result = judged({file("bad.json")});
  EXPECT_NE(result.err.find("bad.json:2: disks[0].center[1]: not a binary64"), std::string::npos)
      << result.err;
  EXPECT_EQ(run({"certify", file("a"), "--diagram", file("bad.json")}).code, 2);
  EXPECT_EQ(run({"certify", "--frame", "0,0,1"}).code, 2);
}

}  // namespace
}  // namespace voroproof::internal
