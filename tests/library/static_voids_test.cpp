// The places of greatest clearance against slopes, sampled sides and grids, and where they are
// known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "voroproof/static_diagram.h"

namespace voroproof {
namespace {

using Disks = std::vector<Circle>;
using Frame = std::optional<Circle>;

Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1]}; }
Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1]}; }
Vector operator*(double k, const Vector& a) { return {k * a[0], k * a[1]}; }
double cross(const Vector& a, const Vector& b) { return a[0] * b[1] - a[1] * b[0]; }
double length(const Vector& a) { return std::hypot(a[0], a[1]); }

class World {
 public:
  World(Disks disks, Frame frame)
      : disks_(std::move(disks)), frame_(frame), diagram_(disks_, frame_) {}

  const StaticDiagram& diagram() const { return diagram_; }
  double distance(const Vector& p, int g) const {
    return g < 0 ? frame_->radius - length(p - frame_->center)
                 : length(p - disks_[g].center) - disks_[g].radius;
  }
  double clearance(const Vector& p) const {
    double least = frame_ ? distance(p, -1) : std::numeric_limits<double>::infinity();
    for (int g = 0; g < static_cast<int>(disks_.size()); ++g) {
      least = std::min(least, distance(p, g));
    }
    return least;
  }
  // Where the distance from the generator falls fastest.
  Vector contact(const Vector& p, int g) const {
    const Vector to = g < 0 ? p - frame_->center : disks_[g].center - p;
    return (1 / length(to)) * to;
  }

  // Vertices whose contacts are on no half, and far points: in the box, by this definition.
  std::vector<Vector> inner_places(const Box& box) const {
    std::vector<Vector> all;
    const auto add = [&](const Vector& p) {
      for (const int axis : {0, 1}) {
        if (!(box.low[axis] < p[axis] && p[axis] < box.high[axis])) return;
      }
      all.push_back(p);
    };
    for (const Vertex& v : diagram_.vertices()) {
      const auto side = [&](int a, int b) {
        return cross(contact(v.center, v.generators[a]), contact(v.center, v.generators[b]));
      };
      if (side(0, 1) > 0 && side(1, 2) > 0 && side(2, 0) > 0) add(v.center);
    }
    for (const Circle& d : frame_ ? disks_ : Disks()) {
      const Vector way = frame_->center - d.center;
      const Vector far =
          d.center + ((frame_->radius + d.radius + length(way)) / 2 / length(way)) * way;
      if (std::fabs(clearance(far) - length(far - d.center) + d.radius) < 1e-12) add(far);
    }
    return all;
  }

  // The greatest clearances along each side, by samples, from where it falls into the box.
  std::vector<Vector> places_on_sides(const Box& box) const {
    constexpr int samples = 4000;
    const Vector& a = box.low;
    const Vector& c = box.high;
    const Vector corners[4] = {a, {c[0], a[1]}, c, {a[0], c[1]}};
    std::vector<Vector> all;
    for (int k = 0; k < 4; ++k) {
      const Vector from = corners[k], along = corners[(k + 1) % 4] - from;
      const auto at = [&](double t) { return from + t / samples * along; };
      for (int s = 1; s < samples; ++s) {
        if (!(clearance(at(s)) > clearance(at(s - 1)) &&
              clearance(at(s)) >= clearance(at(s + 1)))) {
          continue;
        }
        double low = s - 1, high = s + 1;
        for (int step = 0; step < 80; ++step) {
          const double third = (high - low) / 3;
          (clearance(at(low + third)) < clearance(at(high - third)) ? low : high) +=
              clearance(at(low + third)) < clearance(at(high - third)) ? third : -third;
        }
        if (is_greatest(at(low), box)) all.push_back(at(low));
      }
      if (is_greatest(from, box)) all.push_back(from);
    }
    return all;
  }

  // Whether nowhere at a small distance in the box the clearance is more, but for its square: in
  // many directions, and across those of all contacts.
  bool is_greatest(const Vector& p, const Box& box, double near = 1e-5) const {
    std::vector<Vector> ways;
    for (int k = 0; k < 720; ++k) {
      ways.push_back({std::cos(k * M_PI / 360), std::sin(k * M_PI / 360)});
    }
    for (int g = 0; g < static_cast<int>(disks_.size()); ++g) {
      if (distance(p, g) > clearance(p) + 1e-9) continue;
      const Vector c = contact(p, g);
      ways.insert(ways.end(), {{-c[1], c[0]}, {c[1], -c[0]}});
    }
    for (const Vector& way : ways) {
      Vector q = p + near * way;
      for (const int axis : {0, 1}) {
        if (std::fabs(q[axis] - p[axis]) < 1e-16) q[axis] = p[axis];
        if (q[axis] < box.low[axis] || q[axis] > box.high[axis]) q = p;
      }
      if (clearance(q) > clearance(p) + near * near / 100) return false;
    }
    return true;
  }

