// The curves of edges against the definition of a Voronoi edge, on diagrams found by brute force.
#include "library/edge_curves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "history/diagram_file.h"
#include "tests/apps/draw/brute_diagrams.h"

namespace voroproof::internal::testing {
namespace {

Vec2 at(const Cubic& c, double t) {
  Vec2 x{};
  const double u = 1 - t;
  for (int i = 0; i < 2; ++i) {
    x[i] = u * u * u * c[0][i] + 3 * u * u * t * c[1][i] + 3 * u * t * t * c[2][i] +
           t * t * t * c[3][i];
  }
  return x;
}

// Every point of every curve is as near to both generators of the edge as to any
// other; the curve joins the two vertices and runs the way of its name.
void expect_true_curves(const DiagramFile& d, double tolerance) {
  const EdgeCurves curves(d, tolerance);
  for (const Quad& q : d.edges) {
    SCOPED_TRACE("edge " + std::to_string(q.l) + " " + std::to_string(q.r) + " " +
                 std::to_string(q.s) + " " + std::to_string(q.e));
    const auto chain = curves.of(q);
    ASSERT_FALSE(chain.empty());
    double turned = 0;
    const GenId base = q.l == container_id ? q.r : q.l;
    Vec2 previous = chain.front()[0];
    EXPECT_NEAR(gap(d, q.s, previous), gap(d, q.l, previous), 1e-6);
    EXPECT_NEAR(gap(d, q.e, chain.back()[3]), gap(d, q.l, chain.back()[3]), 1e-6);
    for (const Cubic& cubic : chain) {
      EXPECT_NEAR(norm(minus(cubic[0], previous)), 0, 1e-9);
      for (int step = 1; step <= 8; ++step) {
        const Vec2 x = at(cubic, step / 8.0);
        // The difference of two distances changes at most twice as fast as x.
        EXPECT_NEAR(gap(d, q.l, x), gap(d, q.r, x), 4 * tolerance);
        EXPECT_GE(nearest_gap(d, x), gap(d, q.l, x) - 4 * tolerance);
        const Vec2 a = minus(previous, center(d, base)), b = minus(x, center(d, base));
        turned += std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
        previous = x;
      }
    }
    EXPECT_GT(base == q.l ? turned : -turned, 0);
  }
}

TEST(EdgeCurves, AreVoronoiEdgesOfRandomDisks) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const DiagramFile d = random_diagram(4 + static_cast<int>(seed), seed);
    const std::size_t n = d.disks.size();
    ASSERT_EQ(d.vertices.size(), 2 * (n + 1) - 4);
    ASSERT_EQ(d.edges.size(), 3 * (n + 1) - 6);
    expect_true_curves(d, 1e-3);
  }
}

TEST(EdgeCurves, AreVoronoiEdgesOfPairsWithSeveralEdges) {
  const DiagramFile d = crack();
  ASSERT_EQ(d.vertices.size(), 8u);
  ASSERT_EQ(d.edges.size(), 12u);
  std::map<std::pair<GenId, GenId>, int> pairs;
  for (const Quad& q : d.edges) ++pairs[{q.l, q.r}];
  EXPECT_TRUE(std::any_of(pairs.begin(), pairs.end(), [](const auto& p) { return p.second > 1; }));
  expect_true_curves(d, 1e-4);
}

TEST(EdgeCurves, AreSegmentsBetweenEqualDisks) {
  const DiagramFile d = square_lattice(3);
  ASSERT_EQ(d.edges.size(), 24u);
  expect_true_curves(d, 1e-4);
  const EdgeCurves curves(d, 1e-4);
  for (const Quad& q : d.edges) {
    if (q.l == container_id) continue;
    const auto chain = curves.of(q);
    const Vec2 start = chain.front()[0], along = minus(chain.back()[3], start);
    for (const Cubic& cubic : chain) {
      for (const Vec2& x : cubic) {
        const Vec2 to = minus(x, start);
        EXPECT_NEAR((along[0] * to[1] - along[1] * to[0]) / norm(along), 0, 1e-9);
      }
    }
  }
}

// As no diagram has them, but a file may.
TEST(EdgeCurves, OfVerticesThatAreOnNoBisectorHaveSomeEnd) {
  DiagramFile d = random_diagram(9, 5);
  d.disks[0].radius *= 40;
  const EdgeCurves curves(d, 1e-6);
  std::size_t most = 0;
  for (const Quad& q : d.edges) most = std::max(most, curves.of(q).size());
  EXPECT_GT(most, 4000u);
  EXPECT_LT(most, 4200u);
}

TEST(EdgeCurves, KeepTheToleranceTheyAreGiven) {
  const DiagramFile d = random_diagram(9, 5);
  for (double tolerance : {1.0, 1e-2, 1e-5}) expect_true_curves(d, tolerance);
}

TEST(EdgeCurves, SurviveVerticesThatCoincide) {
  // Edges of length zero whose ends rounding has put in the wrong order.
  const DiagramFile good = crack();
  for (const Quad& edge : good.edges) {
    for (const Vec2& shift : {Vec2{1e-14, 0}, Vec2{-1e-14, 0}, Vec2{0, 1e-14}, Vec2{0, -1e-14}}) {
      DiagramFile d = good;
      const auto vertex = [&](const Triple& generators) {
        return std::find_if(d.vertices.begin(), d.vertices.end(),
                            [&](const auto& v) { return v.generators == generators; });
      };
      const Vec2 place = vertex(start_vertex(edge))->center;
      vertex(end_vertex(edge))->center = {place[0] + shift[0], place[1] + shift[1]};
      for (const Quad& way : {edge, reversed(edge)}) {
        for (const Cubic& cubic : EdgeCurves(d, 1e-3).of(way)) {
          for (const Vec2& x : cubic) EXPECT_LT(norm(minus(x, place)), 1e-9);
        }
      }
    }
  }
}

TEST(EdgeCurves, TheOnlyCellIsAnEllipse) {
  const DiagramFile d = lone_disk();
  const auto chain = EdgeCurves(d, 1e-5).only_cell();
  EXPECT_LE(chain.size(), 16u);  // a cubic approximates to the sixth order
  double area = 0;
  for (const Cubic& cubic : chain) {
    for (int step = 0; step < 64; ++step) {
      const Vec2 a = at(cubic, step / 64.0), b = at(cubic, (step + 1) / 64.0);
      EXPECT_NEAR(gap(d, 0, a), gap(d, container_id, a), 1e-4);
      area += (a[0] * b[1] - a[1] * b[0]) / 2;
    }
  }
  // Foci 5 apart, sum of distances R + r = 12.
  EXPECT_NEAR(area, pi * 6 * std::sqrt(36 - 6.25), 0.1);
}

TEST(EdgeCurves, RefuseAnEdgeWithoutVertices) {
  const DiagramFile d = crack();
  EXPECT_THROW(EdgeCurves(d, 1e-3).of({0, 1, 4, 4}), std::invalid_argument);
}

}  // namespace
}  // namespace voroproof::internal::testing
