// The diagram from scratch against brute force and CGAL.
#include "engine/static_diagram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>

#include "library/maneuver_input.h"
#include "tests/oracle/cgal_apollonius.h"
#include "tests/support/compact_arithmetic.h"
#include "tests/support/history_check.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
namespace {

oracle::ExactCircle moved(const DiskInput& d, const Rational& t) {
  return {d.x + t * d.vx, d.y + t * d.vy, d.radius};
}

// Computes the diagram of the scene's disks on their lines at time t and compares. Returns
// whether more than three generators touched one empty circle.
bool expect_diagram(const Scene& scene, const Rational& t = 0, TierCounts* tiers = nullptr) {
  TierCounts counts;
  const ComputedMotion motion(motion_input(scene), {});
  const Diagram diagram = static_diagram(motion, t, counts);
  if (tiers != nullptr) *tiers += counts;
  std::string why;
  EXPECT_TRUE(diagram.is_valid(&why)) << why << text(scene);
  if (scene.disks.size() < 2) {
    EXPECT_EQ(diagram.edges(), 0);
    return false;
  }
  std::vector<oracle::ExactCircle> exact;
  std::vector<oracle::Circle> disks;
  for (const DiskInput& d : scene.disks) {
    exact.push_back(moved(d, t));
    disks.push_back(oracle::rounded(exact.back()));
  }
  const oracle::ExactCircle container{scene.cx, scene.cy, scene.container_radius};
  const auto truth = oracle::brute_force_diagram(disks, oracle::rounded(container));
  EXPECT_TRUE(oracle::agrees(truth, quadruples(diagram.quads()), &why)) << why << text(scene);
  EXPECT_TRUE(oracle::agrees_with_cgal(exact, container, quadruples(diagram.quads()), &why))
      << why << text(scene);
  return truth.degenerate;
}

TEST(StaticDiagram, SmallestCases) {
  expect_diagram(scene_of(10, 0, {}));
  expect_diagram(scene_of(10, 0, {disk(1, 2, 3, 0, 0)}));
  expect_diagram(scene_of(10, 0, {disk(-4, 0, 1, 0, 0), disk(4, 1, 2, 0, 0)}));
  // The centre of the container is inside a disk, and on the line of two.
  expect_diagram(scene_of(10, 0, {disk(0, 0, 4, 0, 0), disk(6, 0, 1, 0, 0)}));
  expect_diagram(scene_of(10, 0, {disk(0, 0, 4, 0, 0), disk(6, 0, 1, 0, 0), disk(-7, 0, 2, 0, 0)}));
}

TEST(StaticDiagram, RandomOfManyKinds) {
  Random random(1);
  for (const auto& [rmin, rmax] : {std::pair(2.0, 8.0), std::pair(1e-3, 20.0), std::pair(4.0, 4.0),
                                   std::pair(0.0, 0.0), std::pair(3.0, 3.0 + 1e-12)}) {
    for (int n : {2, 3, 4, 6, 9, 14, 20}) {
      EXPECT_FALSE(expect_diagram(random_scene({.n = n, .rmin = rmin, .rmax = rmax}, random)));
    }
  }
}

TEST(StaticDiagram, Dense) {
  Random random(2);
  for (int n : {5, 12, 25}) {
    expect_diagram(random_scene({.n = n, .rmin = 5, .rmax = 20, .density = 0.45}, random));
  }
}

// Each disk a hair's breadth from an earlier one, or touching it exactly.
TEST(StaticDiagram, TouchingAndNearlyTouching) {
  Random random(3);
  for (int exponent : {0, 20, 45, 80}) {  // gaps of 2^-exponent; 0 for none
    for (int k = 0; k < 6; ++k) {
      Scene scene = scene_of(100, 0, {disk(20, -10, 12, 0, 0)});
      while (scene.disks.size() < 12) {
        const DiskInput& neighbour = scene.disks[random() % scene.disks.size()];
        // A rational direction: (1 - m^2, 2 m) / (1 + m^2).
        Rational m(static_cast<int>(random() % 401) - 200, 50);
        m.canonicalize();
        const Rational norm = 1 + m * m;
        Rational r(static_cast<int>(1 + random() % 100), 8);
        r.canonicalize();
        Rational gap = exponent == 0 ? 0 : 1;
        gap >>= static_cast<unsigned long>(exponent);
        const Rational reach = neighbour.radius + r + gap;
        Scene more = scene;
        more.disks.push_back(disk(neighbour.x + reach * (1 - m * m) / norm,
                                  neighbour.y + reach * 2 * m / norm, r, 0, 0));
        if (is_acceptable(more)) scene = more;
      }
      expect_diagram(scene);
    }
  }
}

// Cotangent generators by the dozen; every choice among them is right here.
TEST(StaticDiagram, GridsAreRightUpToCotangency) {
  for (const Rational& radius : {Rational(0), Rational(1, 2), Rational(1), Rational(2)}) {
    for (int columns : {2, 3, 4}) {
      Scene scene = scene_of(30, 0, {});
      for (int x = 0; x < columns; ++x) {
        for (int y = 0; y < 4; ++y) {
          scene.disks.push_back(disk(4 * x - 2 * columns, 4 * y - 8, radius, 0, 0, 1));
        }
      }
      EXPECT_TRUE(expect_diagram(scene));
    }
  }
}

// All disks touch one circle, of which the container is, or is not, one.
TEST(StaticDiagram, Rings) {
  Random random(4);
  for (bool touching_container : {false, true}) {
    Scene scene = scene_of(100, 0, {});
    for (int k = -4; k <= 4; ++k) {
      Rational m(2 * k + 1, 4);
      m.canonicalize();
      const Rational norm = 1 + m * m;
      const Rational r(static_cast<int>(1 + random() % 5));
      const Rational reach = touching_container ? Rational(100 - r) : Rational(60 + r);
      scene.disks.push_back(disk(reach * (1 - m * m) / norm, reach * 2 * m / norm, r, 0, 0));
    }
    ASSERT_TRUE(is_acceptable(scene));
    EXPECT_EQ(expect_diagram(scene), !touching_container);
  }
}

// A cell of as many edges as there are disks is not walked around for each of them: the predicates
// decided are a few per disk, along the container and around a huge disk.
TEST(StaticDiagram, CellsOfManyEdges) {
  Random random(6);
  const int n = 2000;
  for (const bool along_container : {true, false}) {
    Scene scene = scene_of(10000, 0, {});
    if (!along_container) scene.disks.push_back(disk(0, 0, 5000, 0, 0));
    for (int k = 0; k < n; ++k) {
      const double angle = 2 * std::numbers::pi * k / n;
      const double r = uniform(random, 1, 6), gap = uniform(random, 0.1, 3);
      const double reach = along_container ? 10000 - r - gap : 5000 + r + gap;
      scene.disks.push_back(disk(Rational(reach * std::cos(angle)),
                                 Rational(reach * std::sin(angle)), Rational(r), 0, 0));
    }
    std::shuffle(scene.disks.begin(), scene.disks.end(), random);
    TierCounts counts;
    const ComputedMotion motion(motion_input(scene), {});
    const Diagram diagram = static_diagram(motion, 0, counts);
    EXPECT_TRUE(diagram.is_valid());
    std::uint64_t decided = 0;
    for (const std::uint64_t k : counts.decided[static_cast<int>(Predicate::incircle)])
      decided += k;
    EXPECT_LT(decided, 60u * n);
  }
}

TEST(StaticDiagram, AtAnyExactTime) {
  Random random(5);
  const Scene scene = random_scene({.n = 12, .rmin = 0.1, .rmax = 3, .speed = 0.05}, random);
  for (const Rational& t : {Rational(1, 3), Rational(7, 5), Rational(0)}) expect_diagram(scene, t);
}

// Generic disks are decided by the first filter; a near miss by a later one; a tie exactly.
TEST(StaticDiagram, TiersAreUsedAsNeeded) {
  const auto tiers = [](const Rational& shift) {
    // Four disks that touch the circle of centre (1/3, 2) and radius 5 from outside, so cotangent
    // when shift is 0; of unequal radii, since the discriminant of equal ones is known to no
    // filter.
    const auto touching = [](const Rational& x, const Rational& y, const Rational& r) {
      return disk(Rational(1, 3) + x * (5 + r) / 5, 2 + y * (5 + r) / 5, r, 0, 0);
    };
    Scene scene = scene_of(30, 0,
                           {touching(3, 4, 1), touching(-4, 3, 2), touching(-3, -4, Rational(3, 2)),
                            touching(4, -3, 3)});
    scene.disks.back().x += shift;
    TierCounts counts;
    expect_diagram(scene, 0, &counts);
    return counts.decided[static_cast<int>(Predicate::incircle)];
  };
  const auto at = [](const auto& decided, Tier t) { return decided[static_cast<int>(t)]; };
  const auto tiny = [](unsigned long bits) {
    Rational q = 1;
    q >>= bits;
    return q;
  };
  // What the construction decides exactly wherever the last disk is, it decides for 1/2 too.
  const auto generic = tiers(Rational(1, 2));
  EXPECT_GT(at(generic, Tier::filter), 0u);
  EXPECT_EQ(at(generic, Tier::dd) + at(generic, Tier::ball), 0u);
  const auto near = tiers(tiny(45));
  EXPECT_GT(at(near, Tier::dd), 0u);
  EXPECT_EQ(at(near, Tier::ball), 0u);
  EXPECT_EQ(at(near, Tier::exact), at(generic, Tier::exact));
  const auto nearer = tiers(tiny(120));
  EXPECT_GT(at(nearer, Tier::ball), 0u);
  EXPECT_EQ(at(nearer, Tier::exact), at(generic, Tier::exact));
  EXPECT_GT(at(tiers(0), Tier::exact), at(generic, Tier::exact));
}

// settle() makes the one diagram that the largest id chooses, whatever it is given.
TEST(StaticDiagram, SettlingIsUnique) {
  Scene scene = scene_of(30, 0, {});
  for (int k = 0; k < 16; ++k)
    scene.disks.push_back(disk(4 * (k % 4) - 6, 4 * (k / 4) - 6, 1, 0, 0));
  ComputedMotion motion(motion_input(scene), {});
  TierCounts counts;
  const Moment now = Moment::at(0);
  Diagram reference = static_diagram(motion, 0, counts);
  settle(reference, motion, now, counts);
  Random random(6);
  long flips = 0;
  for (int trial = 0; trial < 10; ++trial) {
    Diagram other = reference;
    for (int k = 0; k < 40; ++k) {
      const auto h =
          static_cast<Diagram::HalfEdge>(random() % static_cast<std::uint64_t>(2 * other.edges()));
      const Quad q = other.quad(h);
      // Within a square of the lattice either diagonal is right.
      const auto square = [&](GenId g) { return g != container_id; };
      if (!square(q.l) || !square(q.r) || !square(q.s) || !square(q.e)) continue;
      const auto x = [](GenId g) { return g % 4; };
      const auto y = [](GenId g) { return g / 4; };
      if (std::abs(x(q.l) - x(q.r)) == 1 && std::abs(y(q.l) - y(q.r)) == 1) other.flip(h);
    }
    flips += settle(other, motion, now, counts);
    EXPECT_EQ(other.quads(), reference.quads());
  }
  EXPECT_GT(flips, 10);
}

}  // namespace
}  // namespace voroproof::internal::testing
