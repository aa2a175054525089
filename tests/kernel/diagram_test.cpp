// Incidences that are no diagram, first diagrams that are none of these disks, and parts.
#include "certify/kernel/diagram.h"

#include <map>

#include "tests/kernel/histories.h"

namespace voroproof_kernel {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

// The edges between counterclockwise triangles.
std::vector<Quad> edges_of(const Triangles& triangles) {
  std::map<std::pair<int, int>, int> apex;
  for (const auto& [a, b, c] : triangles) {
    for (const auto& [l, r, e] : {std::array{a, b, c}, {b, c, a}, {c, a, b}}) apex[{l, r}] = e;
  }
  std::vector<Quad> edges;
  for (const auto& [two, e] : apex) {
    const auto [l, r] = two;
    if (l < r) edges.push_back({l, r, apex.at({r, l}), e});
  }
  return edges;
}

Triangles tetrahedron(int a, int b, int c, int d) {
  return {{a, b, c}, {a, c, d}, {a, d, b}, {b, d, c}};
}

// The torus of seven vertices.
Triangles torus() {
  Triangles all;
  for (int k = 0; k < 7; ++k) {
    all.push_back({k - 1, (k + 1) % 7 - 1, (k + 3) % 7 - 1});
    all.push_back({k - 1, (k + 3) % 7 - 1, (k + 2) % 7 - 1});
  }
  return all;
}

Triangles both(Triangles a, const Triangles& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::string refused(const std::vector<Quad>& edges, int n) {
  try {
    Diagram(edges, n);
  } catch (const Stop& stop) {
    EXPECT_EQ(stop.verdict, Verdict::refuted);
    return stop.reason;
  }
  return "";
}

TEST(KernelDiagram, OnlySpheresAreDiagrams) {
  const std::string wrong = "wrong initial diagram: ";
  EXPECT_EQ(refused(edges_of(tetrahedron(-1, 0, 1, 2)), 3), "");
  EXPECT_EQ(refused(edges_of(torus()), 6), wrong + "not 3 (n + 1) - 6 edges");
  // These have the right number of edges: a torus beside a sphere, and two spheres that share two
  // vertices.
  EXPECT_EQ(refused(edges_of(both(torus(), tetrahedron(6, 7, 8, 9))), 10), wrong + "not connected");
  std::vector<Quad> pinched = edges_of(tetrahedron(-1, 0, 1, 2));
  for (const Quad& q : edges_of(tetrahedron(-1, 0, 3, 4))) pinched.push_back(q);
  EXPECT_EQ(refused(pinched, 5), wrong + "the edges of a generator are not one ring");
}

TEST(KernelDiagram, AnEdgeBetweenTwoVerticesOfTheSameThreeStays) {
  Diagram two({{-1, 0, 1, 1}, {-1, 1, 0, 0}, {0, 1, -1, -1}}, 2);
  for (int k = 0; k < 3; ++k) EXPECT_THROW(two.flip(k), Stop);
}

// Five disks in the order of the corners of a pentagram, and one in their middle: all circles exist
// and all edges are legal, but the cells of that one and of the container wind twice. The mirror
// images of both have no circles.
TEST(KernelDiagram, CellsThatWindTwice) {
  const char* corner[5][2] = {{"10", "0"}, {"3", "9.5"}, {"-8", "6"}, {"-8", "-6"}, {"3", "-9.5"}};
  for (const int step : {1, 2, 3, 4}) {
    std::string disks, initial;
    const auto text = [](int l, int r, int s, int e) { return name(Quad{l, r, s, e}); };
    for (int k = 0; k < 5; ++k) {
      const auto& [x, y] = corner[k * step % 5];
      disks += disk(x, y, "1", "0", "0") + ",";
      const int before = (k + 4) % 5, after = (k + 1) % 5;
      initial += (k == 0 ? "[" : ",") + text(5, k, before, after) + "," + text(k, after, -1, 5) +
                 "," + text(-1, k, after, before);
    }
    const std::string scene = scene_of(disks + disk("0", "0", "1", "0", "0"));
    const Result r = check(scene, history_of(scene, {}, "3", initial + "]"), {});
    EXPECT_EQ(r.verdict, step == 1 ? Verdict::certified : Verdict::refuted);
    const char* why = step == 1 ? "" : step == 2 ? "turn 2 times" : "does not exist";
    EXPECT_NE(r.reason.find(why), std::string::npos) << r.reason;
  }
}

// What a part does not decide is not decided, whatever the others find.
TEST(KernelDiagram, APointThatTouchesAtTheStart) {
  const std::string scene =
      scene_of(disk("-1", "0", "0", "-1", "0") + "," + disk("0", "0", "1", "0", "0"));
  const Result r = check(scene, history_of(scene, {}), {});
  EXPECT_EQ(r.verdict, Verdict::undecided);
  EXPECT_EQ(r.reason, "a point touches another generator at the start");
}

TEST(KernelDiagram, CountsOfTheLastLine) {
  const std::string scene =
      scene_of(disk("-9", "0", "1", "0", "0") + "," + disk("9", "0", "1", "0", "0"));
  const std::string right = history_of(scene, {});
  EXPECT_EQ(check(scene, right, {}).verdict, Verdict::certified);
  for (const std::string what : {"flips", "collisions", "maneuvers"}) {
    std::string wrong = right;
    const std::string field = "\"" + what + "\":0";
    wrong.replace(wrong.find(field), field.size(), "\"" + what + "\":1");
    const Result r = check(scene, wrong, {});
    EXPECT_EQ(r.verdict, Verdict::refuted);
    EXPECT_EQ(r.reason, "bad count");
    EXPECT_TRUE(r.is_first);
  }
}

// Parts leave out no claim and no time.
TEST(KernelDiagram, PartsFollowEachOther) {
  Problem p;
  p.tolerance = Rat(1, 1000000);
  p.history.horizon = 10000;
  for (int k = 0; k < 9000; ++k) {
    Claim c{};
    c.t = c.filed = k;
    p.history.claims.push_back(c);
  }
  const std::vector<Part> parts = parts_of(p);
  ASSERT_GT(parts.size(), 2U);
  std::size_t next = 0;
  Rat from = 0;
  for (const Part& part : parts) {
    EXPECT_EQ(part.first, next);
    EXPECT_EQ(part.begin, from);
    if (next > 0) {
      EXPECT_LT(p.history.claims[next - 1].t, part.begin);
      EXPECT_LT(part.begin, p.history.claims[next].t);
    }
    next = part.last;
    from = part.end;
  }
  EXPECT_EQ(next, p.history.claims.size());
  EXPECT_EQ(from, p.history.horizon);
}

// A part begins with the diagram that the flips before it lead to: it is refuted where one of them
// names no edge, as the first part is.
TEST(KernelDiagram, FlipsOfNoEdgeBeforeAPart) {
  const std::string scene =
      scene_of(disk("-9", "0", "1", "0", "0") + "," + disk("9", "0", "1", "0", "0") + "," +
                   disk("0", "9", "1", "0", "0"),
               "10000");
  std::string initial = "[";
  for (const Quad& q : edges_of(tetrahedron(-1, 0, 2, 1))) {
    initial += (initial.size() > 1 ? ",[" : "[") + std::to_string(q.l) + "," + std::to_string(q.r) +
               "," + std::to_string(q.s) + "," + std::to_string(q.e) + "]";
  }
  initial += "]";
  std::vector<std::string> claims;
  for (int k = 1; k < 9000; ++k) {
    claims.push_back("{\"t\":" + std::to_string(k) + ",\"flip\":[0,1,-1,-1]}");
  }
  const Result r = check(scene, history_of(scene, claims, "10000", initial), {});
  EXPECT_EQ(r.verdict, Verdict::refuted);
  EXPECT_EQ(r.reason, "wrong quadruple: the diagram has no such edge");
  EXPECT_FALSE(r.is_first);
  EXPECT_EQ(r.line, 2);
}

}  // namespace
}  // namespace voroproof_kernel