 private:
  Disks disks_;
  Frame frame_;
  StaticDiagram diagram_;
};

Disks random_disks(unsigned seed, int n, double largest) {
  std::mt19937 random(seed);
  const auto part = [&] { return static_cast<double>(random() % 1000003) / 1000003; };
  Disks disks;
  for (int k = 0; k < n; ++k) {
    const double x = part(), y = part();
    disks.push_back({{10 * x, 10 * y}, largest * part()});
  }
  return disks;
}

std::vector<Vector> centers(const std::vector<EmptyCircle>& circles) {
  std::vector<Vector> all;
  for (const EmptyCircle& c : circles) all.push_back(c.center);
  return all;
}

// The same places, in any order.
void expect_places(std::vector<Vector> found, std::vector<Vector> expected, double tolerance) {
  std::sort(found.begin(), found.end());
  std::sort(expected.begin(), expected.end());
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_LT(length(found[k] - expected[k]), tolerance) << found[k][0] << " " << found[k][1];
  }
}

std::vector<World> worlds() {
  std::vector<World> all;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const Disks disks = random_disks(seed, static_cast<int>(seed) * 2, seed % 3 == 0 ? 1.5 : 0.4);
    for (const Frame& frame : {Frame(), Frame(Circle{{5, 5}, 4.5}), Frame(Circle{{4, 3}, 9})}) {
      all.emplace_back(disks, frame);
    }
  }
  return all;
}

TEST(StaticVoids, AreTheGreatestClearancesAround) {
  std::size_t missed = 0;
  for (const World& world : worlds()) {
    for (const Box& box : {Box{{-1, -2}, {11.5, 12}}, Box{{2, 3}, {8, 5.5}}}) {
      std::vector<Vector> expected = world.inner_places(box);
      for (const Vector& p : world.places_on_sides(box)) expected.push_back(p);
      expected.erase(std::remove_if(expected.begin(), expected.end(),
                                    [&](const Vector& p) { return world.clearance(p) < 0; }),
                     expected.end());
      const std::vector<EmptyCircle> voids = world.diagram().voids(box, 0);
      // Samples miss places that are narrower than their distance, but invent none.
      for (const Vector& p : expected) {
        EXPECT_TRUE(std::any_of(voids.begin(), voids.end(),
                                [&](const EmptyCircle& c) { return length(c.center - p) < 1e-6; }))
            << p[0] << " " << p[1];
      }
      missed += voids.size() - expected.size();
      for (const EmptyCircle& c : voids) {
        EXPECT_TRUE(world.is_greatest(c.center, box)) << c.center[0] << " " << c.center[1];
        EXPECT_NEAR(world.clearance(c.center), c.radius, 1e-12);
        for (const int g : c.generators) {
          EXPECT_NEAR(world.distance(c.center, g), c.radius, 1e-10);
        }
      }
      for (std::size_t k = 1; k < voids.size(); ++k) {
        EXPECT_GE(voids[k - 1].radius, voids[k].radius);
      }
    }
  }
  EXPECT_LE(missed, 3U);
}

TEST(StaticVoids, NoPlaceOfAGridHasMoreClearanceThanTheLargest) {
  for (const World& world : worlds()) {
    const Box box{{1.5, -0.5}, {9, 7}};
    const auto largest = world.diagram().largest_empty_circle(box);
    double most = -std::numeric_limits<double>::infinity();
    for (int x = 0; x <= 300; ++x) {
      for (int y = 0; y <= 300; ++y) {
        most = std::max(most, world.clearance({1.5 + x / 40.0, -0.5 + y / 40.0}));
      }
    }
    const double found = largest ? largest->radius : 0;
    EXPECT_LE(most, found + 1e-12);
    if (most > 0) {
      EXPECT_GE(most, found - 0.02);
    }
    const std::vector<EmptyCircle> voids = world.diagram().voids(box, 0);
    EXPECT_EQ(largest.has_value(), !voids.empty());
    if (largest) {
      EXPECT_EQ(largest->center, voids[0].center);
    }
  }
}

TEST(StaticVoids, TheProbeIsTheLeast) {
  const StaticDiagram d(random_disks(3, 50, 0.3));
  const std::vector<EmptyCircle> all = d.voids(d.box(), 0);
  ASSERT_GT(all.size(), 10U);
  EXPECT_EQ(d.voids(d.box(), all[5].radius).size(), 6U);
  EXPECT_EQ(d.voids(d.box(), std::nextafter(all[5].radius, 100)).size(), 5U);
}

