// Areas, perimeters and centroids of the cells of disks at rest, against polygons with very many
// sides, against what is known of few disks, and against themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/library/disk_sets.h"
#include "voroproof/static_diagram.h"

namespace voroproof {
namespace {

constexpr double pi = 3.14159265358979323846;

double area_of(const Box& box) { return (box.high[0] - box.low[0]) * (box.high[1] - box.low[1]); }
double size_of(const Box& box) {
  return std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]);
}

// A cell's sums over its polygons.
struct Sums {
  double area = 0, perimeter = 0;
  Vector moment{};
};

Sums sums_of(const std::vector<std::vector<Vector>>& pieces, const Vector& origin) {
  Sums sums;
  for (const auto& polygon : pieces) {
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      Vector a = polygon[k], b = polygon[(k + 1) % polygon.size()];
      sums.perimeter += std::hypot(a[0] - b[0], a[1] - b[1]);
      for (const int axis : {0, 1}) {
        a[axis] -= origin[axis];
        b[axis] -= origin[axis];
      }
      const double twice = a[0] * b[1] - a[1] * b[0];
      sums.area += twice / 2;
      for (const int axis : {0, 1}) sums.moment[axis] += twice * (a[axis] + b[axis]) / 6;
    }
  }
  return sums;
}

// All cells of the diagram in the box against polygons.
void expect_as_polygons(const StaticDiagram& d, const Box& box, const std::string& about) {
  const double size = size_of(box), tolerance = 1e-8 * size;
  const auto cells = d.cells(box, tolerance);
  const std::vector<Measure> measures = d.measures(box);
  ASSERT_EQ(measures.size(), d.disks().size());
  for (std::size_t k = 0; k < cells.size(); ++k) {
    SCOPED_TRACE(about + ", disk " + std::to_string(k));
    const Sums sums = sums_of(cells[k], box.low);
    const Measure& m = measures[k];
    // Chords are that near to the arcs; those of the disks' size may be longer than the box.
    const double near = 4 * tolerance * (sums.perimeter + size);
    EXPECT_NEAR(m.area, sums.area, near + m.area_error);
    EXPECT_LE(m.area_error, 1e-10 * size * size);
    if (m.area <= 1e-6 * size * size) continue;
    EXPECT_NEAR(m.perimeter, sums.perimeter, 1e-6 * size + m.perimeter_error);
    EXPECT_LE(m.perimeter_error, 1e-6 * m.perimeter);
    for (const int axis : {0, 1}) {
      EXPECT_NEAR(m.centroid[axis], box.low[axis] + sums.moment[axis] / sums.area,
                  4 * near * size / sums.area + m.centroid_error);
    }
  }
}

TEST(StaticMeasures, RandomCellsAreAsPolygons) {
  for (unsigned seed = 1; seed <= 24; ++seed) {
    const double largest = seed % 3 == 0 ? 0.5 : seed % 3 == 1 ? 3 : 0.01;
    const std::vector<Circle> disks = random_disks(seed, 2 + static_cast<int>(seed) * 2, largest);
    for (const bool framed : {false, true}) {
      std::optional<Circle> frame;
      if (framed) frame = Circle{{5, 5}, 5.5};
      const StaticDiagram d(disks, frame);
      const std::string about = "seed " + std::to_string(seed) + (framed ? ", framed" : "");
      expect_as_polygons(d, d.box(), about);
      expect_as_polygons(d, {{3.1, 3.2}, {4.7, 6.1}}, about + ", small box");
      expect_as_polygons(d, {{-40, 2}, {5, 90}}, about + ", large box");
    }
  }
}

double sum_of_areas(const std::vector<Measure>& measures, double& error) {
  double sum = 0;
  for (const Measure& m : measures) {
    sum += m.area;
    error += m.area_error + 1e-15 * m.area;
  }
  return sum;
}

