// Pictures: what is in them, their colours and sizes, and what is not drawn.
#include "apps/draw/render.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "history/diagram_file.h"
#include "history/error.h"
#include "tests/apps/draw/brute_diagrams.h"

namespace voroproof::internal::testing {
namespace {

std::string contents(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

class Render : public ::testing::Test {
 protected:
  Render() {
    folder_ = std::filesystem::temp_directory_path() /
              ("render_test_" + std::to_string(getpid()) + "_" +
               ::testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(folder_);
  }
  ~Render() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string svg_of(const DiagramFile& d) const {
    render_diagram(d, path("picture.svg"));
    return contents(path("picture.svg"));
  }

  std::filesystem::path folder_;
};

TEST_F(Render, SvgHasOnePathForEachPart) {
  const DiagramFile d = random_diagram(12, 3);
  const std::string svg = svg_of(d);
  EXPECT_EQ(svg.substr(0, 5), "<?xml");
  EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  // 33 edges, 22 vertices; for each disk its cell, arrow (2) and id. The areas and
  // the lines of the disks and the container may share a path or not.
  EXPECT_GE(count(svg, "<path"), 33 + 22 + 12 * 5 + 1);
  EXPECT_LE(count(svg, "<path"), 33 + 22 + 12 * 6 + 2);
}

TEST_F(Render, EqualDiagramsGiveEqualFiles) {
  const DiagramFile d = random_diagram(10, 4);
  render_diagram(d, path("a.svg"));
  render_diagram(random_diagram(10, 5), path("other.svg"));
  render_diagram(d, path("b.svg"));
  EXPECT_EQ(contents(path("a.svg")), contents(path("b.svg")));
  EXPECT_NE(contents(path("a.svg")), contents(path("other.svg")));
}

TEST_F(Render, PngOfTheGivenSize) {
  render_diagram(random_diagram(8, 6), path("picture.png"), {.size = 300});
  const std::string png = contents(path("picture.png"));
  ASSERT_GT(png.size(), 1000u);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  // Width and height in the header chunk, big-endian.
  EXPECT_EQ(png.substr(16, 8), std::string("\0\0\1\x2c\0\0\1\x2c", 8));
}

TEST_F(Render, NoDiskAndOneDisk) {
  DiagramFile empty;
  empty.container_radius = 5;
  const int container = count(svg_of(empty), "<path");
  EXPECT_GE(container, 1);
  // Cell and edge, the disk, its arrow (2) and its id.
  EXPECT_GE(count(svg_of(lone_disk()), "<path"), container + 5);
}

TEST_F(Render, NeighboursDifferInColour) {
  const DiagramFile d = random_diagram(16, 8);
  const std::string svg = svg_of(d);
  // The container is filled first, then the cells in the order of ids.
  std::vector<std::string> fills;
  auto at = svg.find("<path");
  for (std::size_t path = 0; path <= d.disks.size(); ++path) {
    const auto colour = svg.find("fill:rgb", at);
    fills.push_back(svg.substr(colour, svg.find(';', colour) - colour));
    at = svg.find("<path", at + 1);
  }
  EXPECT_GT(std::set<std::string>(fills.begin(), fills.end()).size(), 4u);
  for (const Quad& q : d.edges) {
    if (q.l == container_id) continue;
    EXPECT_NE(fills.at(1 + q.l), fills.at(1 + q.r)) << q.l << " and " << q.r;
  }
}

TEST_F(Render, RefusesOtherExtensions) {
  for (const char* name : {"picture", "picture.ps", "picture.gz", "png"})
    EXPECT_THROW(render_diagram(lone_disk(), path(name)), std::invalid_argument);
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(Render, RefusesSizesOutOfRange) {
  for (int size : {-1, 0, 15, 20001})
    EXPECT_THROW(render_diagram(lone_disk(), path("p.svg"), {.size = size}), std::invalid_argument);
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(Render, RefusesDiagramsThatAreNone) {
  const DiagramFile good = crack();
  DiagramFile d = good;
  d.edges.pop_back();  // two cells do not close
  EXPECT_THROW(render_diagram(d, path("p.svg")), std::invalid_argument);
  d = good;
  d.vertices.pop_back();
  EXPECT_THROW(render_diagram(d, path("p.svg")), std::invalid_argument);
  d = good;
  d.edges[0].e = 99;
  EXPECT_THROW(render_diagram(d, path("p.svg")), std::invalid_argument);
  d = good;
  d.container_radius = 0;
  EXPECT_THROW(render_diagram(d, path("p.svg")), std::invalid_argument);
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(Render, AnUnwritablePathLeavesNothing) {
  EXPECT_THROW(render_diagram(lone_disk(), path("missing/picture.svg")), OutputError);
  std::filesystem::create_directory(path("taken.png"));
  EXPECT_THROW(render_diagram(lone_disk(), path("taken.png")), OutputError);
  EXPECT_TRUE(std::filesystem::is_directory(path("taken.png")));
  std::filesystem::remove(path("taken.png"));
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

}  // namespace
}  // namespace voroproof::internal::testing
