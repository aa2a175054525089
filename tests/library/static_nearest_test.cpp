// The nearest generator of points against its definition, in numbers of 1024 bits, with all ties.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "voroproof/static_diagram.h"

namespace voroproof {
namespace {

using Disks = std::vector<Circle>;
using Frame = std::optional<Circle>;

constexpr int bits = 1024;
mpf_class number(double x) { return {x, bits}; }

mpf_class distance(const Vector& p, const Circle& c, bool is_frame) {
  const mpf_class dx = number(p[0]) - number(c.center[0]), dy = number(p[1]) - number(c.center[1]);
  const mpf_class far = sqrt(mpf_class(dx * dx + dy * dy, bits));
  return is_frame ? mpf_class(number(c.radius) - far, bits)
                  : mpf_class(far - number(c.radius), bits);
}

// The doubles here are multiples of 2^-80 below 2^10, so that a difference of distances is zero or,
// by the product of its four conjugates, beyond 2^-360.
bool is_zero(const mpf_class& difference) {
  return abs(difference) < mpf_class(std::ldexp(1.0, -400), bits);
}

// Whether no double is nearer to the value than d.
bool is_rounded(double d, const mpf_class& value) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double other : {std::nextafter(d, -infinity), std::nextafter(d, infinity)}) {
    if (abs(mpf_class(number(other) - value, bits)) < abs(mpf_class(number(d) - value, bits))) {
      return false;
    }
  }
  return true;
}

// The number of points that are nearest to several.
int expect_nearest(const Disks& disks, const Frame& frame, const std::vector<Vector>& points) {
  const StaticDiagram diagram(disks, frame);
  const std::vector<Nearest> found = diagram.nearest(points);
  EXPECT_EQ(found.size(), points.size());
  int ties = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    int best = -2;
    bool is_tied = false;
    mpf_class least(0, bits);
    const auto look = [&](int id, const mpf_class& d) {
      const mpf_class more(d - least, bits);
      if (best == -2 || is_zero(more) || more < 0) {
        is_tied = best != -2 && is_zero(more);
        best = id;
        least = d;
      }
    };
    if (frame) look(-1, distance(points[k], *frame, true));
    for (std::size_t g = 0; g < disks.size(); ++g) {
      if (diagram.hosts()[g] != StaticDiagram::visible) continue;
      look(static_cast<int>(g), distance(points[k], disks[g], false));
    }
    ties += is_tied;
    EXPECT_EQ(found[k].generator, best) << k << ": " << points[k][0] << " " << points[k][1];
    EXPECT_TRUE(is_rounded(found[k].distance, least)) << k << ": " << found[k].distance;
  }
  return ties;
}

class Random {
 public:
  explicit Random(unsigned seed) : random_(seed) {}
  double part() { return static_cast<double>(random_() % 1048573) / 1048573; }
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

 private:
  std::mt19937 random_;
};

Disks random_disks(unsigned seed, int n, double largest) {
  Random random(seed);
  Disks disks;
  for (int k = 0; k < n; ++k) {
    const double x = random.part(), y = random.part();
    disks.push_back({{10 * x, 10 * y}, largest * random.part()});
  }
  return disks;
}

// Random ones, those of vertices, centres, and on sides.
std::vector<Vector> points_around(const StaticDiagram& diagram, unsigned seed) {
  Random random(seed);
  std::vector<Vector> points;
  for (int k = 0; k < 100; ++k) points.push_back({14 * random.part() - 2, 14 * random.part() - 2});
  for (const Vertex& v : diagram.vertices()) {
    if (std::fabs(v.center[0]) < 500 && std::fabs(v.center[1]) < 500) {
      points.push_back({std::ldexp(std::round(std::ldexp(v.center[0], 40)), -40),
                        std::ldexp(std::round(std::ldexp(v.center[1], 40)), -40)});
    }
  }
  for (const Circle& d : diagram.disks()) {
    points.push_back(d.center);
    points.push_back({d.center[0] + d.radius, d.center[1]});
  }
  return points;
}

TEST(StaticNearest, IsThatOfTheDefinition) {
  for (const double largest : {0.0, 0.5, 3.0}) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const Disks disks = random_disks(seed, static_cast<int>(seed) * 3, largest);
      for (const Frame& frame : {Frame(), Frame(Circle{{5, 5}, 4.5}), Frame(Circle{{3, 4}, 11})}) {
        const StaticDiagram diagram(disks, frame);
        expect_nearest(disks, frame, points_around(diagram, seed));
      }
    }
  }
}

// Whole numbers of all kinds: coincident disks, disks in each other, touching from inside and from
// outside, on lines, and points at one distance from many.
TEST(StaticNearest, TiesGoToTheLargestId) {
  int ties = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const int size = 2 + random.below(6);
    Disks disks;
    for (int k = 0; k < 30; ++k) {
      const double x = random.below(size), y = seed % 4 == 0 ? 0 : random.below(size);
      disks.push_back({{x, y}, seed % 3 == 0 ? 0.5 : random.below(3) - (seed % 3 == 1 ? 0 : 1.0)});
    }
    std::vector<Vector> points;
    for (int x = -4; x <= 4 * size; ++x) {
      for (int y = -4; y <= 4 * size; ++y) points.push_back({x / 4.0, y / 4.0});
    }
    ties += expect_nearest(disks, std::nullopt, points);
    for (Circle& d : disks) d.radius = std::max(0.0, d.radius);
    const double half = size / 2;
    for (const double radius : {half + 1, half, 1.0}) {
      ties += expect_nearest(disks, Circle{{half, half}, radius}, points);
    }
  }
  EXPECT_GT(ties, 10000);
}

