// The curves of edges at rest: where two disks are nearest, and all of it.
#include "apps/draw/static_curves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "library/diagram_geometry.h"

namespace voroproof::internal::testing {
namespace {

constexpr double tolerance = 1e-4;

// The signed distances to the disks, and to the frame, from the least to the greatest.
std::vector<double> distances(const StaticDiagram& diagram, const Vec2& p) {
  std::vector<double> all;
  for (const voroproof::Circle& d : diagram.disks()) all.push_back(length(p - d.center) - d.radius);
  if (const auto& frame = diagram.frame()) {
    all.push_back(frame->radius - length(p - frame->center));
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::vector<Vec2> points_of(const std::vector<std::vector<Cubic>>& curves) {
  std::vector<Vec2> all;
  for (const auto& chain : curves) {
    for (const Cubic& c : chain) {
      const double chord = length(c[3] - c[0]);
      const int steps = 1 + static_cast<int>(chord / (10 * tolerance));
      for (int k = 0; k <= steps; ++k) {
        const double t = static_cast<double>(k) / steps, u = 1 - t;
        all.push_back(u * u * u * c[0] + 3 * u * u * t * c[1] + 3 * u * t * t * c[2] +
                      t * t * t * c[3]);
      }
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

bool has_near(const std::vector<Vec2>& sorted, const Vec2& p, double reach) {
  for (auto q = std::lower_bound(sorted.begin(), sorted.end(), Vec2{p[0] - reach, -1e300});
       q != sorted.end() && (*q)[0] <= p[0] + reach; ++q) {
    if (length(*q - p) <= reach) return true;
  }
  return false;
}

void expect_all_and_only_edges(const StaticDiagram& diagram, const Box& box) {
  const std::vector<Vec2> points = points_of(curves_in_box(diagram, box, tolerance));
  for (const Vec2& p : points) {
    const auto far = distances(diagram, p);
    EXPECT_LE(far[1] - far[0], 4 * tolerance) << p[0] << ", " << p[1];
    for (const int axis : {0, 1}) {
      EXPECT_GE(p[axis], box.low[axis] - tolerance);
      EXPECT_LE(p[axis], box.high[axis] + tolerance);
    }
  }
  const auto is_inside = [&](const Vec2& p) {
    return box.low[0] + tolerance < p[0] && p[0] < box.high[0] - tolerance &&
           box.low[1] + tolerance < p[1] && p[1] < box.high[1] - tolerance;
  };
  for (const auto& cell : diagram.cells(box, tolerance)) {
    for (const auto& polygon : cell) {
      for (const Vec2& p : polygon) {
        EXPECT_TRUE(!is_inside(p) || has_near(points, p, 12 * tolerance)) << p[0] << ", " << p[1];
      }
    }
  }
}

TEST(StaticCurves, AreWhereTwoDisksAreNearestAndMissNothing) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(0, 1), radius(-0.05, 0.2);
  for (int run = 0; run < 6; ++run) {
    std::vector<voroproof::Circle> disks;
    for (int k = 0; k < 3 + 6 * run; ++k) {
      disks.push_back({{place(random), place(random)}, radius(random)});
    }
    const StaticDiagram diagram(disks);
    expect_all_and_only_edges(diagram, diagram.box());
    expect_all_and_only_edges(diagram, {{0.3, 0.4}, {0.5, 0.5}});
    for (voroproof::Circle& disk : disks) disk.radius = std::fabs(disk.radius);
    expect_all_and_only_edges(StaticDiagram(disks, voroproof::Circle{{0.5, 0.5}, 1}),
                              {{-0.5, -0.5}, {1.5, 1.2}});
  }
}

// Edges without end, and those between two places at infinity, of which some lie in no finite
// place.
TEST(StaticCurves, OfFewDisksAndOfTies) {
  const Box box{{-2, -2}, {4, 2}};
  const auto has_edges = [&](const std::vector<voroproof::Circle>& disks) {
    const StaticDiagram diagram(disks);
    expect_all_and_only_edges(diagram, box);
    return !curves_in_box(diagram, box, tolerance).empty();
  };
  EXPECT_FALSE(has_edges({}));
  EXPECT_FALSE(has_edges({{{0, 0}, 1}}));
  EXPECT_TRUE(has_edges({{{0, 0}, 1}, {{2, 0}, 0.5}}));
  EXPECT_TRUE(has_edges({{{0, 0}, 1}, {{1, 0}, 1}, {{2, 0}, 1}, {{3, 0}, 1}}));
  EXPECT_TRUE(has_edges({{{0, 0}, 0}, {{1, 0}, 0}, {{0, 1}, 0}, {{1, 1}, 0}}));
  const StaticDiagram lone({{{0.2, 0}, 0.3}}, voroproof::Circle{{0, 0}, 1});
  expect_all_and_only_edges(lone, {{-1, -1}, {1, 1}});
  EXPECT_TRUE(curves_in_box(lone, {{0.1, -0.1}, {0.2, 0.1}}, tolerance).empty());
}

}  // namespace
}  // namespace voroproof::internal::testing
