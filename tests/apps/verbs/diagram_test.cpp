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

TEST_F(Cli, DiagramOfAWorldIsDrawnAtATime) {
  directory_.write(
      "w.json",
      R"({"format": "voroproof-scene", "version": 2, "horizon": 9, "contacts": "pass",)"
      R"( "frame": "none", "disks": [{"center": [0, 0], "radius": 3, "velocity": [0, 0]},)"
      R"( {"center": [5, 0], "radius": 1, "velocity": [-1, 0], "enter": 2},)"
      R"( {"center": [0, 7], "radius": 1, "velocity": [0, 0], "growth": 1}]})");
  must({"diagram", file("w.json"), "--at", "7/2", "-o", file("a.svg")});
  must({"diagram", file("w.json"), "--at", "4", "-o", file("b.svg")});
  EXPECT_NE(directory_.read("a.svg"), directory_.read("b.svg"));
  directory_.write("same.csv", "name,x,y,r\n0,0,0,3\n1,3.5,0,1\n2,0,7,4.5\n");
  must({"diagram", file("same.csv"), "-o", file("c.svg")});
  EXPECT_EQ(directory_.read("a.svg"), directory_.read("c.svg"));
  directory_.write("first.csv", "name,x,y,r\n0,0,0,3\n2,0,7,1\n");
  must({"diagram", file("first.csv"), "-o", file("c.svg")});
  must({"diagram", file("w.json"), "--at", "0", "-o", file("a.svg")});
  EXPECT_EQ(directory_.read("a.svg"), directory_.read("c.svg"));
  refused({"diagram", file("w.json"), "-o", file("n.svg")}, "--at");
  refused({"diagram", file("w.json"), "--at", "10", "-o", file("n.svg")}, "horizon");
  refused({"diagram", file("w.json"), "--at", "1", "-o", file("n.json")}, "pictures");
  refused({"diagram", file("same.csv"), "--at", "1", "-o", file("n.svg")}, "at rest");
}

TEST_F(Cli, DiagramBetweenWallsHasFourGeneratorsMore) {
  directory_.write("towns.csv", towns);
  must({"diagram", file("towns.csv"), "--frame=-2,-3,7,5", "-o", file("a.json")});
  const Json a = json("a.json");
  EXPECT_EQ(a["frame"], Json::parse(R"({"low":[-2,-3],"high":[7,5]})"));
  EXPECT_EQ(a["edges"].size(), 21U);  // 3 (4 + 4 + 1) - 6
  EXPECT_EQ(a["vertices"].size(), 10U);
  must({"diagram", file("towns.csv"), "--frame=-2,-3,7,5", "-o", file("a.svg")});
  must({"diagram", file("towns.csv"), "--frame=-2,-3,7,5", "-o", file("a.geojson")});
  directory_.write("b.csv", "x,y,r\n1,2,1\n1,-1,1\n");
  must({"diagram", file("b.csv"), "--frame=0,0,7,5", "-o", file("b.json")});
  EXPECT_EQ(json("b.json")["disks"][1]["hidden_by"], 3);
  refused({"diagram", file("b.csv"), "--frame", "1,0,0,9", "-o", file("a.json")}, "--frame");
  refused({"diagram", file("b.csv"), "--frame", "1,0,3,9,9", "-o", file("a.json")}, "--frame");
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
  refused({"diagram", file("b.csv"), "--size", "100", "-o", file("a.geojson")}, "--size");
  for (const std::string picture : {"a.svg", "a.png", "a.pdf"}) {
    refused({"diagram", file("a.csv"), "-o", file(picture)}, "a.csv:2: radius: ");
    refused({"diagram", file("b.csv"), "--size", "15", "-o", file(picture)}, "--size");
    refused({"diagram", file("b.csv"), "--box", "0,0,0,1", "-o", file(picture)}, "--box");
    refused({"diagram", file("b.csv"), "--tolerance", "1", "-o", file(picture)}, "--tolerance");
  }
}

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST_F(Cli, DiagramOfATableIsAPicture) {
  directory_.write("towns.csv", towns);
  must({"diagram", file("towns.csv"), "-o", file("a.svg")});
  const std::string svg = directory_.read("a.svg");
  must({"diagram", file("towns.csv"), "-o", file("b.svg")});
  EXPECT_EQ(svg, directory_.read("b.svg"));
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  // The hidden disk alone has a broken rim; edges are curves; names are written in letters.
  EXPECT_EQ(count(svg, "stroke-dasharray"), 1);
  EXPECT_GE(count(svg, " C "), 6);
  EXPECT_GE(count(svg, "<use "), 3);
  must({"diagram", file("towns.csv"), "--size", "300", "-o", file("a.png")});
  EXPECT_EQ(directory_.read("a.png").substr(16, 8), std::string("\0\0\1\x2c\0\0\1\x2c", 8));
  must({"diagram", file("towns.csv"), "--size", "400", "-o", file("a.pdf")});
  const std::string pdf = directory_.read("a.pdf");
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  EXPECT_EQ(count(pdf, "20000101000000"), 1);  // not the clock's
  EXPECT_EQ(count(pdf, "[ 0 0 300 300 ]"), 1);
}

