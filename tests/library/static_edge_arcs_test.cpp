// The arcs of a diagram of disks at rest: by the definition of its edges, and by its cells.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/library/disk_sets.h"
#include "voroproof/static_diagram.h"

namespace voroproof {
namespace {

Vector point(const Arc& arc, double t) {
  const double a = (1 - t) * (1 - t), b = 2 * t * (1 - t) * arc.weight, c = t * t, sum = a + b + c;
  const auto mean = [&](int axis) {
    return (a * arc.start[axis] + b * arc.control[axis] + c * arc.end[axis]) / sum;
  };
  return {mean(0), mean(1)};
}

double distance(const Vector& a, const Vector& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

// The distance from a generator's boundary.
double clearance(const StaticDiagram& d, int g, const Vector& p) {
  if (g >= 0) return distance(p, d.disks()[g].center) - d.disks()[g].radius;
  return d.frame()->radius - distance(p, d.frame()->center);
}

// The least distance from a generator's boundary.
double least_clearance(const StaticDiagram& d, const Vector& p) {
  double least = d.frame() ? clearance(d, -1, p) : std::numeric_limits<double>::infinity();
  for (std::size_t g = 0; g < d.disks().size(); ++g) {
    least = std::min(least, clearance(d, static_cast<int>(g), p));
  }
  return least;
}

// The clearances of two generators differ by at most twice the distance from where they are equal.
void expect_on_edges(const StaticDiagram& d, const Box& box) {
  constexpr double rounding = 1e-13;
  const auto edges = d.arcs(box);
  ASSERT_EQ(edges.size(), d.edges().size());
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const Edge& e = d.edges()[k];
    for (const Arc& arc : edges[k]) {
      EXPECT_LE(arc.error, 1e-10);
      EXPECT_GT(arc.weight, 0.49);
      EXPECT_LT(arc.weight, 1.4);
      for (int step = 0; step <= 8; ++step) {
        const Vector p = point(arc, step / 8.0);
        const double at_l = clearance(d, e.l, p), at_r = clearance(d, e.r, p);
        EXPECT_NEAR(at_l, at_r, 2 * arc.error + rounding);
        EXPECT_NEAR(at_l, least_clearance(d, p), 2 * arc.error + rounding);
        for (const int axis : {0, 1}) {
          EXPECT_GE(p[axis], box.low[axis] - arc.error);
          EXPECT_LE(p[axis], box.high[axis] + arc.error);
        }
      }
      for (const Vector& end : {arc.start, arc.end}) {
        for (const int axis : {0, 1}) {
          EXPECT_GE(end[axis], box.low[axis]);
          EXPECT_LE(end[axis], box.high[axis]);
        }
      }
    }
  }
}

TEST(StaticArcs, PointsAreOnTheEdgesAndInTheBox) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const auto disks = random_disks(seed, 30, seed % 2 ? 0.5 : 3);
    for (const bool framed : {false, true}) {
      std::optional<Circle> frame;
      if (framed) frame = Circle{{5, 5}, 6};
      const StaticDiagram d(disks, frame);
      SCOPED_TRACE(std::to_string(seed) + (framed ? ", framed" : ""));
      expect_on_edges(d, d.box());
      expect_on_edges(d, {{3.1, 3.2}, {4.7, 6.1}});
    }
  }
}

// The arcs of edges and the sides of the box are the boundaries of the cells.
TEST(StaticArcs, ArcsAreTheBoundariesOfCells) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const StaticDiagram d(random_disks(seed, 40, seed % 2 ? 0.5 : 3));
    for (const Box& box : {d.box(), Box{{2, 2.5}, {4.5, 4}}}) {
      double twice = 2 * (box.high[0] - box.low[0] + box.high[1] - box.low[1]), cells = 0;
      for (const auto& edge : d.arcs(box)) {
        for (const Arc& arc : edge) {
          constexpr int steps = 500;
          for (int k = 0; k < steps; ++k) {
            twice += 2 * distance(point(arc, 1.0 * k / steps), point(arc, (k + 1.0) / steps));
          }
        }
      }
      for (const Measure& m : d.measures(box)) cells += m.perimeter;
      EXPECT_NEAR(cells, twice, 1e-6 * twice) << seed;
    }
  }
}