TEST(StaticMeasures, AreasFillTheBox) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const StaticDiagram d(random_disks(seed, 150, seed % 2 ? 0.4 : 4));
    for (const Box& box : {d.box(), Box{{2, 2}, {2.5, 9}}, Box{{5, 5}, {5 + 1e-6, 5 + 1e-6}}}) {
      double error = 0;
      const double sum = sum_of_areas(d.measures(box), error);
      EXPECT_NEAR(sum, area_of(box), error) << seed;
      EXPECT_LE(error, 1e-9 * size_of(box) * std::max(size_of(box), 1e-4)) << seed;
    }
  }
}

TEST(StaticMeasures, TwoEqualDisksShareTheBox) {
  const StaticDiagram d({{{0, 0}, 1}, {{2, 0}, 1}});
  const auto measures = d.measures({{-1, -2}, {4, 1}});
  EXPECT_NEAR(measures[0].area, 6, measures[0].area_error);
  EXPECT_NEAR(measures[1].area, 9, measures[1].area_error);
  EXPECT_NEAR(measures[0].perimeter, 10, measures[0].perimeter_error);
  EXPECT_NEAR(measures[1].perimeter, 12, measures[1].perimeter_error);
  EXPECT_NEAR(measures[0].centroid[0], 0, measures[0].centroid_error);
  EXPECT_NEAR(measures[0].centroid[1], -0.5, measures[0].centroid_error);
  for (const Measure& m : measures) {
    EXPECT_LE(m.area_error, 1e-11);
    EXPECT_LE(m.perimeter_error, 1e-11);
    EXPECT_LE(m.centroid_error, 1e-11);
  }
}

// The edge of a point and a disk whose bisector is a hyperbola: as an integral.
TEST(StaticMeasures, APointBesideADiskHasAHyperbola) {
  // |x - c| - 2 = |x| for c = (4, 0): the branch ((x - 2)/1)^2 - y^2/3 = 1 on the left.
  const StaticDiagram d({{{0, 0}, 0}, {{4, 0}, 2}});
  const auto measures = d.measures({{-3, -2}, {5, 2}});
  double area = 0;
  const int steps = 100000;
  for (int k = 0; k < steps; ++k) {
    const double y = -2 + 4 * (k + 0.5) / steps;
    area += (2 - std::sqrt(1 + y * y / 3) + 3) * 4 / steps;
  }
  EXPECT_NEAR(measures[0].area, area, 1e-8);
  EXPECT_NEAR(measures[1].area, 32 - measures[0].area, 1e-11);
  EXPECT_LE(measures[0].area_error, 2e-11);
}

TEST(StaticMeasures, OneDiskHasTheBoxOrAnEllipse) {
  const Measure plane = StaticDiagram({{{1, 2}, 3}}).measures({{0, 0}, {2, 1}})[0];
  EXPECT_EQ(plane.area, 2);
  EXPECT_EQ(plane.perimeter, 6);
  EXPECT_NEAR(plane.centroid[0], 1, 1e-15);
  const StaticDiagram framed({{{1, 0}, 0.5}}, Circle{{0, 0}, 2});
  const Measure m = framed.measures(framed.box())[0];
  // The sum of the distances from the centers is 2.5.
  const double a = 1.25, b = std::sqrt(a * a - 0.25);
  EXPECT_NEAR(m.area, pi * a * b, m.area_error);
  EXPECT_LE(m.area_error, 1e-13);
  EXPECT_NEAR(m.centroid[0], 0.5, m.centroid_error);
  // Ramanujan's second formula, that near for this ellipse.
  const double h = (a - b) * (a - b) / ((a + b) * (a + b));
  EXPECT_NEAR(m.perimeter, pi * (a + b) * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h))),
              m.perimeter_error + 1e-12);
  EXPECT_LE(m.perimeter_error, 1e-7 * m.perimeter);
}

