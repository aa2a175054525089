// Diagrams of disks at rest between walls: by the definition of cells and edges, against
// polygons, against themselves, and before the certifier.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>

#include "tests/library/disk_sets.h"
#include "voroproof/certify_diagram.h"
#include "voroproof/static_diagram.h"

namespace voroproof {
namespace {

const Box walls{{-0.5, 0}, {10.25, 9}};

double distance(const StaticDiagram& d, int g, const Vector& p) {
  const int n = static_cast<int>(d.disks().size());
  if (g < n) {
    const auto& [c, r] = d.disks()[static_cast<std::size_t>(g)];
    return std::hypot(p[0] - c[0], p[1] - c[1]) - r;
  }
  const auto& [low, high] = *d.walls();
  const double all[4] = {p[0] - low[0], p[1] - low[1], high[0] - p[0], high[1] - p[1]};
  return all[g - n];
}

double least_distance(const StaticDiagram& d, const Vector& p) {
  double least = distance(d, static_cast<int>(d.disks().size()), p);
  for (int g = 0; g < static_cast<int>(d.disks().size()) + 4; ++g) {
    least = std::min(least, distance(d, g, p));
  }
  return least;
}

// Sets of which some disks cross walls, touch them, lie in each other or behind a wall.
StaticDiagram some_diagram(unsigned seed) {
  std::vector<Circle> disks =
      random_disks(seed, static_cast<int>(seed % 7) * 6, seed % 2 == 1 ? 0.4 : 3);
  if (seed % 3 == 0) {
    for (Circle& d : disks) d = {{std::round(d.center[0]), std::round(d.center[1])}, 1};
  }
  return StaticDiagram::between_walls(disks, walls);
}

Vector point(const Arc& arc, double t) {
  const double a = (1 - t) * (1 - t), b = 2 * t * (1 - t) * arc.weight, c = t * t, sum = a + b + c;
  const auto mean = [&](int axis) {
    return (a * arc.start[axis] + b * arc.control[axis] + c * arc.end[axis]) / sum;
  };
  return {mean(0), mean(1)};
}

TEST(StaticWalls, ArcsAreOnTheEdges) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    const StaticDiagram d = some_diagram(seed);
    for (const Box& box : {walls, Box{{3, 3}, {5, 8}}, Box{{-3, -4}, {15, 12}}}) {
      const auto edges = d.arcs(box);
      ASSERT_EQ(edges.size(), d.edges().size());
      for (std::size_t k = 0; k < edges.size(); ++k) {
        const Edge& e = d.edges()[k];
        if (e.l == -1 || e.r == -1) {
          EXPECT_TRUE(edges[k].empty());
        }
        for (const Arc& arc : edges[k]) {
          EXPECT_LE(arc.error, 1e-8);
          for (int step = 0; step <= 8; ++step) {
            const Vector p = point(arc, step / 8.0);
            const double off = 2 * arc.error + 1e-13;
            EXPECT_NEAR(distance(d, e.l, p), distance(d, e.r, p), off) << e.l << " " << e.r;
            EXPECT_NEAR(distance(d, e.l, p), least_distance(d, p), off) << e.l << " " << e.r;
          }
        }
      }
    }
    if (HasFailure()) return;
  }
}

TEST(StaticWalls, VerticesTouchTheirGenerators) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const StaticDiagram d = some_diagram(seed);
    EXPECT_FALSE(d.vertices().empty());
    for (const Vertex& v : d.vertices()) {
      for (const int g : v.generators) EXPECT_NEAR(distance(d, g, v.center), v.radius, 1e-12);
      EXPECT_NEAR(least_distance(d, v.center), v.radius, 1e-12);
    }
  }
  // The medial axis of a rectangle.
  const StaticDiagram none = StaticDiagram::between_walls({}, {{0, 0}, {8, 2}});
  ASSERT_EQ(none.vertices().size(), 2u);
  EXPECT_EQ(none.vertices()[0].center, (Vector{1, 1}));
  EXPECT_EQ(none.vertices()[1].center, (Vector{7, 1}));
  EXPECT_EQ(none.vertices()[0].radius, 1);
}

