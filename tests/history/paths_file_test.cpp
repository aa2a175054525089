// Files of given paths, and what is wrong with them.
#include "history/paths_file.h"

#include <gtest/gtest.h>

#include "history/error.h"
#include "tests/history/temporary_directory.h"

namespace voroproof::internal {
namespace {

class PathsFile : public ::testing::Test {
 protected:
  GivenPaths read(const std::string& text, std::optional<Rational> radius = 1,
                  Beyond beyond = Beyond::vanishes) {
    directory_.write("a", text);
    return read_paths(directory_.file("a"), radius, beyond);
  }
  void refused(const std::string& text, std::int64_t line, const std::string& field,
               std::optional<Rational> radius = 1) {
    try {
      read(text, radius);
      ADD_FAILURE() << "accepted: " << text;
    } catch (const InputError& e) {
      EXPECT_EQ(e.line(), line) << e.what() << text;
      EXPECT_EQ(e.field(), field) << e.what() << text;
    }
  }
  static std::string log(const std::string& inner) {
    return "<root><log>" + inner + "</log></root>";
  }
  static std::string section(const std::string& from, const std::string& to,
                             const std::string& duration) {
    return "<section start_i='" + from + "' start_j='0' goal_i='" + to + "' goal_j='0' duration='" +
           duration + "'/>";
  }
  static std::string agent(const std::string& sections, const std::string& number = "7") {
    return "<agent number='" + number + "'><path>" + sections + "</path></agent>";
  }