// Two parts of the box have the areas and moments of the whole together.
TEST(StaticMeasures, FramedCellsAreTheirParts) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const StaticDiagram d(random_disks(seed, 60, 1), Circle{{5, 5}, 6});
    const Box all = d.box();
    const std::vector<Measure> whole = d.measures(all);
    for (const double x : {5.0, 3.125}) {
      const auto left = d.measures({all.low, {x, all.high[1]}}),
                 right = d.measures({{x, all.low[1]}, all.high});
      for (std::size_t k = 0; k < whole.size(); ++k) {
        const double error = whole[k].area_error + left[k].area_error + right[k].area_error;
        EXPECT_NEAR(left[k].area + right[k].area, whole[k].area, error + 1e-15);
        EXPECT_LE(error, 1e-10);
        if (left[k].area == 0 || right[k].area == 0) continue;
        for (const int axis : {0, 1}) {
          const double moment =
              left[k].area * left[k].centroid[axis] + right[k].area * right[k].centroid[axis];
          EXPECT_NEAR(moment / whole[k].area, whole[k].centroid[axis], 1e-11);
        }
      }
    }
  }
}

void expect_scaled(const std::vector<Circle>& disks, const Box& box, int exponent) {
  const auto scaled = [&](double x) { return std::ldexp(x, exponent); };
  const auto moved = [&](const Vector& v) { return Vector{scaled(v[0]), scaled(v[1])}; };
  std::vector<Circle> larger;
  for (const Circle& d : disks) larger.push_back({moved(d.center), scaled(d.radius)});
  const auto measures = StaticDiagram(disks).measures(box),
             others = StaticDiagram(larger).measures({moved(box.low), moved(box.high)});
  for (std::size_t k = 0; k < disks.size(); ++k) {
    EXPECT_EQ(others[k].area, std::ldexp(measures[k].area, 2 * exponent));
    EXPECT_EQ(others[k].area_error, std::ldexp(measures[k].area_error, 2 * exponent));
    EXPECT_EQ(others[k].perimeter, scaled(measures[k].perimeter));
    EXPECT_EQ(others[k].perimeter_error, scaled(measures[k].perimeter_error));
    if (measures[k].area == 0) continue;
    EXPECT_EQ(others[k].centroid, moved(measures[k].centroid));
    EXPECT_EQ(others[k].centroid_error, scaled(measures[k].centroid_error));
  }
}

TEST(StaticMeasures, PowersOfTwoScaleExactly) {
  for (const int exponent : {-200, -3, 1, 250}) {
    expect_scaled(random_disks(5, 80, 1.5), {{-1, 1}, {8, 12}}, exponent);
  }
  // Near the least and the greatest numbers that there may be.
  const std::vector<Circle> few{{{1, 2}, 0.5}, {{6, 3}, 2}, {{4, 7}, 1}, {{8, 9}, 0.25}};
  for (const int exponent : {-325, 325}) expect_scaled(few, {{-1, 1}, {8, 12}}, exponent);
}

// A move by 2^20 is exact for these disks, but not for vertices.
TEST(StaticMeasures, ErrorsCoverTheRoundingOfVertices) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    std::vector<Circle> disks = random_disks(seed, 60, 1), moved;
    const auto whole = [](double x) { return std::round(std::ldexp(x, 20)); };
    for (Circle& d : disks) {
      const Vector c{whole(d.center[0]), whole(d.center[1])};
      const double r = std::ldexp(whole(d.radius), -20), shift = std::ldexp(1.0, 40);
      d = {{std::ldexp(c[0], -20), std::ldexp(c[1], -20)}, r};
      moved.push_back({{std::ldexp(c[0] + shift, -20), std::ldexp(c[1] - shift, -20)}, r});
    }
    const double shift = std::ldexp(1.0, 20);
    const auto here = StaticDiagram(disks).measures({{-1, -1}, {11, 11}}),
               there = StaticDiagram(moved).measures(
                   {{shift - 1, -shift - 1}, {shift + 11, -shift + 11}});
    for (std::size_t k = 0; k < disks.size(); ++k) {
      const double error = here[k].area_error + there[k].area_error;
      EXPECT_NEAR(there[k].area, here[k].area, error);
      EXPECT_LE(error, 1e-6);
      EXPECT_NEAR(there[k].perimeter, here[k].perimeter,
                  here[k].perimeter_error + there[k].perimeter_error);
      if (here[k].area == 0) continue;
      const double of_centroid = here[k].centroid_error + there[k].centroid_error;
      EXPECT_NEAR(there[k].centroid[0] - shift, here[k].centroid[0], of_centroid);
      EXPECT_NEAR(there[k].centroid[1] + shift, here[k].centroid[1], of_centroid);
    }
  }
}

