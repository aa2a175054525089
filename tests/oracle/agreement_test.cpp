// The oracles of diagrams against each other, and what they refuse.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/oracle/brute_force.h"
#include "tests/oracle/cgal_apollonius.h"
#include "tests/oracle/scenes.h"

namespace voroproof::oracle {
namespace {

// ---- Scenes ----

// Each disk a hair's breadth (about 2^-40) from an earlier one.
Disks nearly_touching(Random& random, int n) {
  Disks disks{somewhere(random, 10)};
  while (!fits({}, disks[0])) disks[0] = somewhere(random, 10);
  while (disks.size() < static_cast<std::size_t>(n)) {
    const ExactCircle& next_to = disks[random() % disks.size()];
    const double radius = std::exp(uniform(random, std::log(0.01), std::log(40)));
    const double reach = next_to.radius.get_d() + radius + std::ldexp(1.0, -40);
    const double angle = uniform(random, 0, 6.283185307179586);
    const ExactCircle d{next_to.x.get_d() + reach * std::cos(angle),
                        next_to.y.get_d() + reach * std::sin(angle), radius};
    if (fits(disks, d)) disks.push_back(d);
  }
  return disks;
}

// Equal disks on a square grid: every cell of four is cotangent. Touching when 2 radius = pitch.
Disks grid(int columns, int rows, const mpq_class& pitch, const mpq_class& radius,
           const mpq_class& shift) {
  Disks disks;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) disks.push_back({pitch * i - shift, pitch * j - shift, radius});
  }
  return disks;
}

// Disks of different radii that all touch the circle (x, y, 60) exactly, at rational directions.
Disks ring(Random& random, int n, const mpq_class& x, const mpq_class& y) {
  Disks disks;
  for (int i = 0; i < n; ++i) {
    const mpq_class angle = mpq_class(2 * i + 1 - n, 4);  // tangent of half the angle
    const mpq_class norm = 1 + angle * angle;
    const mpq_class radius = mpq_class(static_cast<int>(random() % 20), 10), reach = 60 + radius;
    const ExactCircle d{x + reach * (1 - angle * angle) / norm, y + reach * 2 * angle / norm,
                        radius};
    if (fits(disks, d)) disks.push_back(d);
  }
  return disks;
}

// ---- Diagrams ----

// A diagram that `truth` allows: every cotangent class triangulated by a fan from some contact.
std::vector<Quadruple> some_diagram(const BruteDiagram& truth, Random& random) {
  using Side = std::pair<int, int>;
  std::vector<std::map<Side, int>> third_of_side(truth.classes.size());
  std::vector<Quadruple> edges;
  for (std::size_t c = 0; c < truth.classes.size(); ++c) {
    std::vector<int> polygon = truth.classes[c].contacts;
    std::rotate(polygon.begin(), polygon.begin() + static_cast<long>(random() % polygon.size()),
                polygon.end());
    std::map<Side, int>& third = third_of_side[c];
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
      const int a = polygon[0], b = polygon[i], d = polygon[i + 1];
      third[{a, b}] = d;
      third[{b, d}] = a;
      third[{d, a}] = b;
    }
    for (std::size_t i = 2; i + 1 < polygon.size(); ++i) {
      const int l = polygon[0], r = polygon[i];
      edges.push_back({l, r, third.at({r, l}), third.at({l, r})});
    }
  }
  for (const auto& [l, r, start, end] : truth.links) {
    edges.push_back({l, r, third_of_side[static_cast<std::size_t>(start)].at({r, l}),
                     third_of_side[static_cast<std::size_t>(end)].at({l, r})});
  }
  return edges;
}

// Both oracles on one scene. Every vertex circle is also checked for tangency in plain doubles.
BruteDiagram expect_oracles_agree(const Disks& disks, Random& random) {
  const BruteDiagram truth = brute_force_diagram(rounded(disks), oracle::rounded(kContainer));
  const std::vector<Quadruple> edges = some_diagram(truth, random);
  EXPECT_EQ(edges.size(), 3 * (disks.size() + 1) - 6);
  std::set<Triple> vertices;
  for (const Quadruple& e : edges) {
    vertices.insert(start_vertex(e));
    vertices.insert(end_vertex(e));
  }
  EXPECT_EQ(vertices.size(), 2 * (disks.size() + 1) - 4);
  std::string why;
  EXPECT_TRUE(agrees(truth, edges, &why)) << why;
  EXPECT_TRUE(agrees_with_cgal(disks, kContainer, edges, &why)) << why;
  for (const CotangentClass& c : truth.classes) {
    const double x = static_cast<double>(c.circle.x), y = static_cast<double>(c.circle.y);
    for (int g : c.contacts) {
      const ExactCircle& generator = g < 0 ? kContainer : disks[static_cast<std::size_t>(g)];
      const double distance = std::hypot(x - generator.x.get_d(), y - generator.y.get_d());
      const double r = generator.radius.get_d();
      EXPECT_NEAR(g < 0 ? r - distance : distance - r, static_cast<double>(c.circle.radius), 1e-10);
    }
  }
  return truth;
}

