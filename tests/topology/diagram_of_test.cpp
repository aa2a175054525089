// Quads that are not those of a diagram are refused, with the reason.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "exact/topology/diagram.h"

namespace voroproof::internal {
namespace {

using Quads = std::vector<Quad>;

// The reason for which the quads are refused; empty if they are not.
std::string refusal(int disks, const Quads& quads) {
  try {
    diagram_of(disks, quads);
    return "";
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
}

Quads three_disks() {
  Diagram d(3);
  d.start(0, 1);
  d.insert_in_edge(0, 2);
  return d.quads();
}

// The edges of a triangulation, given by its oriented triangles, each oriented edge in one.
Quads quads_of(const std::vector<Triple>& triangles) {
  const auto apex = [&](GenId a, GenId b) -> GenId {
    for (const Triple& t : triangles) {
      for (int k = 0; k < 3; ++k) {
        if (t[k] == a && t[(k + 1) % 3] == b) return t[(k + 2) % 3];
      }
    }
    throw std::logic_error("an edge on the border");
  };
  Quads quads;
  for (const Triple& t : triangles) {
    for (int k = 0; k < 3; ++k) {
      const GenId a = t[k], b = t[(k + 1) % 3];
      if (a < b) quads.push_back({a, b, apex(b, a), apex(a, b)});
    }
  }
  return quads;
}

TEST(DiagramOf, RefusesWhatIsNoSphere) {
  const Quads good = three_disks();
  EXPECT_EQ(refusal(3, good), "");

  EXPECT_EQ(refusal(3, {}), "wrong number of edges");
  EXPECT_EQ(refusal(4, good), "wrong number of edges");  // a generator is missing
  EXPECT_EQ(refusal(2, good), "there is no generator 2");
  EXPECT_EQ(refusal(1, {{-1, 0, 0, 0}}).substr(0, 6), "vertex");
  EXPECT_EQ(refusal(3, {{-2, 0, 1, 1}}), "there is no generator -2");
  EXPECT_EQ(refusal(0, {{-1, -1, -1, -1}}), "an edge has one generator on both sides");

  Quads twice = good;
  twice.push_back(good.front());
  EXPECT_NE(refusal(3, twice).find("is named by two edges on one side"), std::string::npos);
  Quads one_short = good;
  one_short.pop_back();
  EXPECT_NE(refusal(3, one_short).find("lacks an edge between"), std::string::npos);
  // Whichever edge is missing is named, from one of its two sides.
  for (std::size_t k = 0; k < good.size(); ++k) {
    Quads few = good;
    few.erase(few.begin() + static_cast<std::ptrdiff_t>(k));
    const auto named = [&](GenId a, GenId b) {
      const std::string end = " between " + std::to_string(a) + " and " + std::to_string(b);
      return refusal(3, few).ends_with(end);
    };
    EXPECT_TRUE(named(good[k].l, good[k].r) || named(good[k].r, good[k].l)) << refusal(3, few);
  }
}

// A sphere on which an edge returns to the generator where it starts: a cell would be its own
// neighbour.
TEST(DiagramOf, RefusesLoops) {
  const Quads loop{{-1, -1, 1, 0}, {-1, 0, -1, -1}, {-1, 1, -1, -1}};
  EXPECT_EQ(refusal(2, loop), "an edge has one generator on both sides");
}

// Seven generators, each a neighbour of each other: the triangulation of the torus by Moebius
// and Csaszar. With a sphere of three generators the count of edges is that of a sphere.
std::vector<Triple> torus(GenId first) {
  std::vector<Triple> triangles;
  for (int k = 0; k < 7; ++k) {
    const auto g = [&](int i) { return first + (k + i) % 7; };
    triangles.push_back({g(0), g(1), g(3)});
    triangles.push_back({g(0), g(3), g(2)});
  }
  return triangles;
}

TEST(DiagramOf, RefusesATorus) {
  const Quads quads = quads_of(torus(-1));
  ASSERT_EQ(quads.size(), 21u);
  EXPECT_EQ(refusal(6, quads), "wrong number of edges");
}

TEST(DiagramOf, RefusesASphereAndATorusApart) {
  Quads quads = quads_of(torus(2));
  for (const Quad& q : Quads{{-1, 0, 1, 1}, {-1, 1, 0, 0}, {0, 1, -1, -1}}) quads.push_back(q);
  ASSERT_EQ(quads.size(), 24u);  // 3 * 10 - 6
  EXPECT_EQ(refusal(9, quads), "the edges do not hang together");
}

// A torus and two spheres that touch it, each in one generator, with the right count of edges:
// the edges of these two form two rings.
TEST(DiagramOf, RefusesTwoRings) {
  Quads quads = quads_of(torus(-1));
  for (const Quad& q : Quads{{0, 6, 7, 7}, {0, 7, 6, 6}, {6, 7, 0, 0}}) quads.push_back(q);
  for (const Quad& q : Quads{{1, 8, 9, 9}, {1, 9, 8, 8}, {8, 9, 1, 1}}) quads.push_back(q);
  ASSERT_EQ(quads.size(), 27u);  // 3 * 11 - 6
  EXPECT_NE(refusal(10, quads).find("do not form one ring"), std::string::npos);
}

// One number of one quad changed: never the same diagram, and nearly always none.
RC_GTEST_PROP(DiagramOfProperty, AChangedQuadIsRefusedOrAnotherDiagram, ()) {
  const int disks = *rc::gen::inRange(2, 8);
  Diagram d(disks);
  d.start(0, 1);
  for (GenId g = 2; g < disks; ++g) d.insert_in_edge(*rc::gen::inRange(0, 2 * d.edges()), g);
  for (const int h : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 1000))) {
    const Quad q = d.quad(h % (2 * d.edges()));
    if (q.s != q.e) d.flip(h % (2 * d.edges()));
  }
  const Quads quads = d.quads();
  Quads changed = quads;
  Quad& q = changed[*rc::gen::inRange<std::size_t>(0, changed.size())];
  GenId* const ids[4] = {&q.l, &q.r, &q.s, &q.e};
  GenId& id = *ids[*rc::gen::inRange(0, 4)];
  id = *rc::gen::distinctFrom(rc::gen::inRange(-2, disks + 1), id);
  RC_ASSERT(refusal(disks, changed) != "");
}

}  // namespace
}  // namespace voroproof::internal