// The cells and the trapezes of the walls fill the rectangle.
TEST(StaticWalls, CellsAreMeasured) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    const StaticDiagram d = some_diagram(seed);
    for (const Box& box : {walls, Box{{3.1, 3.2}, {4.7, 8.1}}}) {
      const auto cells = d.cells(box, 1e-6);
      const auto measures = d.measures(box);
      ASSERT_EQ(cells.size(), d.disks().size());
      for (std::size_t k = 0; k < cells.size(); ++k) {
        double sum = 0;
        for (const auto& polygon : cells[k]) sum += area(polygon);
        EXPECT_NEAR(sum, measures[k].area, 1e-4);
        EXPECT_LE(measures[k].area_error, 1e-9);
      }
    }
    if (HasFailure()) return;
  }
  // A point in the middle of a square: its cell is within four parabolas.
  const StaticDiagram one = StaticDiagram::between_walls({{{0, 0}, 0}}, {{-1, -1}, {1, 1}});
  // A quarter is within |y| <= |x| and r <= 1 - x: 2 times the integral over y from 0 to q of (1 -
  // y^2) / 2 - y, with q = sqrt(2) - 1.
  const double q = std::sqrt(2.0) - 1;
  const double expected = 8 * ((q - q * q * q / 3) / 2 - q * q / 2);
  EXPECT_NEAR(one.measures(one.box())[0].area, expected, 1e-12);
}

TEST(StaticWalls, NearestIsOfLeastDistanceAndLargestId) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const StaticDiagram d = some_diagram(seed);
    std::vector<Vector> points;
    for (int x = -4; x < 48; ++x) {
      for (int y = -4; y < 44; ++y) points.push_back({x / 4.0, y / 4.0});
    }
    const auto found = d.nearest(points);
    const int n = static_cast<int>(d.disks().size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      EXPECT_NEAR(found[k].distance, least_distance(d, points[k]), 1e-12);
      int last = -1;
      for (int g = 0; g < n + 4; ++g) {
        const bool hides =
            g < n && d.hosts()[static_cast<std::size_t>(g)] != StaticDiagram::visible;
        if (!hides && distance(d, g, points[k]) <= found[k].distance + 1e-12) last = g;
      }
      EXPECT_EQ(found[k].generator, last) << points[k][0] << " " << points[k][1];
    }
    if (HasFailure()) return;
  }
}

TEST(StaticWalls, TheCertifierAgrees) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    const StaticDiagram d = some_diagram(seed);
    DiagramClaim claim;
    claim.disks = d.disks();
    claim.walls = d.walls();
    claim.hosts = d.hosts();
    claim.edges = d.edges();
    claim.vertices = d.vertices();
    std::set<std::array<int, 2>> pairs;
    const int n = static_cast<int>(d.disks().size());
    for (const Edge& e : d.edges()) {
      if (e.l >= 0 && e.l < n && e.r < n) pairs.insert({std::min(e.l, e.r), std::max(e.l, e.r)});
    }
    claim.neighbours.emplace(pairs.begin(), pairs.end());
    DiagramReport report = certify_diagram(claim);
    EXPECT_EQ(report.verdict, Verdict::certified) << report.reason;
    claim.edges.reset();
    report = certify_diagram(claim);
    EXPECT_EQ(report.verdict, Verdict::certified) << report.reason;
    // Walls are not forgotten where one of their pairs is told.
    if (n > 0) {
      claim.neighbours->push_back({n, n + 1});
      claim.neighbours->push_back({n, n + 2});
      EXPECT_EQ(certify_diagram(claim).verdict, Verdict::refuted);
    }
    claim = {d.disks(), {}, {}, d.edges(), {}, {}, Box{{-0.5, 0}, {10.25, 30}}};
    EXPECT_EQ(certify_diagram(claim).verdict, Verdict::refuted);
  }
}

TEST(StaticWalls, OthersAreRefused) {
  EXPECT_THROW(StaticDiagram::between_walls({}, {{0, 0}, {0, 1}}), std::invalid_argument);
  EXPECT_THROW(StaticDiagram::between_walls({{{0, 0}, -1}}, walls), std::invalid_argument);
  const StaticDiagram d = StaticDiagram::between_walls({{{1, 1}, 1}}, walls);
  EXPECT_THROW(d.voids(walls, 0), std::invalid_argument);
  EXPECT_THROW(d.largest_empty_circle(walls), std::invalid_argument);
  // Behind the bottom, and beyond a corner only.
  EXPECT_EQ(StaticDiagram::between_walls({{{1, -1}, 1}, {{-1.5, -1}, 1.2}}, walls).hosts(),
            (std::vector<int>{3, StaticDiagram::visible}));
}

}  // namespace
}  // namespace voroproof
