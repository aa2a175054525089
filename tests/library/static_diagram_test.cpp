// The diagram of any disks as a value: cells against the definition, and bad values.
#include "voroproof/static_diagram.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/library/disk_sets.h"

namespace voroproof {
namespace {

bool contains(const std::vector<Vector>& polygon, const Vector& p) {
  bool inside = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    if ((a[1] > p[1]) == (b[1] > p[1])) continue;
    if (p[0] < a[0] + (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1])) inside = !inside;
  }
  return inside;
}

TEST(StaticDiagram, CellsFillTheBoxAtAnyTolerance) {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    const StaticDiagram d(random_disks(seed, 2 + static_cast<int>(seed) * 3, seed % 2 ? 0.5 : 3));
    const Box box = d.box();
    const double whole = (box.high[0] - box.low[0]) * (box.high[1] - box.low[1]);
    for (const double tolerance : {1e-3, 0.1}) {
      double sum = 0;
      for (const auto& cell : d.cells(box, tolerance)) {
        for (const auto& piece : cell) {
          EXPECT_GT(area(piece), 0);
          sum += area(piece);
        }
      }
      EXPECT_NEAR(sum, whole, 1e-9 * whole) << seed;
    }
  }
}

// The nearest disk by the definition.
TEST(StaticDiagram, CellsAreWhereTheirDiskIsNearest) {
  for (const bool framed : {false, true}) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const std::vector<Circle> disks = random_disks(seed, 25, 2);
      std::optional<Circle> frame;
      if (framed) frame = Circle{{5, 5}, 4.5};
      const StaticDiagram d(disks, frame);
      const auto cells = d.cells(d.box(), 1e-4);
      for (const Circle& place : random_disks(seed + 100, 200, 1)) {
        const Vector& p = place.center;
        double least = std::numeric_limits<double>::infinity(), second = least;
        int nearest = -1;
        const auto look = [&](double far, int k) {
          if (far < least) {
            second = least;
            least = far;
            nearest = k;
          } else {
            second = std::min(second, far);
          }
        };
        for (std::size_t k = 0; k < disks.size(); ++k) {
          const Vector& c = disks[k].center;
          look(std::hypot(p[0] - c[0], p[1] - c[1]) - disks[k].radius, static_cast<int>(k));
        }
        if (frame) look(frame->radius - std::hypot(p[0] - 5, p[1] - 5), -1);
        const Box box = d.box();
        const bool outside =
            p[0] < box.low[0] || p[0] > box.high[0] || p[1] < box.low[1] || p[1] > box.high[1];
        if (outside || nearest < 0 || second - least < 1e-3) continue;
        int found = -1;
        for (std::size_t k = 0; k < cells.size(); ++k) {
          for (const auto& piece : cells[k]) {
            if (contains(piece, p)) found = static_cast<int>(k);
          }
        }
        EXPECT_EQ(found, nearest) << seed << " " << p[0] << " " << p[1];
      }
    }
  }
}

TEST(StaticDiagram, VerticesTouchTheirThree) {
  const std::vector<Circle> disks = random_disks(7, 60, 1);
  const StaticDiagram d(disks);
  for (const Vertex& v : d.vertices()) {
    for (const int g : v.generators) {
      const Circle& disk = disks[g];
      EXPECT_NEAR(std::hypot(v.center[0] - disk.center[0], v.center[1] - disk.center[1]),
                  v.radius + disk.radius, 1e-9 * (1 + std::fabs(v.radius)));
    }
  }
}

TEST(StaticDiagram, NegativeWeightsCountByTheirDifferences) {
  std::vector<Circle> disks = random_disks(8, 40, 1), lighter = disks;
  for (Circle& d : lighter) d.radius -= 0.75;
  const auto names = [](const StaticDiagram& d) {
    std::vector<std::array<int, 4>> all;
    for (const Edge& e : d.edges()) all.push_back({e.l, e.r, e.s, e.e});
    return all;
  };
  // Where the differences are those of the doubles.
  for (std::size_t k = 0; k < disks.size(); ++k) {
    disks[k].radius = std::ldexp(std::round(std::ldexp(disks[k].radius, 20)), -20);
    lighter[k].radius = disks[k].radius - 0.75;
  }
  EXPECT_EQ(names(StaticDiagram(disks)), names(StaticDiagram(lighter)));
}