TEST_F(Cli, DiskHasOneColourInAllPictures) {
  // Disk 9 has colours between two of the palette, here alone and there in company.
  constexpr const char *cell = "rgb(96.177833%,84.233437%,81.206563%)",
                       *disk = "rgb(88.055728%,50.72949%,41.27051%)";
  std::string table = "x,y,r\n";
  for (int k = 0; k < 10; ++k)
    table += std::to_string(3 * k) + "," + std::to_string(k * k) + ",1\n";
  directory_.write("a.csv", table);
  must({"diagram", file("a.csv"), "--box", "26,80,28,82", "-o", file("a.svg")});
  directory_.write("b.csv", table + "27,-80,2\n20,90,1\n");
  must({"diagram", file("b.csv"), "-o", file("b.svg")});
  const std::string scene = reference(10, "1");
  must({"snapshot", scene, "--at", "0", "-o", file("c.json")});
  must({"render", file("c.json"), "-o", file("c.svg")});
  for (const char* picture : {"a.svg", "b.svg", "c.svg"}) {
    for (const char* colour : {cell, disk}) {
      EXPECT_EQ(count(directory_.read(picture), colour), 1) << picture << ' ' << colour;
    }
  }
}

TEST_F(Cli, DiagramIsDrawnWhateverTheDisksAre) {
  const auto draw = [&](const std::string& table, const Arguments& more = {}) {
    directory_.write("a.csv", table);
    Arguments words{"diagram", file("a.csv"), "-o", file("a.svg")};
    words.insert(words.end(), more.begin(), more.end());
    must(words);
    const std::string svg = directory_.read("a.svg");
    EXPECT_EQ(svg.find("nan"), std::string::npos) << table;
    EXPECT_EQ(svg.find("inf"), std::string::npos) << table;
    return svg;
  };
  draw("x,y,r\n");
  draw("1,2,3\n");
  draw("1,2,3\n", {"--frame", "0,0,9"});
  draw("0,0,0\n1,0,0\n2,0,0\n");
  draw("0,0,-5\n10,0,3\n");
  draw("0,0,1e90\n5,0,1\n");
  draw("0,0,1e90\n3e90,0,1e90\n", {"--box", "1.5e90,0,1.6e90,1e80"});
  // From inside of a disk, and at the rim of one that is a million times larger than the box.
  draw("0,0,1e9\n3e9,0,1\n", {"--box", "0,0,1,1"});
  EXPECT_GE(count(draw("0,0,1e6\n3e6,0,1\n", {"--box", "999999,-1,1000001,1"}), "<path"), 3);
  std::string dense;
  for (int k = 0; k < 300; ++k)
    dense += std::to_string(k % 7) + "," + std::to_string(k % 11) + ",1\n";
  draw(dense);
}

// In cells that have room for them, and not on the centre of a disk that is hidden there.
TEST_F(Cli, DiagramHasLabelsOnlyWhereTheyFit) {
  const auto labels = [&](const std::string& table) {
    directory_.write("a.csv", table);
    must({"diagram", file("a.csv"), "-o", file("a.svg")});
    const std::string svg = directory_.read("a.svg");
    return count(svg, "<use ");
  };
  EXPECT_EQ(labels("name,x,y,r\nA,0,0,1\nB,9,0,1\n"), 2);
  EXPECT_EQ(labels("name,x,y,r\n,0,0,1\nB,9,0,1\n"), 1);
  EXPECT_EQ(labels("name,x,y,r\n\xff,0,0,1\n\xed\xa0\x80,9,0,1\n"), 4);  // no UTF-8
  // The cell of the one in the middle has no room for its name.
  EXPECT_EQ(labels("name,x,y\nA,-9,0\nBBBB,0,0\nC,0.1,0\nD,-0.1,0\nE,9,0\n"), 4);
  EXPECT_EQ(labels("name,x,y,r\n" + std::string(300, 'm') + ",0,0,1\nB,9,0,1\n"), 1);
  EXPECT_EQ(labels("name,x,y,r\nA,0,0,5\n"), 1);
  EXPECT_NE(directory_.read("a.svg").find(" x=\"49"), std::string::npos);
  EXPECT_NE(directory_.read("a.svg").find(" y=\"50"), std::string::npos);
  EXPECT_EQ(labels("name,x,y,r\nA,0,0,5\nB,0,0,1\n"), 2);
  EXPECT_EQ(directory_.read("a.svg").find(" y=\"50"), std::string::npos);
}

}  // namespace
}  // namespace voroproof::internal
