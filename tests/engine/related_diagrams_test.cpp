// The relatives of the diagram of disks (the paper's Table 1): moving points against a kinetic
// Delaunay triangulation, and the degrees of the polynomials whose roots are events.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "exact/polynomial.h"
#include "exact/predicates.h"
#include "tests/oracle/kinetic_delaunay.h"
#include "tests/support/dice.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal {
namespace {

using testing::Dice;
using Poly = Polynomial<Rational>;

Poly constant(const Rational& q) { return Poly(std::vector<Rational>{q}); }
Poly linear(Dice& dice) {
  return Poly(std::vector<Rational>{Rational(dice(-99, 99)), Rational(dice(-9, 9) * 2 + 1)});
}

// A moving disk; a point where the radius is 0, the container where it is negative.
Site<Poly> moving(Dice& dice, int radius) {
  if (radius < 0) return {constant(0), constant(0), constant(radius)};
  return {linear(dice), linear(dice), constant(radius)};
}

Poly determinant(const std::vector<std::vector<Poly>>& rows) {
  if (rows.size() == 1) return rows[0][0];
  Poly sum = constant(0);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::vector<std::vector<Poly>> minor;
    for (std::size_t k = 0; k < rows.size(); ++k)
      if (k != i) minor.emplace_back(rows[k].begin() + 1, rows[k].end());
    const Poly term = rows[i][0] * determinant(minor);
    sum = i % 2 == 0 ? sum + term : sum - term;
  }
  return sum;
}

// The condition that d + 2 spheres in d dimensions touch one sphere, by Cramer's rule: with
// differences to the last, x.X + r rho = p / 2 for each of the others, and X.X = rho^2.
Poly cotangency_of_spheres(Dice& dice, int dimension) {
  std::vector<std::vector<Poly>> rows;  // x_1 ... x_d, r, p
  for (int i = 0; i <= dimension; ++i) {
    std::vector<Poly> row;
    Poly p = constant(0);
    for (int c = 0; c < dimension; ++c) {
      row.push_back(linear(dice));
      p = p + row.back() * row.back();
    }
    const Poly r = constant(dice(1, 9));
    row.push_back(r);
    row.push_back(p - r * r);
    rows.push_back(row);
  }
  Poly sum = constant(0);
  for (int unknown = 0; unknown <= dimension; ++unknown) {
    std::vector<std::vector<Poly>> matrix = rows;
    for (std::vector<Poly>& row : matrix) {
      row[unknown] = row.back();
      row.pop_back();
    }
    const Poly d = determinant(matrix);
    sum = unknown < dimension ? sum + d * d : sum - d * d;
  }
  return sum;
}

TEST(Table1, DisksHaveDegreeEight) {
  Dice dice(1);
  for (int round = 0; round < 20; ++round) {
    const int last = round % 2 == 0 ? 4 : -500;
    EXPECT_EQ(
        cotangency(moving(dice, 1), moving(dice, 2), moving(dice, 3), moving(dice, last)).degree(),
        8);
    EXPECT_EQ(cotangency_of_spheres(dice, 2).degree(), 8);
  }
}

TEST(Table1, SpheresHaveDegreeTen) {
  Dice dice(2);
  for (int round = 0; round < 20; ++round) EXPECT_EQ(cotangency_of_spheres(dice, 3).degree(), 10);
}

TEST(Table1, PointsHaveDegreeFour) {
  Dice dice(3);
  for (int round = 0; round < 20; ++round) {
    const int radius = round % 2;  // equal radii are no different
    const auto a = moving(dice, radius), b = moving(dice, radius), c = moving(dice, radius),
               d = moving(dice, radius);
    const Poly in_circle = cocircularity(a, b, c, d);
    EXPECT_EQ(in_circle.degree(), 4);
    // The polynomial of disks has no sign changes to find: 4 f = -4 C^2.
    EXPECT_TRUE((cotangency(a, b, c, d) + constant(4) * in_circle * in_circle).is_zero());
  }
}

// Power distance: |x - c|^2 - r^2 is linear in x but for |x|^2.
TEST(Table1, PowerDiagramsHaveDegreeFour) {
  Dice dice(4);
  for (int round = 0; round < 20; ++round) {
    std::vector<std::vector<Poly>> rows;
    for (int i = 0; i < 3; ++i) {
      const Poly x = linear(dice), y = linear(dice);
      rows.push_back({x, y, x * x + y * y - constant(dice(1, 50))});
    }
    EXPECT_EQ(determinant(rows).degree(), 4);
  }
}

TEST(MovingPoints, FlipAsTheDelaunayTriangulationDoes) {
  std::size_t flips = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    Dice dice(seed);
    constexpr int radius = 1000, horizon = 60, n = 11;
    std::vector<oracle::MovingPoint> points;
    std::vector<DiskInput> disks;
    for (int i = 0; i < n; ++i) {
      const Rational x = dice(-300, 300), y = dice(-300, 300);
      const Rational vx = Rational(dice(-50, 50)) / 10, vy = Rational(dice(-50, 50)) / 10;
      points.push_back({x, y, vx, vy});
      disks.push_back(testing::disk(x, y, 0, vx, vy, 1));
    }
    const Scene scene = testing::scene_of(radius, horizon, disks);
    ASSERT_TRUE(testing::is_acceptable(scene));
    const testing::RecordedRun run = testing::run(scene);
    ASSERT_TRUE(run.complete());
    ASSERT_EQ(run.count(testing::Event::Kind::collision), 0u);
    // The flips of four points, without those at the container.
    std::vector<testing::Event> of_points;
    for (const testing::Event& e : run.events)
      if (std::min({e.edge.l, e.edge.r, e.edge.s, e.edge.e}) >= 0) of_points.push_back(e);
    const auto expected = oracle::delaunay_flips(points, radius, horizon);
    ASSERT_EQ(of_points.size(), expected.size()) << seed;
    for (std::size_t k = 0; k < expected.size(); ++k) {
      const Quad& q = of_points[k].edge;
      std::array<int, 4> four{q.l, q.r, q.s, q.e};
      std::sort(four.begin(), four.end());
      EXPECT_EQ(four, expected[k].points);
      EXPECT_EQ(of_points[k].t, round_nearest(expected[k].lo));
    }
    flips += expected.size();
  }
  EXPECT_GT(flips, 50u);
}

TEST(MovingPoints, HaveInCirclePolynomialsOfDegreeFour) {
  Dice dice(6);
  const auto point = [&]() -> oracle::MovingPoint {
    return {dice(-99, 99), dice(-99, 99), dice(-999, 999), dice(-999, 999)};
  };
  for (int round = 0; round < 20; ++round) {
    EXPECT_EQ(oracle::incircle_polynomial({point(), point(), point(), point()}).size(), 5u);
    // Four velocities on one circle: the degree falls.
    auto p = point(), q = point(), r = point(), s = point();
    p.vx = 5, p.vy = 0, q.vx = 3, q.vy = 4, r.vx = -4, r.vy = 3, s.vx = 0, s.vy = -5;
    EXPECT_LT(oracle::incircle_polynomial({p, q, r, s}).size(), 5u);
  }
}

}  // namespace
}  // namespace voroproof::internal