// ---- The oracles against each other ----

struct Kind {
  const char* name;
  std::function<Disks(Random&, int)> make;
  bool degenerate;
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{
      {"moderate", [](Random& g, int n) { return thrown(g, n, [&] { return uniform(g, 1, 15); }); },
       false},
      {"tiny_and_huge",
       [](Random& g, int n) {
         return thrown(g, n, [&] {
           return g() % 4 == 0 ? uniform(g, 20, 70)
                               : std::exp(uniform(g, std::log(1e-9), std::log(1.0)));
         });
       },
       false},
      {"points", [](Random& g, int n) { return thrown(g, n, [] { return 0.0; }); }, false},
      {"points_and_disks",
       [](Random& g, int n) {
         return thrown(g, n, [&] { return g() % 2 == 0 ? 0.0 : uniform(g, 5, 50); });
       },
       false},
      {"equal", [](Random& g, int n) { return thrown(g, n, [] { return 7.5; }); }, false},
      {"nearly_touching", nearly_touching, false},
      {"grid", [](Random&, int n) { return grid(5, std::max(2, n / 5), 30, 7, mpq_class(131, 2)); },
       true},
      {"touching_grid",
       [](Random&, int n) { return grid(5, std::max(2, n / 5), 30, 15, mpq_class(131, 2)); }, true},
      {"point_grid",
       [](Random&, int n) { return grid(4, std::max(2, n / 4), 30, 0, mpq_class(45)); }, true},
      {"ring", [](Random& g, int n) { return ring(g, std::max(5, n), 20, mpq_class(-31, 3)); },
       true},
      {"concentric_ring", [](Random& g, int n) { return ring(g, std::max(5, n), 0, 0); }, true},
  };
  return all;
}

class OracleScenes : public testing::TestWithParam<std::size_t> {};

TEST_P(OracleScenes, BruteForceAgreesWithCgal) {
  const Kind& kind = kinds()[GetParam()];
  Random random(1000 + GetParam());
  bool degenerate = false;
  for (int n : {2, 3, 4, 5, 6, 8, 10, 12, 15, 20, 25}) {
    SCOPED_TRACE(std::string(kind.name) + ", n = " + std::to_string(n));
    degenerate |= expect_oracles_agree(kind.make(random, n), random).degenerate;
  }
  EXPECT_EQ(degenerate, kind.degenerate);
}

INSTANTIATE_TEST_SUITE_P(Kinds, OracleScenes, testing::Range<std::size_t>(0, kinds().size()),
                         [](const auto& info) { return kinds()[info.param].name; });

// The diagram of a slightly different scene, which has other vertices, is refused by both.
TEST(Oracle, RefusesTheDiagramOfAnotherScene) {
  Random random(7);
  int changed = 0;
  for (int round = 0; round < 10; ++round) {
    const Disks disks = thrown(random, 12, [&] { return uniform(random, 0, 20); });
    Disks moved = disks;
    moved[3].x += 15;
    if (!fits({moved.begin() + 4, moved.end()}, moved[3]) ||
        !fits({moved.begin(), moved.begin() + 3}, moved[3])) {
      continue;
    }
    const BruteDiagram truth = brute_force_diagram(rounded(disks), oracle::rounded(kContainer));
    const BruteDiagram other = brute_force_diagram(rounded(moved), oracle::rounded(kContainer));
    if (truth.edges == other.edges) continue;
    ++changed;
    EXPECT_FALSE(agrees(truth, edges_of(other), nullptr));
    std::set<Triple> inner, other_inner;
    for (const Triple& v : truth.vertices())
      if (v[0] >= 0) inner.insert(v);
    for (const Triple& v : other.vertices())
      if (v[0] >= 0) other_inner.insert(v);
    EXPECT_EQ(agrees_with_cgal(disks, kContainer, edges_of(other), nullptr), inner == other_inner);
  }
  EXPECT_GE(changed, 3);
}

TEST(Oracle, RefusesDamagedDiagrams) {
  Random random(8);
  const Disks generic = thrown(random, 10, [&] { return uniform(random, 0, 20); });
  const Disks square = grid(3, 3, 40, 5, 33);
  for (const Disks& disks : {generic, square}) {
    const BruteDiagram truth = brute_force_diagram(rounded(disks), oracle::rounded(kContainer));
    const std::vector<Quadruple> edges = some_diagram(truth, random);
    ASSERT_TRUE(agrees(truth, edges, nullptr));
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const auto refused = [&](const Quadruple& instead) {
        std::vector<Quadruple> damaged = edges;
        damaged[i] = instead;
        std::string why;
        const bool refused = !agrees(truth, damaged, &why);
        EXPECT_EQ(refused, !why.empty());
        return refused;
      };
      const auto [l, r, s, e] = edges[i];
      EXPECT_FALSE(refused({r, l, e, s}));  // The same edge walked backwards.
      EXPECT_TRUE(refused({l, r, e, s}) || s == e);
      EXPECT_TRUE(refused({s, e, r, l}));
      EXPECT_TRUE(refused({l, l, s, s}));
      EXPECT_TRUE(refused({l, r, s, 99}));
      EXPECT_TRUE(refused(edges[(i + 1) % edges.size()]));
      std::vector<Quadruple> shorter = edges;
      shorter.erase(shorter.begin() + static_cast<long>(i));
      EXPECT_FALSE(agrees(truth, shorter, nullptr));
    }
  }
}