// Vertices of four and more, parallel edges, disks that touch and coincide, sides of the box along
// edges.
TEST(StaticMeasures, DegenerateSetsAreAsPolygons) {
  std::vector<Circle> grid, ring, line, touching, nested;
  for (int x = 0; x < 5; ++x) {
    line.push_back({{1.0 * x, 0}, 0.25});
    touching.push_back({{2.0 * x, 0.5 * (x % 2)}, 1});
    nested.push_back({{1.0 * x, 0}, 0.99 * x});
    for (int y = 0; y < 5; ++y) grid.push_back({{1.0 * x, 1.0 * y}, 0.25});
  }
  for (const Vector& v : {Vector{3, 4}, {4, 3}, {5, 0}, {-3, 4}, {0, -5}, {-4, -3}}) {
    ring.push_back({v, 1});
  }
  ring.push_back({{0, 0}, 0});
  for (const auto& disks : {grid, ring, line, touching, nested}) {
    std::vector<Circle> twice = disks;
    twice.insert(twice.end(), disks.begin(), disks.end());
    for (const auto& set : {disks, twice}) {
      expect_as_polygons(StaticDiagram(set), {{-1.25, -1.5}, {4.75, 5}}, "plane");
      const StaticDiagram framed(set, Circle{{1, 1}, 16});
      expect_as_polygons(framed, framed.box(), "framed");
    }
  }
}

// On a lattice a box runs through vertices and along edges. Clipping of whole polygons has lost
// some of these cells.
TEST(StaticMeasures, CellsOfALatticeAreAsPolygonsInBoxesOnIt) {
  const std::vector<Circle> first{{{4, -4}, 0},  {{-3, 2}, 2},  {{4, 0}, 1},   {{-2, 1}, 1},
                                  {{2, -2}, 1},  {{0, 2}, 0},   {{3, 4}, 1},   {{2, 2}, 0.5},
                                  {{1, -4}, 1},  {{-2, -1}, 1}, {{-4, -2}, 2}, {{3, 2}, 0.5},
                                  {{3, 4}, 0.5}, {{-2, -4}, 1}, {{4, -1}, 0},  {{3, -1}, 2}};
  const std::vector<Circle> second{{{0, 2}, 2}, {{4, -3}, 1},  {{4, 2}, 2},   {{0, 1}, 0},
                                   {{0, 2}, 1}, {{-4, -1}, 2}, {{-2, -4}, 2}, {{-3, 4}, 2},
                                   {{1, 1}, 0}, {{-2, 3}, 0},  {{2, -1}, 0},  {{-2, 0}, 0},
                                   {{3, 3}, 1}, {{2, 1}, 2},   {{-2, 3}, 2},  {{-1, -4}, 2}};
  for (const auto& disks : {first, second}) {
    for (const Box& box : {Box{{0, -4}, {3, -3}}, Box{{-2, -2}, {1, 1}}}) {
      expect_as_polygons(StaticDiagram(disks), box, "plane");
      expect_as_polygons(StaticDiagram(disks, Circle{{0, 0}, 6}), box, "circle");
      expect_as_polygons(StaticDiagram::between_walls(disks, {{-5, -5}, {6, 5}}), box, "walls");
    }
  }
}

TEST(StaticMeasures, ABoxAlongEdgesHasNoOtherCells) {
  std::vector<Circle> grid;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) grid.push_back({{1.0 * x, 1.0 * y}, 0.25});
  }
  const auto measures = StaticDiagram(grid).measures({{0.5, 0.5}, {1.5, 1.5}});
  for (int k = 0; k < 9; ++k) {
    EXPECT_NEAR(measures[k].area, k == 4 ? 1 : 0, measures[k].area_error);
    EXPECT_LE(measures[k].area_error, 1e-11);
    EXPECT_NEAR(measures[k].perimeter, k == 4 ? 4 : 0, measures[k].perimeter_error);
    EXPECT_EQ(std::isnan(measures[k].centroid[0]), k != 4);
  }
}

