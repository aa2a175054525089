#include "history/diagram_file.h"

#include <gtest/gtest.h>

#include "history/error.h"
#include "history/validate.h"
#include "tests/history/temporary_directory.h"

namespace voroproof::internal {
namespace {

// Three disks, not in general the diagram of any: the topology of a tetrahedron.
DiagramFile example() {
  DiagramFile d;
  d.t_text = "1/3";
  d.t = 1.0 / 3;
  d.scene_sha256 = std::string(64, 'b');
  d.container_center = {0.5, -0.0};
  d.container_radius = 10;
  d.disks = {{{1, 2}, 0.25, {0, 1}}, {{3, 4}, 0, {-1, 0}}, {{5, 6}, 1e-9, {0, 0}}};
  d.vertices = {{{2, 1, -1}, {1, 1}, 2},
                {{0, 1, 2}, {0.1, 0}, 0},
                {{1, 0, -1}, {3, 3}, 1},
                {{0, 2, -1}, {4, 4}, 1}};
  // Each pair of generators has one edge, from the one vertex that contains both to the other.
  d.edges = {{0, 1, -1, 2}, {1, 2, -1, 0}, {2, 0, -1, 1},
             {0, -1, 2, 1}, {1, -1, 0, 2}, {2, -1, 1, 0}};
  return d;
}

const char* const example_text =
    "{\"format\":\"voroproof-diagram\",\"version\":1,\"t\":\"1/3\",\"scene_sha256\":"
    "\"bbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbb\",\n"
    "\"container\":{\"center\":[0.5,0],\"radius\":10},\n"
    "\"disks\":[\n"
    "{\"center\":[1,2],\"radius\":0.25,\"velocity\":[0,1]},\n"
    "{\"center\":[3,4],\"radius\":0,\"velocity\":[-1,0]},\n"
    "{\"center\":[5,6],\"radius\":1e-9,\"velocity\":[0,0]}],\n"
    "\"vertices\":[\n";

std::string fault(const std::string& text) {
  try {
    parse_diagram(text, "d");
    return "";
  } catch (const InputError& e) {
    return e.what();
  }
}

class DiagramFileTest : public testing::Test {
 protected:
  std::string write(const DiagramFile& diagram) {
    write_diagram(directory_.file("d"), diagram);
    EXPECT_EQ(directory_.number_of_files(), 1u);
    return directory_.read("d");
  }

  TemporaryDirectory directory_;
};

TEST_F(DiagramFileTest, Bytes) {
  const std::string text = write(example());
  ASSERT_TRUE(text.starts_with(example_text)) << text;
  EXPECT_EQ(text.substr(std::string(example_text).size()),
            "{\"generators\":[-1,0,2],\"center\":[4,4],\"radius\":1},\n"
            "{\"generators\":[-1,1,0],\"center\":[3,3],\"radius\":1},\n"
            "{\"generators\":[-1,2,1],\"center\":[1,1],\"radius\":2},\n"
            "{\"generators\":[0,1,2],\"center\":[0.1,0],\"radius\":0}],\n"
            "\"edges\":[\n"
            "[-1,0,1,2],\n[-1,1,2,0],\n[-1,2,0,1],\n[0,1,-1,2],\n[0,2,1,-1],\n[1,2,-1,0]]}\n");
}

TEST_F(DiagramFileTest, ReadsWhatItWrites) {
  const std::string text = write(example());
  const DiagramFile d = read_diagram(directory_.file("d"));
  EXPECT_EQ(d.t_text, "1/3");
  EXPECT_EQ(d.t, 1.0 / 3);
  EXPECT_EQ(d.container_center, (Vec2{0.5, 0}));
  EXPECT_EQ(d.container_radius, 10);
  ASSERT_EQ(d.disks.size(), 3u);
  EXPECT_EQ(d.disks[2].radius, 1e-9);
  EXPECT_EQ(d.disks[1].velocity, (Vec2{-1, 0}));
  ASSERT_EQ(d.vertices.size(), 4u);
  EXPECT_EQ(d.vertices[1].generators, (Triple{-1, 1, 0}));
  EXPECT_EQ(write(d), text);
  EXPECT_EQ(validate_file(directory_.file("d")), "diagram: 3 disks, 4 vertices, 6 edges");
}

TEST_F(DiagramFileTest, SmallDiagrams) {
  DiagramFile d = example();
  d.t_text = "";
  d.t = 0.1;
  d.disks.resize(2);
  d.vertices = {{{-1, 0, 1}, {0, 0}, 1}, {{-1, 1, 0}, {0, 0}, 1}};
  d.edges = {{-1, 0, 1, 1}, {-1, 1, 0, 0}, {0, 1, -1, -1}};
  const std::string two = write(d);
  EXPECT_NE(two.find("\"t\":0.1,"), std::string::npos);
  EXPECT_EQ(fault(two), "");
  EXPECT_EQ(parse_diagram(two, "d").t_text, "");
  d.vertices.clear();
  d.edges.clear();
  EXPECT_NE(fault(write(d)), "");
  d.disks.resize(1);
  EXPECT_EQ(fault(write(d)), "");
  d.disks.clear();
  EXPECT_EQ(fault(write(d)), "");
}

TEST_F(DiagramFileTest, BadFiles) {
  const std::string good = write(example());
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    EXPECT_NE(text.find(from), std::string::npos) << from;
    return fault(text.replace(text.find(from), from.size(), to));
  };
  EXPECT_EQ(with("-diagram", "-scene"), "d:1: format: not \"voroproof-diagram\"");
  EXPECT_EQ(with("\"1/3\"", "-1"), "d:1: t: not in [0, 1e100]");
  EXPECT_EQ(with("\"1/3\"", "\"x\""), "d:1: t: not an exact number");
  EXPECT_EQ(with("bbb", "xbb"), "d:1: scene_sha256: not 64 lower-case hexadecimal digits");
  EXPECT_EQ(with("\"radius\":0.25", "\"radius\":-1"), "d:4: disks[0].radius: negative");
  EXPECT_EQ(with("[3,4],", "[3],"), "d:5: disks[1].center: not an array of 2 elements");
  EXPECT_EQ(with("[-1,0,2]", "[-1,0,0]"), "d:8: vertices[0].generators: generators not distinct");
  EXPECT_EQ(with("[-1,0,2]", "[0,1,3]"), "d:8: vertices[0].generators: no such disk");
  EXPECT_EQ(with("[-1,1,0]", "[0,2,-1]"),
            "d:9: vertices[1].generators: a vertex of the same name came before");
  EXPECT_EQ(with("[-1,0,2]", "[-1,2,0]"), "d:13: edges[0]: ends at [-1,0,2], which is no vertex");
  EXPECT_EQ(with("[-1,0,1,2],\n", ""), "d:12: edges: not the 6 of 3 disks");
  EXPECT_EQ(with("[-1,1,2,0]", "[-1,0,1,2]"),
            "d:14: edges[1]: ends at [-1,1,0] like another before it");
  EXPECT_EQ(with("[0,1,-1,2]", "[0,0,-1,2]"),
            "d:16: edges[3]: names no edge: its generators are not distinct");
  for (std::size_t length = 0; length + 2 < good.size(); ++length)
    ASSERT_NE(fault(good.substr(0, length)), "");
}

}  // namespace
}  // namespace voroproof::internal