TEST(StaticDiagram, OneDiskHasTheBoxOrAnEllipse) {
  const StaticDiagram plane({{{1, 2}, 3}});
  const auto cells = plane.cells({{0, 0}, {2, 1}}, 1e-3);
  ASSERT_EQ(cells[0].size(), 1U);
  EXPECT_DOUBLE_EQ(area(cells[0][0]), 2);
  // Of a point in the middle of a circle: half of the radius.
  const StaticDiagram framed({{{0, 0}, 0}}, Circle{{0, 0}, 2});
  const auto round = framed.cells(framed.box(), 1e-4);
  EXPECT_NEAR(area(round[0][0]), 3.14159265, 1e-3);
  EXPECT_TRUE(StaticDiagram({}).cells({{0, 0}, {1, 1}}, 0.1).empty());
}

// The lines that touch all of them are circles of three: their vertices are at infinity.
TEST(StaticDiagram, CellsOfEqualDisksOnALineAreStrips) {
  std::vector<Circle> disks;
  for (int k = 0; k < 5; ++k) disks.push_back({{static_cast<double>(k), 0}, 0.25});
  const StaticDiagram d(disks);
  EXPECT_TRUE(d.vertices().empty());
  const auto cells = d.cells({{-0.5, -1}, {4.5, 1}}, 1e-3);
  for (const auto& cell : cells) {
    ASSERT_EQ(cell.size(), 1U);
    EXPECT_NEAR(area(cell[0]), 2, 1e-9);
  }
}

TEST(StaticDiagram, CellsDoNotDependOnTheUnit) {
  for (const double unit : {1e-90, 1e90}) {
    std::vector<Circle> disks = random_disks(9, 50, 1);
    for (Circle& d : disks) {
      d = {{unit * d.center[0], unit * d.center[1]}, unit * d.radius};
    }
    const StaticDiagram d(disks);
    const Box box = d.box();
    double part = 0;
    for (const auto& cell : d.cells(box, unit / 100)) {
      for (auto piece : cell) {
        for (Vector& p : piece) p = {p[0] / unit, p[1] / unit};
        part += area(piece);
      }
    }
    const double whole =
        (box.high[0] / unit - box.low[0] / unit) * (box.high[1] / unit - box.low[1] / unit);
    EXPECT_NEAR(part, whole, 1e-9 * whole);
  }
}

TEST(StaticDiagram, BadValuesAreRefused) {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(StaticDiagram({{{nan, 0}, 1}}), std::invalid_argument);
  EXPECT_THROW(StaticDiagram({{{0, infinity}, 1}}), std::invalid_argument);
  EXPECT_THROW(StaticDiagram({{{0, 0}, 1e101}}), std::invalid_argument);
  EXPECT_THROW(StaticDiagram({{{0, 0}, -1}}, Circle{{0, 0}, 1}), std::invalid_argument);
  EXPECT_THROW(StaticDiagram({{{0, 0}, 1}}, Circle{{0, 0}, 0}), std::invalid_argument);
  const StaticDiagram d({{{0, 0}, 1}, {{3, 0}, 1}});
  EXPECT_THROW(d.cells({{0, 0}, {0, 1}}, 0.1), std::invalid_argument);
  EXPECT_THROW(d.cells({{0, 0}, {1, 1}}, 1e-10), std::invalid_argument);
  EXPECT_THROW(d.cells({{0, 0}, {1, 1}}, nan), std::invalid_argument);
  EXPECT_THROW(d.geojson(d.box(), 0.1, {{"name", {"a"}}}), std::invalid_argument);
}

}  // namespace
}  // namespace voroproof
