// The oracles of diagrams against cases worked out by hand.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/oracle/brute_force.h"
#include "tests/oracle/cgal_apollonius.h"
#include "tests/oracle/scenes.h"

namespace voroproof::oracle {
namespace {

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

}  // namespace
}  // namespace voroproof::oracle
