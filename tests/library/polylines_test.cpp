// Edges and cells as chains of points, against the definition of a cell.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

#include "tests/library/scenes.h"
#include "voroproof/voroproof.h"

namespace {

using namespace voroproof;
using namespace voroproof::internal::testing;

// The distance of a point from a generator's boundary.
double distance(const Diagram& d, int g, const Vector& x) {
  if (g == container) {
    return d.container_radius -
           std::hypot(x[0] - d.container_center[0], x[1] - d.container_center[1]);
  }
  const PlacedDisk& disk = d.disks[g];
  return std::hypot(x[0] - disk.center[0], x[1] - disk.center[1]) - disk.radius;
}

double least_distance(const Diagram& d, const Vector& x) {
  double least = std::numeric_limits<double>::infinity();
  for (int g = container; g < static_cast<int>(d.disks.size()); ++g) {
    least = std::min(least, distance(d, g, x));
  }
  return least;
}

double signed_area(const std::vector<Vector>& polygon) {
  double twice = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return twice / 2;
}

Vector middle(const Vector& a, const Vector& b) { return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2}; }

TEST(LibraryPolylines, RunAlongTheirEdges) {
  const Diagram d = diagram_at(reference(40, 20), 11.5);
  for (const double tolerance : {1.0, 0.01, 1e-5}) {
    const auto lines = edge_polylines(d, tolerance);
    ASSERT_EQ(lines.size(), d.edges.size());
    std::size_t points = 0;
    for (std::size_t k = 0; k < lines.size(); ++k) {
      points += lines[k].size();
      ASSERT_GE(lines[k].size(), 2u);
      for (std::size_t p = 0; p + 1 < lines[k].size(); ++p) {
        // Of a chord, too, the middle is as near to both generators as the tolerance says.
        const Vector x = middle(lines[k][p], lines[k][p + 1]);
        EXPECT_NEAR(distance(d, d.edges[k].l, x), distance(d, d.edges[k].r, x), 2.1 * tolerance);
        EXPECT_NEAR(distance(d, d.edges[k].l, x), least_distance(d, x), 2.1 * tolerance);
      }
    }
    if (tolerance == 1e-5) {
      EXPECT_GT(points, 4 * lines.size());
    }
  }
}

TEST(LibraryPolylines, CellsFillTheContainer) {
  for (const int n : {1, 2, 3, 30}) {
    SCOPED_TRACE(n);
    const Diagram d = diagram_at(reference(n, 10), 3);
    const double tolerance = 1e-6 * d.container_radius;
    const auto cells = cell_polygons(d, tolerance);
    ASSERT_EQ(cells.size(), static_cast<std::size_t>(n) + 1);
    double sum = 0;
    for (int g = 0; g < n; ++g) {
      const double area = signed_area(cells[g]);
      EXPECT_GT(area, 3.1 * d.disks[g].radius * d.disks[g].radius);
      sum += area;
      for (const Vector& x : cells[g]) {
        EXPECT_NEAR(distance(d, g, x), least_distance(d, x), 2.1 * tolerance);
      }
    }
    // The container's cell has the others on its right.
    EXPECT_NEAR(signed_area(cells[n]), -sum, 1e-9 * sum);
    EXPECT_LT(sum, 3.15 * d.container_radius * d.container_radius);
  }
  const auto none = cell_polygons(diagram_at(Scene(), 0), 0.1);
  ASSERT_EQ(none.size(), 1u);
  EXPECT_TRUE(none[0].empty());
}

TEST(LibraryPolylines, RefuseWhatHasNoMeaning) {
  Diagram d = diagram_at(reference(5, 10), 0);
  for (const double tolerance : {0.0, -1.0, 1e-12, std::nan("")}) {
    EXPECT_THROW(edge_polylines(d, tolerance), std::invalid_argument);
    EXPECT_THROW(cell_polygons(d, tolerance), std::invalid_argument);
  }
  Diagram other = d;
  other.edges[0].l = 77;
  EXPECT_THROW(edge_polylines(other, 0.1), std::invalid_argument);
  other = d;
  other.vertices.pop_back();
  EXPECT_THROW(cell_polygons(other, 0.1), std::invalid_argument);
  other = d;
  other.edges.pop_back();
  EXPECT_THROW(cell_polygons(other, 0.1), std::invalid_argument);
}

}  // namespace