// Square roots that no double tells apart, and that are equal.
TEST(StaticNearest, TiesOfSquareRootsAreDecided) {
  // sqrt(2) + sqrt(8) = sqrt(18): nearly and exactly.
  const double tenth = 0.1;
  const Disks disks{{{0, 0}, 0}, {{tenth + tenth, 0.2 + 0.2}, 0}, {{3 * tenth, -0.4}, 0.5}};
  expect_nearest(disks, std::nullopt, {{tenth, 0.2}, {0.15, -0.2}, {0.25, 0.35}});
  Disks twins;
  for (int k = 0; k < 8; ++k) {
    const double x = k & 1 ? 0.7 : -0.7, y = k & 2 ? 0.3 : -0.3;
    twins.push_back({k & 4 ? Vector{x, y} : Vector{y, x}, 0.1});
  }
  EXPECT_GT(expect_nearest(twins, std::nullopt, {{0, 0}, {0, 0.1}, {0.3, 0.3}, {-0.9, 0.9}}), 2);
}

TEST(StaticNearest, FewDisks) {
  const Disks two{{{0, 0}, 1}, {{4, 0}, 1}};
  EXPECT_EQ(expect_nearest(two, std::nullopt, {{2, 0}, {2, 7}, {1, 0}, {-9, 0}}), 2);
  EXPECT_EQ(expect_nearest(two, Circle{{2, 0}, 3}, {{2, 0}, {2, 7}, {-1, 0}, {2, -3}}), 2);
  expect_nearest({{{1, 2}, 3}}, std::nullopt, {{0, 0}, {1, 2}, {500, 0}});
  expect_nearest({{{1, 2}, 3}}, Circle{{0, 0}, 4}, {{0, 0}, {1, 2}, {500, 0}, {-4, 0}});
  expect_nearest({{{100, 2}, 3}}, Circle{{0, 0}, 4}, {{0, 0}, {1, 2}});
  expect_nearest({}, Circle{{0, 0}, 4}, {{0, 0}, {1, 2}});
  EXPECT_TRUE(StaticDiagram({}).nearest({}).empty());
  EXPECT_THROW(StaticDiagram({}).nearest({{0, 0}}), std::invalid_argument);
}

// Where two doubles and more bits do not tell to which side of a double a distance is.
TEST(StaticNearest, DistancesNearDoublesAreRounded) {
  const double far = std::ldexp(1, 100), near = std::ldexp(1, -101);  // sqrt(far^2 + 1) - far
  EXPECT_EQ(StaticDiagram({{{0, 0}, far}}).nearest({{far, 1}})[0].distance, near);
  EXPECT_EQ(StaticDiagram({}, Circle{{0, 0}, far}).nearest({{far, 1}})[0].distance, -near);
  EXPECT_EQ(StaticDiagram({{{0, 0}, far}}).nearest({{-far, 0}})[0].distance, 0);
}

// sqrt(1 + y^2) against sqrt(4 + y^2) - 1, where the square of y is no double.
TEST(StaticNearest, SmallNumbersDecide) {
  const StaticDiagram d({{{-2, 0}, 1}, {{1, 0}, 0}});
  const std::vector<Nearest> found = d.nearest({{0, 0}, {0, 1e-170}, {0, -1e-300}});
  EXPECT_EQ(found[0].generator, 1);
  EXPECT_EQ(found[1].generator, 0);
  EXPECT_EQ(found[2].generator, 0);
}

TEST(StaticNearest, UnitsDoNotCount) {
  const Disks disks = random_disks(4, 60, 1);
  std::vector<Vector> points = points_around(StaticDiagram(disks), 4);
  const std::vector<Nearest> expected = StaticDiagram(disks).nearest(points);
  for (const int exponent : {-300, 300}) {
    const auto scaled = [&](double x) { return std::ldexp(x, exponent); };
    Disks far = disks;
    for (Circle& d : far) d = {{scaled(d.center[0]), scaled(d.center[1])}, scaled(d.radius)};
    std::vector<Vector> places = points;
    for (Vector& p : places) p = {scaled(p[0]), scaled(p[1])};
    const std::vector<Nearest> found = StaticDiagram(far).nearest(places);
    for (std::size_t k = 0; k < points.size(); ++k) {
      EXPECT_EQ(found[k].generator, expected[k].generator);
      EXPECT_EQ(found[k].distance, scaled(expected[k].distance));
    }
  }
  // Points may be nearer to zero than disks.
  EXPECT_EQ(
      StaticDiagram({{{1e-100, 0}, 0}, {{-1e-100, 0}, 0}}).nearest({{1e-300, 0}})[0].generator, 0);
}

TEST(StaticNearest, BadPointsAreRefused) {
  const StaticDiagram d({{{0, 0}, 1}});
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), -1.1e100}) {
    try {
      d.nearest({{0, 0}, {1, bad}});
      ADD_FAILURE();
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(std::string(error.what()), "point 1: not finite, or beyond 1e100 in magnitude");
    }
  }
}

}  // namespace
}  // namespace voroproof