// Between four points on a circle contacts of three are on one half of it.
TEST(StaticVoids, ManyContactsAreOnePlace) {
  Disks grid;
  for (int k = 0; k < 12; ++k) grid.push_back({{1.0 * (k % 4), 1.0 * (k / 4)}, 0});
  std::vector<EmptyCircle> voids = StaticDiagram(grid).voids({{-0.25, -0.25}, {3.25, 2.25}}, 0.6);
  ASSERT_EQ(voids.size(), 6U);
  for (const EmptyCircle& c : voids) {
    EXPECT_EQ(c.radius, std::sqrt(0.5));
    EXPECT_EQ(c.generators.size(), 4U);
  }
  // On the sides of this box are gates, vertices, and edges along them.
  voids = StaticDiagram(grid).voids({{0.5, 0}, {2.5, 1.5}}, 0);
  expect_places(centers(voids),
                {{0.5, 0.5}, {1.5, 0.5}, {2.5, 0.5}, {0.5, 1.5}, {1.5, 1.5}, {2.5, 1.5}}, 1e-15);
  for (const EmptyCircle& c : voids) EXPECT_EQ(c.generators.size(), 4U) << c.center[0];
}

// Whole numbers: contacts that are opposite, circles that touch many, disks that touch.
TEST(StaticVoids, AreTheGreatestClearancesOfWholeNumbers) {
  std::mt19937 random(1);
  const Box box{{-0.75, -0.625}, {6.5, 5.375}};
  std::size_t found = 0;
  for (int round = 0; round < 200; ++round) {
    Disks disks;
    for (int k = 0; k < 3 + round % 12; ++k) {
      const double x = random() % 6, y = random() % 6;
      disks.push_back({{x, y}, round % 3 == 0 ? 0.5 : random() % 3 / 2.0});
    }
    Frame frame;
    if (round % 2) frame = Circle{{3.25, 2}, 5};
    const World world(disks, frame);
    const std::vector<Vector> places = centers(world.diagram().voids(box, 0));
    for (const Vector& p : places) EXPECT_TRUE(world.is_greatest(p, box, 1e-3)) << round;
    for (const Vertex& v : world.diagram().vertices()) {
      const Vector& p = v.center;
      const bool is_inside =
          box.low[0] < p[0] && p[0] < box.high[0] && box.low[1] < p[1] && p[1] < box.high[1];
      if (!is_inside || v.radius < 0 || !world.is_greatest(p, box, 1e-3)) continue;
      ++found;
      EXPECT_EQ(std::count(places.begin(), places.end(), p), 1)
          << round << ": " << p[0] << " " << p[1];
    }
  }
  EXPECT_GT(found, 200U);
}

TEST(StaticVoids, CornersTouchAllThatIsNearest) {
  const StaticDiagram d({{{0, 0}, 0}, {{2, 0}, 0}});
  const std::vector<EmptyCircle> voids = d.voids({{1, -1}, {3, 1}}, 0);
  expect_places(centers(voids), {{1, -1}, {1, 1}, {3, -1}, {3, 1}}, 1e-15);
  for (const EmptyCircle& c : voids) {
    EXPECT_EQ(c.generators, c.center[0] == 1 ? (std::vector<int>{0, 1}) : (std::vector<int>{1}));
  }
}

TEST(StaticVoids, FewGenerators) {
  const Box box{{-9, -9}, {9, 9}};
  const Circle frame{{0, 0}, 8};
  const auto only = [&](const StaticDiagram& d, const Vector& at, double radius,
                        const std::vector<int>& generators, const Box& in) {
    const std::vector<EmptyCircle> voids = d.voids(in, 0);
    ASSERT_EQ(voids.size(), 1U);
    EXPECT_LT(length(voids[0].center - at), 1e-15);
    EXPECT_NEAR(voids[0].radius, radius, 1e-15);
    EXPECT_EQ(voids[0].generators, generators);
  };
  only(StaticDiagram({}, frame), {0, 0}, 8, {-1}, box);
  only(StaticDiagram({{{4, 0}, 1}}, frame), {-2.5, 0}, 5.5, {-1, 0}, box);
  only(StaticDiagram({{{0, 0}, 1}}, frame), {4.5, 0}, 3.5, {-1, 0}, box);
  // Nearest to the frame, and to its centre, on a side.
  only(StaticDiagram({{{-7.5, 0}, 0.5}}, frame), {2, 0}, 6, {-1}, {{2, -1}, {5, 1}});
  only(StaticDiagram({{{1, 2}, 3}}), {9, 9}, std::hypot(8, 7) - 3, {0}, {{2, 2}, {9, 9}});
  EXPECT_FALSE(StaticDiagram({{{1, 2}, 30}}).largest_empty_circle(box));
  EXPECT_FALSE(StaticDiagram({}, frame).largest_empty_circle({{9, 9}, {10, 10}}));
  EXPECT_THROW(StaticDiagram({}).voids(box, 0), std::invalid_argument);
  EXPECT_THROW(StaticDiagram({}).largest_empty_circle(box), std::invalid_argument);
}

