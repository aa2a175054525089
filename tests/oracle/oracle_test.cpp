// The oracles against each other and against cases worked out by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "tests/oracle/brute_force.h"
#include "tests/oracle/cgal_apollonius.h"
#include "tests/oracle/motion.h"

namespace voroproof::oracle {
namespace {

using Disks = std::vector<ExactCircle>;
using Random = std::mt19937_64;

const ExactCircle kContainer{0, 0, 250};

// ---- Scenes ----

std::vector<Circle> rounded(const Disks& disks) {
  std::vector<Circle> result;
  for (const ExactCircle& d : disks) result.push_back(oracle::rounded(d));
  return result;
}

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

// Decided exactly; a point must not even touch.
bool fits(const Disks& disks, const ExactCircle& d) {
  const auto far_enough = [](const mpq_class& squared, const mpq_class& reach, bool strictly) {
    const mpq_class least = reach * reach;
    return strictly ? squared > least : squared >= least;
  };
  const mpq_class room = kContainer.radius - d.radius;
  if (room <= 0) return false;
  const mpq_class from_centre = d.x * d.x + d.y * d.y, room2 = room * room;
  if (d.radius == 0 ? from_centre >= room2 : from_centre > room2) return false;
  return std::all_of(disks.begin(), disks.end(), [&](const ExactCircle& e) {
    const mpq_class dx = d.x - e.x, dy = d.y - e.y;
    return far_enough(dx * dx + dy * dy, d.radius + e.radius, d.radius == 0 || e.radius == 0);
  });
}

ExactCircle somewhere(Random& random, double radius) {
  const double distance = 250 * std::sqrt(uniform(random, 0, 1));
  const double angle = uniform(random, 0, 6.283185307179586);
  return {distance * std::cos(angle), distance * std::sin(angle), radius};
}

// n disks whose radii `radius` draws, thrown until they fit.
Disks thrown(Random& random, int n, const std::function<double()>& radius) {
  Disks disks;
  while (disks.size() < static_cast<std::size_t>(n)) {
    const ExactCircle d = somewhere(random, radius());
    if (fits(disks, d)) disks.push_back(d);
  }
  return disks;
}

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

std::vector<Quadruple> edges_of(const BruteDiagram& diagram) {
  return {diagram.edges.begin(), diagram.edges.end()};
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

// ---- By hand ----

TEST(OracleByHand, FewerThanTwoDisksHaveNoEdges) {
  for (const Disks& disks : {Disks{}, Disks{{3, 4, 5}}}) {
    const BruteDiagram diagram = brute_force_diagram(rounded(disks), oracle::rounded(kContainer));
    EXPECT_TRUE(diagram.classes.empty());
    EXPECT_TRUE(diagram.edges.empty());
    EXPECT_TRUE(agrees(diagram, {}, nullptr));
    EXPECT_FALSE(agrees(diagram, {{-1, 0, 0, 0}}, nullptr));
  }
}

// Points at (+-3, 0) in a circle of radius 9: sqrt(9 + y^2) = 9 - |y| at y = +-4.
TEST(OracleByHand, TwoPoints) {
  const BruteDiagram diagram = brute_force_diagram({{-3, 0, 0}, {3, 0, 0}}, {0, 0, 9});
  ASSERT_EQ(diagram.classes.size(), 2u);
  const CotangentClass &top = diagram.classes[0], &bottom = diagram.classes[1];
  EXPECT_EQ(top.contacts, (std::vector<int>{-1, 0, 1}));
  EXPECT_EQ(bottom.contacts, (std::vector<int>{-1, 1, 0}));
  EXPECT_LT(abs(top.circle.y - 4), 1e-90);
  EXPECT_LT(abs(bottom.circle.y + 4), 1e-90);
  EXPECT_LT(abs(top.circle.radius - 5), 1e-90);
  EXPECT_EQ(diagram.edges, (std::set<Quadruple>{{-1, 0, 1, 1}, {-1, 1, 0, 0}, {0, 1, -1, -1}}));
}

// Three points counterclockwise from the top: one vertex in the middle, three outside.
TEST(OracleByHand, ThreePoints) {
  const Disks disks{{0, 10, 0}, {-8, -6, 0}, {8, -6, 0}};
  const BruteDiagram diagram = brute_force_diagram(rounded(disks), oracle::rounded(kContainer));
  EXPECT_EQ(diagram.edges, (std::set<Quadruple>{{0, 1, -1, 2},
                                                {1, 2, -1, 0},
                                                {0, 2, 1, -1},
                                                {-1, 0, 1, 2},
                                                {-1, 1, 2, 0},
                                                {-1, 2, 0, 1}}));
  const CgalDiagram cgal = cgal_diagram(disks, kContainer);
  ASSERT_EQ(cgal.vertices.size(), 1u);
  EXPECT_EQ(cgal.vertices[0].generators, (Triple{0, 1, 2}));
  EXPECT_LT(abs(cgal.vertices[0].circle.radius - 10), 1e-90);
  EXPECT_LT(abs(cgal.vertices[0].circle.x) + abs(cgal.vertices[0].circle.y), 1e-90);
}

// A tiny disk between two big ones: a cell of two edges, its vertices opposite orientations.
TEST(OracleByHand, TrappedDisk) {
  const Disks disks{{-50, 0, 49}, {50, 0, 49}, {0, 0, mpq_class(1, 10)}};
  const BruteDiagram diagram = brute_force_diagram(rounded(disks), oracle::rounded(kContainer));
  EXPECT_EQ(diagram.vertices(), (std::set<Triple>{{-1, 0, 1}, {-1, 1, 0}, {0, 1, 2}, {0, 2, 1}}));
  EXPECT_EQ(
      diagram.edges,
      (std::set<Quadruple>{
          {0, 1, 2, -1}, {0, 1, -1, 2}, {0, 2, 1, 1}, {1, 2, 0, 0}, {-1, 1, 0, 0}, {-1, 0, 1, 1}}));
  for (const CotangentClass& c : diagram.classes) {
    if (c.contacts == std::vector<int>{0, 2, 1}) {
      EXPECT_GT(c.circle.y, 0);
    }
    if (c.contacts == std::vector<int>{0, 1, 2}) {
      EXPECT_LT(c.circle.y, 0);
    }
  }
  const CgalDiagram cgal = cgal_diagram(disks, kContainer);
  std::set<Triple> cgal_triples;
  for (const CgalVertex& v : cgal.vertices) cgal_triples.insert(v.generators);
  EXPECT_EQ(cgal_triples, (std::set<Triple>{{0, 1, 2}, {0, 2, 1}}));
  EXPECT_EQ(cgal.edges, (std::set<Quadruple>{{0, 2, 1, 1}, {1, 2, 0, 0}}));
}

// Two trapped disks that exchange places: same vertices, different edges (Configuration W).
TEST(OracleByHand, VerticesAloneDoNotTell) {
  const mpq_class small(1, 10);
  const Disks one{{-50, 0, 49}, {50, 0, 49}, {0, 7, small}, {0, -7, small}};
  const Disks other{one[0], one[1], one[3], one[2]};
  const BruteDiagram a = brute_force_diagram(rounded(one), oracle::rounded(kContainer));
  const BruteDiagram b = brute_force_diagram(rounded(other), oracle::rounded(kContainer));
  EXPECT_EQ(a.vertices(), b.vertices());
  EXPECT_NE(a.edges, b.edges);
  EXPECT_TRUE(agrees(a, edges_of(a), nullptr));
  EXPECT_FALSE(agrees(a, edges_of(b), nullptr));
  EXPECT_TRUE(agrees_with_cgal(one, kContainer, edges_of(a), nullptr));
  EXPECT_FALSE(agrees_with_cgal(one, kContainer, edges_of(b), nullptr));
}

TEST(OracleByHand, SquareIsOneCotangentClass) {
  const Disks disks{{10, 0, 1}, {0, 10, 1}, {-10, 0, 1}, {0, -10, 1}};
  const BruteDiagram diagram = brute_force_diagram(rounded(disks), oracle::rounded(kContainer));
  EXPECT_TRUE(diagram.degenerate);
  const bool found = std::any_of(diagram.classes.begin(), diagram.classes.end(), [](const auto& c) {
    return c.contacts == std::vector<int>{0, 1, 2, 3} && abs(c.circle.radius - 9) < 1e-90;
  });
  EXPECT_TRUE(found);
  // Either diagonal, but nothing else.
  const std::vector<Quadruple> outside{{-1, 0, 1, 3}, {-1, 1, 2, 0}, {-1, 2, 3, 1}, {-1, 3, 0, 2}};
  const auto with = [&](std::vector<Quadruple> edges) {
    edges.insert(edges.end(), outside.begin(), outside.end());
    for (Quadruple& e : edges) e = canonical(e);
    return edges;
  };
  ASSERT_EQ(diagram.links.size(), 8u);
  const auto first =
      with({{1, 0, 2, -1}, {2, 1, 0, -1}, {3, 2, 0, -1}, {0, 3, 2, -1}, {0, 2, 1, 3}});
  const auto second =
      with({{1, 0, 3, -1}, {2, 1, 3, -1}, {3, 2, 1, -1}, {0, 3, 1, -1}, {1, 3, 2, 0}});
  const auto mixed =
      with({{1, 0, 2, -1}, {2, 1, 0, -1}, {3, 2, 1, -1}, {0, 3, 1, -1}, {0, 2, 1, 3}});
  std::string why;
  for (const auto& edges : {first, second}) {
    EXPECT_TRUE(agrees(diagram, edges, &why)) << why;
    EXPECT_TRUE(agrees_with_cgal(disks, kContainer, edges, &why)) << why;
  }
  EXPECT_FALSE(agrees(diagram, mixed, nullptr));
}

// The same square with one disk moved outwards by less than any double notices, or by so little
// that it counts as cotangent.
TEST(OracleByHand, NearlyCotangent) {
  for (const std::size_t digits : {20u, 50u, 55u, 70u}) {
    SCOPED_TRACE(digits);
    mpz_class denominator;
    mpz_ui_pow_ui(denominator.get_mpz_t(), 10, digits);
    const mpq_class shift(1, denominator);
    const Disks disks{{10 + shift, 0, 1}, {0, 10, 1}, {-10, 0, 1}, {0, -10, 1}};
    const BruteDiagram diagram = brute_force_diagram(rounded(disks), oracle::rounded(kContainer));
    EXPECT_EQ(diagram.degenerate, digits == 70);
    // Disk 0 is the farthest from the circle of the other three: the diagonal joins 1 and 3.
    const std::vector<Quadruple> edges{{1, 0, 3, -1}, {2, 1, 3, -1}, {3, 2, 1, -1},
                                       {0, 3, 1, -1}, {1, 3, 2, 0},  {-1, 0, 1, 3},
                                       {-1, 1, 2, 0}, {-1, 2, 3, 1}, {-1, 3, 0, 2}};
    std::string why;
    EXPECT_TRUE(agrees(diagram, edges, &why)) << why;
    EXPECT_TRUE(agrees_with_cgal(disks, kContainer, edges, &why)) << why;
  }
}

TEST(OracleByHand, RejectsImpossibleInput) {
  const Circle container{0, 0, 10};
  EXPECT_THROW(brute_force_diagram({{0, 0, 1}, {1, 0, 1}}, container), std::invalid_argument);
  EXPECT_THROW(brute_force_diagram({{0, 0, 1}, {1, 0, 0}}, container), std::invalid_argument);
  EXPECT_THROW(brute_force_diagram({{0, 0, 1}, {9, 0, 2}}, container), std::invalid_argument);
  EXPECT_THROW(brute_force_diagram({{0, 0, -1}, {5, 0, 1}}, container), std::invalid_argument);
  EXPECT_THROW(brute_force_diagram({{0, 0, 1}, {5, 0, 1}}, {0, 0, 0}), std::invalid_argument);
  EXPECT_NO_THROW(brute_force_diagram({{0, 0, 1}, {2, 0, 1}, {9, 0, 1}}, container));
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

// ---- Motion ----

using Number = MotionOracle::Number;

MovingDisk moving(mpq_class x, mpq_class y, mpq_class vx, mpq_class vy, mpq_class r, mpq_class m) {
  return {std::move(x), std::move(y), std::move(vx), std::move(vy), std::move(r), std::move(m)};
}

TEST(Motion, CollisionByHand) {
  // Restitution 1/2, masses 1 and 2: velocities 3 and 0 become 0 and 3/2.
  MotionScene scene{kContainer, 1, WallLaw::normal, mpq_class(1, 2), {}};
  scene.disks = {moving(0, 0, 3, 0, 1, 1), moving(11, 0, 0, 0, 1, 2)};
  const MotionOracle motion(scene, {collision(1, 0)});
  EXPECT_EQ(motion.times()[0], 3);
  EXPECT_EQ(motion.nearest_double(0), 3.0);
  EXPECT_LT(abs(motion.velocity(0, 3)[0]), 1e-290);
  EXPECT_LT(abs(motion.velocity(1, 3)[0] - 1.5), 1e-290);
  EXPECT_EQ(motion.velocity(0, Number(2.5))[0], 3);
  EXPECT_LT(abs(motion.position(1, 5)[0] - 14), 1e-290);
}

// A glancing contact at an irrational time: (10 - t)^2 + 1 = 4.
TEST(Motion, IrrationalTime) {
  MotionScene scene{kContainer, 1, WallLaw::normal, 1, {}};
  scene.disks = {moving(0, 0, 1, 0, 1, 1), moving(10, 1, 0, 0, 1, 1)};
  const MotionOracle motion(scene, {collision(0, 1)});
  EXPECT_LT(abs(motion.times()[0] - (10 - sqrt(Number(3)))), 1e-290);
  // Equal masses exchange the components along n = (sqrt 3, 1) / 2.
  const auto v = motion.velocity(1, motion.times()[0]);
  EXPECT_LT(abs(v[0] - 0.75), 1e-290);
  EXPECT_LT(abs(v[1] - sqrt(Number(3)) / 4), 1e-290);
}

TEST(Motion, WallLaws) {
  // From (0, 3) along x in a circle of radius 5 + 1: contact at x = 4, n = (4, 3).
  MotionScene scene{{0, 0, 6}, mpq_class(1, 2), WallLaw::normal, 1, {moving(0, 3, 1, 0, 1, 1)}};
  const MotionOracle normal(scene, {collision(-1, 0)});
  EXPECT_EQ(normal.times()[0], 4);
  EXPECT_LT(abs(normal.velocity(0, 4)[0] - Number(1) / 25), 1e-290);   // 1 - 1.5 * 16/25
  EXPECT_LT(abs(normal.velocity(0, 4)[1] + Number(18) / 25), 1e-290);  // -1.5 * 12/25
  scene.wall_law = WallLaw::whole;
  const MotionOracle whole(scene, {collision(0, -1)});
  EXPECT_LT(abs(whole.velocity(0, 4)[0] + Number(7) / 50), 1e-290);   // (1 - 2 * 16/25) / 2
  EXPECT_LT(abs(whole.velocity(0, 4)[1] + Number(24) / 50), 1e-290);  // (-2 * 12/25) / 2
}

TEST(Motion, ManeuversAndMissedContacts) {
  MotionScene scene{{0, 0, 100}, 1, WallLaw::normal, 1, {}};
  scene.disks = {moving(0, 0, 0, 0, 1, 1), moving(10, 0, 0, 1, 1, 1)};
  const std::vector<MotionRecord> turn{maneuver(1, 2, -1, 0), maneuver(1, 3, -1, -2)};
  const MotionOracle free(scene, turn);
  EXPECT_EQ(free.times()[1], 3);
  EXPECT_EQ(free.position(1, Number(2.5))[0], 9.5);
  EXPECT_EQ(free.position(1, 4)[1], 0);
  // At t = 4 disk 1 is at (8, 0), below the axis from then on; it passes disk 0 at a distance
  // of 8 * 2 / sqrt 5 and leaves the container, of radius 99 for centres, at
  // (8 - s)^2 + 4 s^2 = 99^2.
  EXPECT_FALSE(free.first_missed_contact(0, 40).has_value());
  const auto exit = free.first_missed_contact(0, 60);
  ASSERT_TRUE(exit.has_value());
  EXPECT_EQ(exit->i, -1);
  EXPECT_EQ(exit->j, 1);
  const Number s = (8 + sqrt(Number(64) + 5 * (99 * 99 - 64))) / 5;
  EXPECT_LT(abs(exit->t - (4 + s)), 1e-90);

  // Straight on along y = 2, or aimed at disk 0.
  const MotionOracle aimed(scene, {maneuver(1, 2, -5, -1)});
  const auto hit = aimed.first_missed_contact(0, 20);
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->i, 0);
  EXPECT_EQ(hit->j, 1);
  const MotionOracle collided(scene, {maneuver(1, 2, -5, -1), collision(0, 1)});
  EXPECT_LT(abs(collided.times()[1] - hit->t), 1e-90);
  EXPECT_FALSE(collided.first_missed_contact(0, 20).has_value());
  // The disk then flies on through the wall: that comes later.
  EXPECT_EQ(aimed.first_missed_contact(0, 60)->i, 0);
  EXPECT_EQ(aimed.first_missed_contact(10, 60)->i, -1);
  // Where the interval begins with an overlap, that is the first instant.
  EXPECT_EQ(free.first_missed_contact(55, 60)->t, 55);
  const MotionOracle back(scene, {turn[0], turn[1], maneuver(1, 55, 1, 2)});
  EXPECT_EQ(back.first_missed_contact(56, 80)->t, 56);
  EXPECT_FALSE(back.first_missed_contact(80, 90).has_value());
  EXPECT_EQ(aimed.first_missed_contact(hit->t + 0.1, 20)->t, hit->t + 0.1);
}

TEST(Motion, RefusesImpossibleRecords) {
  MotionScene scene{{0, 0, 100}, 1, WallLaw::normal, 1, {}};
  scene.disks = {moving(0, 0, 0, 0, 1, 1), moving(10, 0, 1, 0, 1, 1)};
  EXPECT_THROW(MotionOracle(scene, {collision(0, 1)}), std::invalid_argument);
  EXPECT_THROW(MotionOracle(scene, {collision(-1, 0)}), std::invalid_argument);
  EXPECT_THROW(MotionOracle(scene, {collision(0, 2)}), std::invalid_argument);
  EXPECT_THROW(MotionOracle(scene, {collision(1, 1)}), std::invalid_argument);
  EXPECT_THROW(MotionOracle(scene, {maneuver(0, 2, 1, 1), maneuver(0, 1, 1, 1)}),
               std::invalid_argument);
  // Through the wall, or through disk 0, and only then into it.
  EXPECT_THROW(MotionOracle(scene, {maneuver(1, 95, 1, 0), collision(-1, 1)}),
               std::invalid_argument);
  EXPECT_THROW(MotionOracle(scene, {maneuver(1, 0, -1, 0), maneuver(1, 9, -1, 0), collision(0, 1)}),
               std::invalid_argument);
}

// An event-driven simulation in double: who collides with whom, and about when.
std::vector<MotionRecord> simulate(const MotionScene& scene, double horizon,
                                   std::vector<double>* times) {
  struct Body {
    double x, y, vx, vy, r, m;
  };
  std::vector<Body> bodies;
  for (const MovingDisk& d : scene.disks) {
    bodies.push_back(
        {d.x.get_d(), d.y.get_d(), d.vx.get_d(), d.vy.get_d(), d.radius.get_d(), d.mass.get_d()});
  }
  const double wall = scene.container.radius.get_d();
  std::vector<MotionRecord> records;
  for (double now = 0;;) {
    double wait = horizon - now;
    int first = -2, second = -2;
    const int n = static_cast<int>(bodies.size());
    for (int j = 0; j < n; ++j) {
      const Body& b = bodies[static_cast<std::size_t>(j)];
      const double p = b.x * b.vx + b.y * b.vy, q = b.vx * b.vx + b.vy * b.vy;
      const double out =
          (std::sqrt(p * p - q * (b.x * b.x + b.y * b.y - (wall - b.r) * (wall - b.r))) - p) / q;
      if (p + q * out > 0 && out < wait) wait = out, first = -1, second = j;
      for (int i = 0; i < j; ++i) {
        const Body& a = bodies[static_cast<std::size_t>(i)];
        const double dx = b.x - a.x, dy = b.y - a.y, wx = b.vx - a.vx, wy = b.vy - a.vy;
        const double f = dx * wx + dy * wy, g = wx * wx + wy * wy;
        const double disc = f * f - g * (dx * dx + dy * dy - (a.r + b.r) * (a.r + b.r));
        if (f >= 0 || disc <= 0) continue;
        const double meet = (-f - std::sqrt(disc)) / g;
        if (meet < wait) wait = meet, first = i, second = j;
      }
    }
    if (first == -2) return records;
    now += wait;
    for (Body& b : bodies) b.x += wait * b.vx, b.y += wait * b.vy;
    Body& b = bodies[static_cast<std::size_t>(second)];
    if (first < 0) {
      const double k = 2 * (b.vx * b.x + b.vy * b.y) / (b.x * b.x + b.y * b.y);
      b.vx -= k * b.x, b.vy -= k * b.y;
    } else {
      Body& a = bodies[static_cast<std::size_t>(first)];
      const double nx = b.x - a.x, ny = b.y - a.y;
      const double k =
          2 * ((b.vx - a.vx) * nx + (b.vy - a.vy) * ny) / (nx * nx + ny * ny) / (a.m + b.m);
      a.vx += k * b.m * nx, a.vy += k * b.m * ny;
      b.vx -= k * a.m * nx, b.vy -= k * a.m * ny;
    }
    records.push_back(collision(first, second));
    times->push_back(now);
  }
}

MotionScene gas(Random& random, int n) {
  MotionScene scene{kContainer, 1, WallLaw::normal, 1, {}};
  for (const ExactCircle& d : thrown(random, n, [&] { return uniform(random, 10, 40); })) {
    scene.disks.push_back(moving(d.x, d.y, uniform(random, -10, 10), uniform(random, -10, 10),
                                 d.radius, d.radius * d.radius));
  }
  return scene;
}

TEST(Motion, RandomGas) {
  Random random(11);
  const MotionScene scene = gas(random, 8);
  std::vector<double> times;
  const std::vector<MotionRecord> records = simulate(scene, 60, &times);
  ASSERT_GT(records.size(), 30u);
  const MotionOracle motion(scene, records);
  const BasicMotionOracle<1000> finer(scene, records);

  ASSERT_EQ(motion.times().size(), records.size());
  EXPECT_TRUE(std::is_sorted(motion.times().begin(), motion.times().end()));
  for (std::size_t k = 0; k < records.size(); ++k) {
    EXPECT_NEAR(motion.nearest_double(k), times[k], 1e-3);
    EXPECT_EQ(motion.nearest_double(k), finer.nearest_double(k));
    EXPECT_LT(abs(BasicMotionOracle<1000>::Number(motion.times()[k]) - finer.times()[k]), 1e-150);
  }
  EXPECT_FALSE(motion.first_missed_contact(0, 60).has_value());

  const auto energy = [&](const Number& t) {
    Number sum = 0;
    for (std::size_t i = 0; i < scene.disks.size(); ++i) {
      const auto v = motion.velocity(static_cast<int>(i), t);
      sum += oracle::rounded<Number>(scene.disks[i].mass) * (v[0] * v[0] + v[1] * v[1]);
    }
    return sum;
  };
  EXPECT_LT(abs(energy(60) / energy(0) - 1), 1e-280);

  // Without any one of the records the rest is refused, or a contact is missing.
  for (std::size_t k = 0; k < records.size(); ++k) {
    std::vector<MotionRecord> fewer = records;
    fewer.erase(fewer.begin() + static_cast<long>(k));
    try {
      EXPECT_TRUE(MotionOracle(scene, fewer).first_missed_contact(0, 60).has_value());
    } catch (const std::invalid_argument&) {
    }
  }
}

// The exact value of a high-precision number.
mpq_class exact(const Real& x) {
  mpq_class q;
  mpfr_get_q(q.get_mpq_t(), x.backend().data());
  return q;
}

// The diagrams between the events of a motion, by both diagram oracles.
TEST(Motion, DiagramsBetweenEvents) {
  Random random(12);
  const MotionScene scene = gas(random, 7);
  std::vector<double> times;
  const MotionOracle motion(scene, simulate(scene, 60, &times));
  ASSERT_GT(motion.times().size(), 15u);
  std::set<std::set<Quadruple>> seen;
  for (std::size_t k = 0; k + 1 < motion.times().size(); ++k) {
    const Number middle = (motion.times()[k] + motion.times()[k + 1]) / 2;
    const std::vector<Circle> disks = motion.disks_at(middle);
    const BruteDiagram truth = brute_force_diagram(disks, oracle::rounded(kContainer));
    Disks rational;
    for (const Circle& d : disks) rational.push_back({exact(d.x), exact(d.y), exact(d.radius)});
    std::string why;
    EXPECT_TRUE(agrees_with_cgal(rational, kContainer, edges_of(truth), &why)) << why;
    seen.insert(truth.edges);
  }
  EXPECT_GT(seen.size(), 3u);
}

}  // namespace
}  // namespace voroproof::oracle