  TemporaryDirectory directory_;
};

TEST_F(PathsFile, NumbersOfATableAreExact) {
  const GivenPaths g =
      read("# made by hand\r\n\n y , x,t,disk \r\n0.1,1/3,0,a b\n2,3,0,c\n1,1,1e-1,a b");
  ASSERT_EQ(g.paths.size(), 2u);
  EXPECT_EQ(g.paths[0].name, "a b");
  EXPECT_EQ(g.paths[0].radius, 1);
  ASSERT_EQ(g.paths[0].waypoints.size(), 2u);
  EXPECT_EQ(g.paths[0].waypoints[0].at[0], Rational(1, 3));
  EXPECT_EQ(g.paths[0].waypoints[0].at[1], Rational(1, 10));
  EXPECT_EQ(g.paths[0].waypoints[1].t, Rational(1, 10));
  EXPECT_EQ(read("disk,t,x,y,radius\na,0,0,0,2\n", std::nullopt).paths[0].radius, 2);
  EXPECT_TRUE(read("disk,t,x,y\n").paths.empty());
}

TEST_F(PathsFile, RemarksOfATable) {
  const GivenPaths g = read(
      "# remark: walls are left out \r\n# no remark\n# remarks: nor this\ndisk,t,x,y\na,0,0,0\n"
      "# remark: \x1b[1m\n");
  EXPECT_EQ(g.remarks, (std::vector<std::string>{"walls are left out", "\\x1b[1m"}));
  std::string many = "disk,t,x,y\n";
  for (std::size_t k = 0; k <= max_remarks; ++k) many += "# remark: a\n";
  refused(many, static_cast<std::int64_t>(max_remarks) + 2, "remark");
}

TEST_F(PathsFile, WhatATableLacks) {
  for (const char* spelling : {"# missing:", "#missing:", "#  missing:", "#\tmissing:",
                               "# Missing: ", " # MISSING :", "## missing:\t"}) {
    const GivenPaths g = read("disk,t,x,y\n" + std::string(spelling) + "a ship\na,0,0,0\n");
    EXPECT_EQ(g.missing, std::vector<std::string>{"a ship"}) << spelling;
    EXPECT_EQ(g.missing_line, 2);
    EXPECT_TRUE(g.remarks.empty());
  }
  for (const char* other : {"# nothing is missing: all", "# missing", "#", "# : missing:"}) {
    EXPECT_TRUE(read(std::string(other) + "\ndisk,t,x,y\n").missing.empty()) << other;
  }
}

// Tables and plans agree on where a disk is beyond its own waypoints.
TEST_F(PathsFile, WhatIsBeyondAPathIsSaid) {
  const std::string table = "disk,t,x,y\na,0,0,0\na,2,2,0\nb,1,5,5\n";
  const std::string plan = log(agent(section("0", "1", "2")) + agent(section("9", "8", "1"), "8"));
  for (const std::string& text : {table, plan}) {
    EXPECT_THROW(read(text, 1, Beyond::unsaid), InputError) << text;
    const GivenPaths gone = read(text, 1, Beyond::vanishes);
    ASSERT_EQ(gone.paths.size(), 2u);
    EXPECT_EQ(gone.paths[1].waypoints.back().t, 1);
    EXPECT_NE(gone.remarks.back().find("1 of 2 disks are taken to be nowhere"), std::string::npos);
    const GivenPaths parked = read(text, 1, Beyond::stays);
    for (const GivenPath& p : parked.paths) {
      EXPECT_EQ(p.waypoints.front().t, 0);
      EXPECT_EQ(p.waypoints.back().t, 2);
    }
    EXPECT_EQ(parked.paths[1].waypoints.back().at[0], gone.paths[1].waypoints.back().at[0]);
    EXPECT_NE(parked.remarks.back().find("1 of 2 disks are taken to stay"), std::string::npos);
  }
  EXPECT_EQ(read(table, 1, Beyond::stays).paths[1].waypoints.size(), 3u);
  // Where all are there all the time nothing is to be said.
  const std::string whole = "disk,t,x,y\na,0,0,0\na,2,2,0\nb,0,5,5\nb,2,5,6\n";
  for (const Beyond beyond : {Beyond::unsaid, Beyond::stays, Beyond::vanishes}) {
    EXPECT_TRUE(read(whole, 1, beyond).remarks.empty());
  }
}

TEST_F(PathsFile, BrokenTables) {
  refused("", 0, "");
  refused("disk,t,x\n", 1, "y");
  refused("disk,t,x,y,height\n", 1, "height");
  refused("disk,t,x,y,x\n", 1, "x");
  refused("disk,t,x,y\n", 1, "radius", std::nullopt);
  refused("disk,t,x,y\na,0,0\n", 2, "");
  refused("disk,t,x,y\n,0,0,0\n", 2, "disk");
  refused("disk,t,x,y\na,0,zero,0\n", 2, "x");
  refused("disk,t,x,y\na,0,0,1e101\n", 2, "y");
  refused("disk,t,x,y\na,1,0,0\nb,0,0,0\na,1,0,1\n", 4, "t");
  refused("disk,t,x,y,radius\na,1,0,0,-1\n", 2, "radius");
  refused("disk,t,x,y,radius\na,1,0,0,1\na,2,0,0,2\n", 3, "radius");
}

TEST_F(PathsFile, Space) {
  const GivenPaths g = read("z,disk,t,x,y\n1/3,a,0,1,2\n");
  EXPECT_TRUE(g.in_space);
  EXPECT_EQ(g.paths[0].waypoints[0].at, (Vec3{1, 2, Rational(1, 3)}));
  EXPECT_FALSE(read("disk,t,x,y\n").in_space);
}

TEST_F(PathsFile, PiecesFollowEachOther) {
  const GivenPaths g = read(
      "disk,t,duration,x^0,x^2,y^0\n"
      "a,1,2,0,1/2,5\na,3,1,2,0,5\n"
      "b,1,2,0,0,0\nb,3,1,3,0,4\n");
  ASSERT_EQ(g.paths.size(), 2u);
  ASSERT_EQ(g.paths[0].waypoints.size(), 3u);
  EXPECT_EQ(g.paths[0].waypoints[1].t, 3);
  EXPECT_EQ(g.paths[0].waypoints[1].at, (Vec3{2, 5, 0}));
  EXPECT_EQ(g.paths[0].curves[0], (Curve{{0, 5, 0}, {0, 0, 0}, {Rational(1, 2), 0, 0}}));
  // The second jumps by 5, and says so.
  ASSERT_EQ(g.paths[1].waypoints.size(), 4u);
  EXPECT_EQ(g.paths[1].waypoints[2].t, 3);
  EXPECT_TRUE(g.paths[1].curves[1].empty());
  ASSERT_EQ(g.remarks.size(), 1u);
  EXPECT_EQ(
      g.remarks[0],
      "1 pieces begin elsewhere than the one before ends, by up to 5: the disk is taken to go "
      "there straight, at once");
  // Who is there for a shorter time may stay.
  const GivenPaths parked =
      read("disk,t,duration,x^0,x^1,y^0\na,0,4,0,1,0\nb,1,2,0,1,3\n", 1, Beyond::stays);
  EXPECT_EQ(parked.paths[1].waypoints.size(), 4u);
  EXPECT_EQ(parked.paths[1].curves.size(), 3u);
  EXPECT_EQ(parked.paths[1].waypoints.back().at, (Vec3{2, 3, 0}));
}

TEST_F(PathsFile, BrokenPieces) {
  const std::string heading = "disk,t,duration,x^0,x^1,y^0\n";
  refused("disk,t,duration,x^0\n", 1, "y^0");
  refused("disk,t,duration,x^1,y^0\n", 1, "x^0");
  refused("disk,t,duration,x^0,y^0,x^8\n", 1, "x^8");
  refused("disk,t,duration,x^0,y^0,x\n", 1, "x");
  refused("disk,t,duration,x^0,y^0,z^1\n", 1, "z^1");
  refused("disk,t,x^0,y^0\n", 1, "x^0");
  refused(heading + "a,0,0,1,1,1\n", 2, "duration");
  refused(heading + "a,0,1,0,0,0\na,2,1,0,0,0\n", 3, "t");
  refused(heading + "a,0,1,0,0,0\na,1/2,1,0,0,0\n", 3, "t");
  refused(heading + "a,0,1e60,0,1e60,0\n", 2, "x^1");
}

TEST_F(PathsFile, PeriodicBoxes) {
  const GivenPaths g = read("# periodic: 10, none\ndisk,t,x,y\na,0,1,2\n");
  EXPECT_EQ(g.sides, (Vec3{10, 0, 0}));
  EXPECT_TRUE(g.is_periodic());
  refused("# periodic: 10\ndisk,t,x,y\n", 1, "periodic");
  refused("\n# periodic: 10,0\ndisk,t,x,y\n", 2, "periodic");
  refused("# periodic: 10,ten\ndisk,t,x,y\n", 1, "periodic");
  refused("# periodic: 1,1\n# periodic: 1,1\ndisk,t,x,y\n", 2, "periodic");
  refused("# periodic: 1,none\ndisk,t,x,y\na,0,1e9,0\n", 1, "periodic");
  // A curve that leaves the box between its waypoints.
  refused("# periodic: 1,none\ndisk,t,duration,x^0,x^1,x^2,y^0\na,0,1,1/2,1e60,-1e60,0\n", 1,
          "periodic");
}

TEST_F(PathsFile, SectionsOfAPlanFollowEachOther) {
  const GivenPaths g =
      read(log(agent(section("0", "1", "0.1") + section("1", "1", "0") + section("1", "3", "0.2")) +
               agent(section("9", "9", "1"), "8")));
  ASSERT_EQ(g.paths.size(), 2u);
  ASSERT_EQ(g.paths[0].waypoints.size(), 3u);
  EXPECT_EQ(g.paths[0].waypoints[2].t, Rational(3, 10));
  EXPECT_EQ(g.paths[0].waypoints[2].at[0], 3);
}

TEST_F(PathsFile, BrokenPlans) {
  refused(log(""), 0, "radius", std::nullopt);
  refused("<root/>", 0, "root/log");
  refused("<root>\n<log>", 2, "");
  refused(log("</log><log>"), 1, "log");
  refused(log("<agent number='0'/>"), 1, "agent");
  refused(log("<agent/>"), 1, "number");
  refused(log(agent("\n" + section("0", "1", "1") + "\n" + section("2", "1", "1"))), 3, "start_i");
  refused(log(agent(section("0", "1", "-1"))), 1, "duration");
  refused(log(agent(section("0", "1", "0"))), 1, "duration");
  refused(log(agent(section("0", "one", "1"))), 1, "goal_i");
  const auto path = [](const std::string& sections) {
    return log("<agent number='7'>\n<path duration='3'>\n" + sections + "</path></agent>");
  };
  EXPECT_EQ(read(path(section("0", "1", "1") + section("1", "2", "1.99998"))).paths.size(), 1u);
  EXPECT_NE(
      read(path(section("0", "1", "1") + section("1", "2", "1.99998"))).remarks[0].find("2e-5"),
      std::string::npos);
  refused(path(section("0", "1", "1") + section("1", "2", "1.9")), 3, "duration");
  refused(path(section("0", "1", "1") + section("1", "2", "1")), 3, "duration");
  refused(path("<section number='1' start_i='0' start_j='0' goal_i='1' goal_j='0' duration='3'/>"),
          3, "number");
  const std::string whole = agent(section("0", "1", "1"));
  refused(log(whole + "\n" + agent(section("5", "6", "1"))), 2, "number");
  refused("<root><agent/><agent/>" + log(whole).substr(6), 1, "agent");
  EXPECT_EQ(read("<root><agent/>" + log("<summary/>" + whole).substr(6)).paths.size(), 1u);
  refused("<!DOCTYPE root [<!ENTITY a 'aaaa'>]>" + log(""), 1, "");
}

// Who is written in another way than solvers do is not passed over.
TEST_F(PathsFile, ElementsThatAPlanHasNot) {
  const std::string whole = agent(section("0", "1", "1")) + "\n";
  refused(log(whole + "<Agent number='8'/>"), 2, "Agent");
  refused(log(whole + "<agents>" + agent(section("5", "6", "1"), "8") + "</agents>"), 2, "agents");
  refused(log(agent(section("0", "1", "1") + "\n<step/>")), 2, "step");
  refused("<root>\n<Log>" + whole + "</Log></root>", 2, "Log");
  refused("<plan/>", 1, "plan");
}

}  // namespace
}  // namespace voroproof::internal