// Between the frame and a disk in its centre the clearance is the same all around.
TEST(StaticVoids, PlacesThatALevelEdgeJoinsAreOne) {
  const StaticDiagram d({{{0, 0}, 2}, {{5, 0}, 0.5}}, Circle{{0, 0}, 10});
  const std::vector<EmptyCircle> voids = d.voids({{-10, -10}, {10, 10}}, 0);
  ASSERT_EQ(voids.size(), 1U);
  EXPECT_EQ(voids[0].radius, 4);
  EXPECT_EQ(voids[0].generators, (std::vector<int>{-1, 0, 1}));
  expect_places(centers(d.voids({{-10, 1}, {0, 10}}, 0)), {{0, 6}, {-std::sqrt(35), 1}}, 1e-12);
}

// Disk 0 and the frame have the gate (8, 0) and the far point (-2, 0): a third one touches there.
TEST(StaticVoids, VerticesMayBeGatesAndFarPoints) {
  const Circle frame{{0, 0}, 10}, disk{{6, 0}, 0};
  const Box box{{-10, -10}, {10, 10}};
  std::vector<EmptyCircle> voids = StaticDiagram({disk, {{-2, -9}, 1}}, frame).voids(box, 0);
  EXPECT_EQ(voids[0].center, (Vector{-2, 0}));
  EXPECT_EQ(voids[0].radius, 8);
  EXPECT_EQ(voids[0].generators, (std::vector<int>{-1, 0, 1}));
  const StaticDiagram gate({disk, {{8, 3}, 1}}, frame);
  for (const Vector& p : centers(gate.voids(box, 0))) EXPECT_NE(p, (Vector{8, 0}));
}

TEST(StaticVoids, UnitsDoNotCount) {
  const Disks disks = random_disks(5, 40, 1);
  for (const bool framed : {false, true}) {
    Frame frame;
    if (framed) frame = Circle{{5, 5}, 6};
    const std::vector<EmptyCircle> expected =
        StaticDiagram(disks, frame).voids({{0, 1}, {9, 10}}, 0);
    for (const int exponent : {-300, 300}) {
      const auto scaled = [&](const Vector& p) {
        return Vector{std::ldexp(p[0], exponent), std::ldexp(p[1], exponent)};
      };
      const auto far = [&](const Circle& d) {
        return Circle{scaled(d.center), std::ldexp(d.radius, exponent)};
      };
      Disks all;
      for (const Circle& d : disks) all.push_back(far(d));
      if (framed) frame = far(Circle{{5, 5}, 6});
      const std::vector<EmptyCircle> found =
          StaticDiagram(all, frame).voids({scaled({0, 1}), scaled({9, 10})}, 0);
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t k = 0; k < found.size(); ++k) {
        EXPECT_EQ(found[k].center, scaled(expected[k].center));
        EXPECT_EQ(found[k].radius, std::ldexp(expected[k].radius, exponent));
        EXPECT_EQ(found[k].generators, expected[k].generators);
      }
    }
  }
}

TEST(StaticVoids, BadValuesAreRefused) {
  const StaticDiagram d({{{0, 0}, 1}, {{3, 0}, 1}});
  const double nan = std::nan("");
  EXPECT_THROW(d.voids({{0, 0}, {0, 1}}, 0), std::invalid_argument);
  EXPECT_THROW(d.voids({{0, nan}, {1, 1}}, 0), std::invalid_argument);
  EXPECT_THROW(d.voids({{0, 0}, {1, 1.1e100}}, 0), std::invalid_argument);
  EXPECT_THROW(d.voids({{0, 0}, {1, 1}}, -1), std::invalid_argument);
  EXPECT_THROW(d.voids({{0, 0}, {1, 1}}, nan), std::invalid_argument);
  EXPECT_THROW(d.largest_empty_circle({{0, 0}, {0, 1}}), std::invalid_argument);
}

}  // namespace
}  // namespace voroproof
