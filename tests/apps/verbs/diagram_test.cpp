// The verb diagram: tables of disks as maps, diagrams and lists of edges.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/apps/verbs/cli.h"

namespace voroproof::internal {
namespace {

constexpr const char* towns =
    "name,lon,lat,weight\na,0,0,1\nb,4,0,2\nc,1,3,0.5\n\"d, e\",2,1,0\nf,4.1,0.2,0.3\n";

TEST_F(Cli, DiagramOfATableIsAMap) {
  directory_.write("towns.csv", towns);
  must({"diagram", file("towns.csv"), "-o", file("a.geojson")});
  const Json map = json("a.geojson");
  EXPECT_EQ(map["type"], "FeatureCollection");
  ASSERT_EQ(map["features"].size(), 5U);
  EXPECT_EQ(map["features"][3]["properties"]["name"], "d, e");
  EXPECT_EQ(map["features"][3]["geometry"]["type"], "Polygon");
  const Json& ring = map["features"][3]["geometry"]["coordinates"][0];
  EXPECT_EQ(ring.front(), ring.back());
  EXPECT_TRUE(map["features"][4]["geometry"].is_null());
  EXPECT_EQ(map["features"][4]["properties"]["hidden_by"], 1);
}

TEST_F(Cli, DiagramOfATableHasEdgesAndVertices) {
  directory_.write("towns.csv", towns);
  must({"diagram", file("towns.csv"), "-o", file("a.json")});
  const Json a = json("a.json");
  EXPECT_EQ(a["frame"], "none");
  EXPECT_EQ(a["edges"], Json::parse("[[-1,0,1,2],[-1,1,2,0],[-1,2,0,1],[0,1,-1,3],[0,2,3,-1],"
                                    "[0,3,1,2],[1,2,-1,3],[1,3,2,0],[2,3,0,1]]"));
  EXPECT_EQ(a["vertices"].size(), 3U);
  must({"diagram", file("towns.csv"), "--frame", "2,1,4", "-o", file("b.csv")});
  EXPECT_EQ(directory_.read("b.csv").substr(0, 21), "left,right,start,end\n");
}

TEST_F(Cli, DiagramRefusesWhatItCannotRead) {
  directory_.write("a.csv", "x,y,r\n1,2,nan\n");
  refused({"diagram", file("a.csv"), "-o", file("a.json")}, "a.csv:2: radius: ");
  directory_.write("b.csv", "x,y,r\n1,2,-1\n");
  refused({"diagram", file("b.csv"), "--frame", "0,0,9", "-o", file("a.json")}, "negative");
  refused({"diagram", file("b.csv"), "-o", file("a.txt")}, "--output");
  refused({"diagram", file("b.csv"), "--box", "0,0,1,1", "-o", file("a.json")}, "--box");
  refused({"diagram", file("b.csv"), "--box", "0,0,1", "-o", file("a.geojson")}, "--box");
  refused({"diagram", file("b.csv"), "--frame", "0,0,0", "-o", file("a.json")}, "--frame");
}

}  // namespace
}  // namespace voroproof::internal
