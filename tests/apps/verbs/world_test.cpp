// Worlds on the command line: simulate, certify and validate.
#include <string>

#include "tests/apps/verbs/cli.h"

namespace voroproof::internal {
namespace {

constexpr const char* meeting =
    R"({"format":"voroproof-scene","version":2,"horizon":12,"contacts":"pass","frame":"none",
"disks":[{"center":[0,0],"radius":3,"velocity":[0,0]},
{"center":[-6,0],"radius":1,"velocity":[1,0]},
{"center":[0,9],"radius":1,"velocity":[0,0],"enter":1,"leave":11}]}
)";

class WorldCli : public Cli {
 protected:
  void SetUp() override {
    directory_.write("w.json", meeting);
    must({"simulate", file("w.json"), "-o", file("w.jsonl"), "--quiet"});
  }
  std::string history() const { return directory_.read("w.jsonl"); }
  // Writes the history with one text in place of another.
  void change(const std::string& from, const std::string& to) {
    std::string text = history();
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << text;
    directory_.write("b.jsonl", text.replace(at, from.size(), to));
  }
};

TEST_F(WorldCli, HistoryIsWrittenAndCertified) {
  const std::string text = history();
  EXPECT_NE(text.find(R"({"t":4,"hide":[1,0]})"), std::string::npos) << text;
  EXPECT_NE(text.find(R"({"t":8,"appear":[1,0],"at":[0,)"), std::string::npos) << text;
  EXPECT_NE(text.find(R"({"t":1,"jump":2,"at":[)"), std::string::npos) << text;
  const Result certified = must({"certify", file("w.json"), file("w.jsonl")});
  EXPECT_NE(certified.out.find("c all events of a world, up to t = 12, times within 1e-6\n"
                               "s CERTIFIED\n"),
            std::string::npos)
      << certified.out;
  EXPECT_NE(must({"validate", file("w.json")}).out.find("world: 3 disks"), std::string::npos);
  EXPECT_NE(must({"validate", file("w.jsonl")}).out.find("history of a world: "),
            std::string::npos);
}

TEST_F(WorldCli, WrongHistoryIsRefuted) {
  change(R"({"t":4,"hide":[1,0]})", R"({"t":4.5,"hide":[1,0]})");
  const Result wrong = run({"certify", file("w.json"), file("b.jsonl")});
  EXPECT_EQ(wrong.code, 1);
  EXPECT_TRUE(wrong.out.ends_with("s REFUTED\n")) << wrong.out;
  EXPECT_NE(wrong.err.find("b.jsonl: line "), std::string::npos) << wrong.err;
}

TEST_F(WorldCli, HistoryUpToAnotherHorizonSaysSo) {
  must({"simulate", file("w.json"), "-o", file("h.jsonl"), "--horizon", "5", "--quiet"});
  const Result part = must({"certify", file("w.json"), file("h.jsonl"), "--quiet"});
  EXPECT_EQ(part.out,
            "c all events of a world, up to t = 5, times within 1e-6\n"
            "c horizon 5 of the scene's 12\ns CERTIFIED\n");
  refused({"simulate", file("w.json"), "-o", file("i.jsonl"), "--horizon", "13"}, "--horizon");
}

TEST_F(WorldCli, LimitsEndARun) {
  const Result few = run({"simulate", file("w.json"), "-o", file("f.jsonl"), "--max-events", "2"});
  EXPECT_EQ(few.code, 3);
  const std::string whole = history(), part = directory_.read("f.jsonl");
  const std::size_t last = part.find("{\"stopped\"");
  ASSERT_NE(last, std::string::npos) << part;
  EXPECT_EQ(part.substr(0, last), whole.substr(0, last));
  EXPECT_NE(part.find("\"jump\":2"), std::string::npos) << part;
  const Result stopped = run({"certify", file("w.json"), file("f.jsonl")});
  EXPECT_EQ(stopped.code, 3);
  EXPECT_TRUE(stopped.out.ends_with("s UNDECIDED\n")) << stopped.out;
  EXPECT_EQ(run({"certify", file("w.json"), file("w.jsonl"), "--max-events", "2"}).code, 3);
}

// Points on a lattice, where the engine has been seen to err: nothing is written that is not
// proved.
TEST_F(WorldCli, WhatIsNotProvedIsNotWritten) {
  directory_.write("l.json",
                   R"({"format":"voroproof-scene","version":2,"horizon":4,"contacts":"pass",
"frame":"none","disks":[{"center":[3,1],"radius":0,"velocity":[0,1]},
{"center":[0,2],"radius":1,"velocity":[0,-1]},{"center":[-2,-1],"radius":0,"velocity":[1,1]},
{"center":[-1,1],"radius":1,"velocity":[1,-1]},{"center":[0,2],"radius":0,"velocity":[-1,-1]}]}
)");
  const Result told = run({"simulate", file("l.json"), "-o", file("l.jsonl")});
  const Result judged = run({"certify", file("l.json"), file("l.jsonl")});
  EXPECT_EQ(judged.code, told.code) << judged.err;
  if (told.code != 0) {
    EXPECT_EQ(told.code, 3);
    EXPECT_NE(told.err.find("the certifier does not prove what follows"), std::string::npos);
  }
}

// A disk comes to the place of its like; a point touches both from inside, and turns then.
TEST_F(WorldCli, ARunEnds) {
  directory_.write("e.json",
                   R"({"format":"voroproof-scene","version":2,"contacts":"pass","horizon":6,
"frame":{"center":[1,0],"radius":20},"disks":[
{"center":[5,6],"radius":1,"velocity":[2,2],"enter":3},{"center":[5,6],"radius":1,"velocity":[0,0]},
{"center":[-2,3],"radius":0,"velocity":[2,1]}],"maneuvers":[{"t":3,"disk":2,"velocity":[-2,0]}]})");
  const Result told = run({"simulate", file("e.json"), "-o", file("e.jsonl")});
  EXPECT_TRUE(told.code == 0 || told.code == 3) << told.err;
}

TEST_F(WorldCli, OtherVerbsAndOptionsRefuseIt) {
  refused({"simulate", file("w.json"), "-o", file("s.jsonl"), "--resume"}, "--resume");
  refused({"snapshot", file("w.json"), "--at", "1", "-o", file("s.json")}, "version");
  const Result kernel = run({"certify", file("w.json"), file("w.jsonl"), "--kernel"});
  EXPECT_EQ(kernel.code, 2);
  EXPECT_NE(kernel.err.find("a world"), std::string::npos) << kernel.err;
  EXPECT_TRUE(kernel.out.find("CERTIFIED") == std::string::npos) << kernel.out;
}

}  // namespace
}  // namespace voroproof::internal