TEST(StaticArcs, EdgesMeetInTheirVertices) {
  const StaticDiagram d(random_disks(3, 100, 1), Circle{{5, 5}, 7});
  const auto edges = d.arcs(d.box());
  const auto vertex = [&](std::array<int, 3> name) {
    std::rotate(name.begin(), std::min_element(name.begin(), name.end()), name.end());
    for (const Vertex& v : d.vertices()) {
      if (v.generators == name) return v.center;
    }
    return Vector{};
  };
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const Edge& e = d.edges()[k];
    ASSERT_FALSE(edges[k].empty());
    EXPECT_EQ(edges[k].front().start, vertex({e.l, e.s, e.r}));
    EXPECT_EQ(edges[k].back().end, vertex({e.l, e.r, e.e}));
    for (std::size_t j = 0; j + 1 < edges[k].size(); ++j) {
      EXPECT_EQ(edges[k][j].end, edges[k][j + 1].start);
    }
  }
}

TEST(StaticArcs, EdgesOfEqualDisksAreStraight) {
  const StaticDiagram d({{{0, 0}, 1}, {{2, 0}, 1}});
  const auto edges = d.arcs({{-1, -2}, {4, 1}});
  int found = 0;
  for (const auto& edge : edges) {
    if (edge.empty()) continue;
    ++found;
    double length = 0;
    for (const Arc& arc : edge) {
      EXPECT_EQ(arc.weight, 1);
      EXPECT_NEAR(arc.control[0], 1, 1e-14);
      EXPECT_NEAR(arc.control[1], (arc.start[1] + arc.end[1]) / 2, 1e-14);
      length += arc.end[1] - arc.start[1];
    }
    EXPECT_EQ(edge.front().start[1], -2);
    EXPECT_EQ(edge.back().end[1], 1);
    EXPECT_NEAR(length, 3, 1e-13);
  }
  EXPECT_EQ(found, 1);
}

TEST(StaticArcs, AnEdgeLeavesTheBoxAndComesBack) {
  // The edge is x = 2 - sqrt(1 + y^2 / 3), and the box ends left of its apex.
  const StaticDiagram d({{{0, 0}, 0}, {{4, 0}, 2}});
  const Box box{{-3, -2}, {0.875, 2}};
  int gaps = 0;
  expect_on_edges(d, box);
  for (const auto& edge : d.arcs(box)) {
    for (std::size_t k = 0; k + 1 < edge.size(); ++k) {
      if (edge[k].end == edge[k + 1].start) continue;
      ++gaps;
      EXPECT_NEAR(edge[k].end[0], 0.875, edge[k].error);
      const double y = std::sqrt(3 * (1.125 * 1.125 - 1));
      EXPECT_NEAR(std::fabs(edge[k].end[1]), y, 1e-12);
      EXPECT_NEAR(edge[k + 1].start[1], -edge[k].end[1], 1e-12);
    }
  }
  EXPECT_EQ(gaps, 1);
}

TEST(StaticArcs, PowersOfTwoScaleExactly) {
  const auto disks = random_disks(4, 40, 2);
  const StaticDiagram d(disks);
  const auto arcs = d.arcs({{1, 1}, {9, 8}});
  std::vector<Circle> larger;
  for (const Circle& c : disks) {
    larger.push_back(
        {{std::ldexp(c.center[0], 90), std::ldexp(c.center[1], 90)}, std::ldexp(c.radius, 90)});
  }
  const double unit = std::ldexp(1.0, 90);
  const auto others = StaticDiagram(larger).arcs({{unit, unit}, {9 * unit, 8 * unit}});
  ASSERT_EQ(others.size(), arcs.size());
  for (std::size_t k = 0; k < arcs.size(); ++k) {
    ASSERT_EQ(others[k].size(), arcs[k].size());
    for (std::size_t j = 0; j < arcs[k].size(); ++j) {
      EXPECT_EQ(others[k][j].weight, arcs[k][j].weight);
      EXPECT_EQ(others[k][j].error, unit * arcs[k][j].error);
      for (const int axis : {0, 1}) {
        EXPECT_EQ(others[k][j].control[axis], unit * arcs[k][j].control[axis]);
        EXPECT_EQ(others[k][j].end[axis], unit * arcs[k][j].end[axis]);
      }
    }
  }
}

TEST(StaticArcs, BadBoxesAreRefused) {
  EXPECT_THROW(StaticDiagram({{{0, 0}, 1}}).arcs({{0, 0}, {0, 1}}), std::invalid_argument);
  EXPECT_TRUE(StaticDiagram({{{0, 0}, 1}}).arcs({{0, 0}, {1, 1}}).empty());
}

}  // namespace
}  // namespace voroproof