// In one cell, where its sides are 1e-200 of the largest coordinate.
TEST(StaticMeasures, ABoxOfAnySizeIsFilled) {
  const StaticDiagram d({{{1e-100, 0}, 1e-100}, {{1e100, 0}, 1}, {{0, 1e100}, 1e90}});
  for (const double size : {1e-100, 1e-20, 1.0}) {
    const auto measures = d.measures({{-size, -size}, {size, size}});
    EXPECT_EQ(measures[0].area, 4 * size * size);
    EXPECT_EQ(measures[0].perimeter, 8 * size);
    EXPECT_EQ(measures[1].area, 0);
  }
}

// Nearly touching each other from inside: rounding leaves little, or nothing, but bounds are right.
TEST(StaticMeasures, SliversHaveTrueBounds) {
  const Box box{{-1, -1}, {3, 1}};
  for (const std::vector<Circle>& disks :
       {std::vector<Circle>{{{0, 0}, 2}, {{1, std::ldexp(1, -60)}, 1}},
        std::vector<Circle>{{{0, 0}, 1}, {{0.3, 0.4}, std::nextafter(0.5, 1)}},
        std::vector<Circle>{{{1e10, 1}, 1e10 - 0.5}, {{0.3, 0.4}, std::nextafter(0.5, 1)}}}) {
    const StaticDiagram d(disks);
    double error = 0;
    const double sum = sum_of_areas(d.measures(box), error);
    EXPECT_NEAR(sum, 8, error);
    EXPECT_EQ(d.arcs(box).size(), d.edges().size());
  }
  // The ellipse about the frame's centre and a point has the half axes 1/2 and, with c = (1 - e) /
  // 2, sqrt(1/4 - c^2).
  const double e = 0x1p-20;
  const StaticDiagram tip({{{1 - e, 0}, 0}}, Circle{{0, 0}, 1});
  const Measure m = tip.measures(tip.box())[0];
  EXPECT_NEAR(m.area, pi / 4 * std::sqrt(1 - (1 - e) * (1 - e)), m.area_error + 1e-16);
  EXPECT_LE(m.area_error, 1e-6 * m.area);
  EXPECT_NEAR(m.centroid[0], (1 - e) / 2, m.centroid_error + 1e-16);
}

TEST(StaticMeasures, HiddenDisksAndMissedCellsHaveNone) {
  const StaticDiagram d({{{0, 0}, 2}, {{0.5, 0}, 1}, {{10, 0}, 1}});
  const auto measures = d.measures({{-2, -2}, {2, 2}});
  EXPECT_EQ(measures[0].area, 16);
  EXPECT_EQ(measures[0].perimeter, 16);
  for (const int k : {1, 2}) {
    EXPECT_EQ(measures[k].area, 0);
    EXPECT_EQ(measures[k].area_error, 0);
    EXPECT_EQ(measures[k].perimeter, 0);
    EXPECT_TRUE(std::isnan(measures[k].centroid[0]));
  }
  EXPECT_TRUE(StaticDiagram({}).measures({{0, 0}, {1, 1}}).empty());
  EXPECT_THROW(d.measures({{0, 0}, {0, 1}}), std::invalid_argument);
  EXPECT_THROW(d.measures({{0, 0}, {1, std::nan("")}}), std::invalid_argument);
  EXPECT_THROW(d.measures({{0, 0}, {1, 1e101}}), std::invalid_argument);
  // At the end of the range bounds hold, however wide.
  const Measure most =
      StaticDiagram({{{0, 0}, 1}, {{4, 0}, 1}}).measures({{0, 0}, {1e100, 1e100}})[1];
  EXPECT_LE(std::fabs(most.area - 1e200), most.area_error);
}

}  // namespace
}  // namespace voroproof