TEST(Oracle, CgalRefusesMissingAndInventedVertices) {
  const Disks disks{{0, 10, 0}, {-8, -6, 0}, {8, -6, 0}};
  const std::vector<Quadruple> edges =
      edges_of(brute_force_diagram(rounded(disks), oracle::rounded(kContainer)));
  ASSERT_TRUE(agrees_with_cgal(disks, kContainer, edges, nullptr));
  EXPECT_FALSE(agrees_with_cgal(disks, kContainer, {}, nullptr));
  const auto with = [&](const Quadruple& invented) {
    std::vector<Quadruple> more = edges;
    more.push_back(invented);
    return more;
  };
  EXPECT_FALSE(agrees_with_cgal(disks, kContainer, with({0, 1, 2, -1}), nullptr));
  EXPECT_FALSE(agrees_with_cgal(disks, kContainer, with({0, 1, 1, -1}), nullptr));
  EXPECT_FALSE(agrees_with_cgal(disks, kContainer, with({0, 1, 9, -1}), nullptr));
  // A cotangent class may be resolved either way, but not both ways at once.
  const Disks square{{10, 0, 1}, {0, 10, 1}, {-10, 0, 1}, {0, -10, 1}};
  EXPECT_TRUE(agrees_with_cgal(square, kContainer, {{0, 2, 1, 3}}, nullptr));
  EXPECT_TRUE(agrees_with_cgal(square, kContainer, {{1, 3, 2, 0}}, nullptr));
  EXPECT_FALSE(agrees_with_cgal(square, kContainer, {{0, 2, 1, 3}, {1, 3, 2, 0}}, nullptr));
  // A vertex too far out for the container: CGAL has it, the diagram needs not.
  const Disks flat{{-100, 0, 0}, {0, 1, 0}, {100, 0, 0}};
  const BruteDiagram without = brute_force_diagram(rounded(flat), oracle::rounded(kContainer));
  EXPECT_EQ(cgal_diagram(flat, kContainer).vertices.size(), 1u);
  EXPECT_TRUE(agrees_with_cgal(flat, kContainer, edges_of(without), nullptr));
  EXPECT_TRUE(std::all_of(without.classes.begin(), without.classes.end(),
                          [](const CotangentClass& c) { return c.contacts[0] == -1; }));
}

TEST(Oracle, CgalRefusesMissingAndInventedEdges) {
  const mpq_class small(1, 10);
  const Disks disks{{-50, 0, 49}, {50, 0, 49}, {0, 7, small}, {0, -7, small}};
  const std::vector<Quadruple> edges =
      edges_of(brute_force_diagram(rounded(disks), oracle::rounded(kContainer)));
  const Quadruple between{0, 1, 3, 2}, invented{0, 1, 2, 3};
  const auto position = std::find(edges.begin(), edges.end(), between);
  ASSERT_NE(position, edges.end());
  std::vector<Quadruple> less = edges, more = edges;
  less.erase(less.begin() + (position - edges.begin()));
  more.push_back(invented);
  EXPECT_TRUE(agrees_with_cgal(disks, kContainer, edges, nullptr));
  EXPECT_FALSE(agrees_with_cgal(disks, kContainer, less, nullptr));
  EXPECT_FALSE(agrees_with_cgal(disks, kContainer, more, nullptr));
}

// Moving, turning by a rational angle and scaling a scene changes nothing.
TEST(Oracle, IsInvariantUnderSimilarity) {
  Random random(9);
  const Disks disks = thrown(random, 12, [&] { return uniform(random, 0, 25); });
  const BruteDiagram truth = brute_force_diagram(rounded(disks), oracle::rounded(kContainer));
  const mpq_class c(3, 5), s(4, 5), scale(1, 1000000), shift_x("12345/7"), shift_y(-99);
  const auto image = [&](const ExactCircle& d) {
    return ExactCircle{scale * (c * d.x - s * d.y) + shift_x, scale * (s * d.x + c * d.y) + shift_y,
                       scale * d.radius};
  };
  Disks images;
  for (const ExactCircle& d : disks) images.push_back(image(d));
  const BruteDiagram same =
      brute_force_diagram(rounded(images), oracle::rounded(image(kContainer)));
  EXPECT_EQ(same.edges, truth.edges);
  std::string why;
  EXPECT_TRUE(agrees_with_cgal(images, image(kContainer), edges_of(truth), &why)) << why;
}

}  // namespace
}  // namespace voroproof::oracle
