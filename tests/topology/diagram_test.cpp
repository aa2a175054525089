// The diagram as incidences: construction, flips, the walk around a generator.
#include "exact/topology/diagram.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace voroproof::internal {
namespace {

using Quads = std::vector<Quad>;

Diagram two_disks() {
  Diagram d(2);
  d.start(0, 1);
  return d;
}

// Generators inserted one after the other into edges chosen by `choices`.
Diagram grown(int disks, const std::vector<int>& choices) {
  Diagram d(disks);
  d.start(0, 1);
  for (GenId g = 2; g < disks; ++g) {
    const int choice = choices[static_cast<std::size_t>(g - 2) % choices.size()];
    d.insert_in_edge(choice % (2 * d.edges()), g);
  }
  return d;
}

bool can_flip(const Diagram& d, Diagram::HalfEdge h) {
  const Quad q = d.quad(h);
  return q.s != q.e;
}

// What is_valid does not look at: the accessors agree with each other and every half-edge is
// met exactly once on the walks around the generators.
void expect_consistent(const Diagram& d) {
  std::string why;
  ASSERT_TRUE(d.is_valid(&why)) << why;
  std::set<Diagram::HalfEdge> met;
  for (GenId g = container_id; g < d.disks(); ++g) {
    const Diagram::HalfEdge first = d.anchor(g);
    Diagram::HalfEdge h = first;
    do {
      ASSERT_EQ(d.org(h), g);
      ASSERT_TRUE(met.insert(h).second) << "met twice: " << h;
      // Counterclockwise: the triangle left of an edge is right of the next.
      ASSERT_EQ(d.apex(h), d.dest(d.rotate(h)));
      ASSERT_EQ(d.apex(Diagram::twin(d.rotate(h))), d.dest(h));
      h = d.rotate(h);
    } while (h != first);
  }
  EXPECT_EQ(static_cast<int>(met.size()), 2 * d.edges());
  for (Diagram::HalfEdge h = 0; h < 2 * d.edges(); ++h) {
    EXPECT_EQ(d.next(d.previous(h)), h);
    EXPECT_EQ(d.previous(d.next(h)), h);
    EXPECT_TRUE(names_an_edge(d.quad(h)));
    EXPECT_EQ(d.quad(Diagram::twin(h)), reversed(d.quad(h)));
    // All edges of one vertex agree on its name.
    EXPECT_EQ(end_vertex(d.quad(h)), end_vertex(d.quad(d.next(h))));
  }
}

TEST(Diagram, NoEdgesForFewerThanTwoDisks) {
  for (const int disks : {0, 1}) {
    EXPECT_TRUE(Diagram(disks).is_valid());
    EXPECT_EQ(Diagram(disks).edges(), 0);
    EXPECT_EQ(Diagram(disks).anchor(container_id), -1);
    EXPECT_EQ(diagram_of(disks, {}).edges(), 0);
  }
  std::string why;
  EXPECT_FALSE(Diagram(2).is_valid(&why));
  EXPECT_EQ(why, "wrong number of edges");
}

// Three edges between the two tangent circles; nothing can flip.
TEST(Diagram, TwoDisksHaveOneDiagram) {
  const Diagram d = two_disks();
  expect_consistent(d);
  EXPECT_EQ(d.quads(), (Quads{{-1, 0, 1, 1}, {-1, 1, 0, 0}, {0, 1, -1, -1}}));
  Diagram other(2);
  other.start(1, 0);
  EXPECT_EQ(other.quads(), d.quads());
  for (Diagram::HalfEdge h = 0; h < 6; ++h) EXPECT_FALSE(can_flip(d, h));
  EXPECT_EQ(diagram_of(2, d.quads()).quads(), d.quads());
}

std::vector<GenId> sorted(const Triple& v) {
  std::vector<GenId> all(v.begin(), v.end());
  std::sort(all.begin(), all.end());
  return all;
}

TEST(Diagram, InsertionIsWhatItsCommentSays) {
  for (Diagram::HalfEdge h = 0; h < 6; ++h) {
    Diagram d(3);
    d.start(0, 1);
    const Quad old = d.quad(h);
    const auto [first, second] = d.insert_in_edge(h, 2);
    expect_consistent(d);
    EXPECT_EQ(d.quad(first), (Quad{old.l, old.r, old.s, 2}));
    EXPECT_EQ(d.quad(second), (Quad{old.l, old.r, 2, old.e}));
    // The new cell has two edges, with l and r.
    const Diagram::HalfEdge a = d.anchor(2), b = d.rotate(a);
    EXPECT_NE(a, b);
    EXPECT_EQ(d.rotate(b), a);
    EXPECT_EQ((std::set<GenId>{d.dest(a), d.dest(b)}), (std::set<GenId>{old.l, old.r}));
  }
}

// A cell in the place of a vertex is one on an edge of it that has grown over the vertex.
TEST(Diagram, InsertionInAVertexIsAFlipAwayFromThatInAnEdge) {
  Diagram three(3);
  three.start(0, 1);
  three.insert_in_edge(0, 2);
  for (Diagram::HalfEdge h = 0; h < 2 * three.edges(); ++h) {
    Diagram larger(4), other(4);
    for (Diagram* d : {&larger, &other}) {
      d->start(0, 1);
      d->insert_in_edge(0, 2);
    }
    const Triple vertex = end_vertex(larger.quad(h));
    const Diagram::HalfEdge sides[3] = {h, larger.next(h), larger.previous(h)};
    Quad before[3];
    for (int k = 0; k < 3; ++k) before[k] = larger.quad(sides[k]);
    larger.insert_in_vertex(h, 3);
    expect_consistent(larger);
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(larger.apex(sides[k]), 3);
      EXPECT_EQ(larger.org(sides[k]), before[k].l);
      EXPECT_EQ(larger.dest(sides[k]), before[k].r);
    }
    EXPECT_EQ(larger.neighbours(3), sorted(vertex));
    // The part of the edge that keeps its number is on the side of the vertex.
    const auto parts = other.insert_in_edge(h, 3);
    EXPECT_EQ(other.apex(parts[1]), before[0].e);
    // Its cell grows to the vertex by one flip of the other edges' common one.
    const Diagram::HalfEdge gone = Diagram::twin(parts[1]);
    ASSERT_EQ(other.apex(gone), 3);
    other.flip(gone);
    EXPECT_EQ(other.quads(), larger.quads());
  }
}

// With four generators there are eight diagrams: two in which all pairs of cells are neighbours,
// mirror images of each other, and six in which two cells have two edges in common and the
// other two cells have two edges each. Every flip leads from one kind to the other.
TEST(Diagram, ThreeDisksHaveEightDiagrams) {
  Diagram d(3);
  d.start(0, 1);
  d.insert_in_edge(0, 2);
  std::map<Quads, std::set<Quads>> neighbours;
  std::vector<Diagram> todo{d};
  while (!todo.empty()) {
    const Diagram at = todo.back();
    todo.pop_back();
    if (neighbours.contains(at.quads())) continue;
    expect_consistent(at);
    EXPECT_EQ(diagram_of(3, at.quads()).quads(), at.quads());
    auto& next = neighbours[at.quads()];
    for (Diagram::HalfEdge h = 0; h < 12; h += 2) {
      if (!can_flip(at, h)) continue;
      Diagram flipped_at = at;
      flipped_at.flip(h);
      next.insert(flipped_at.quads());
      todo.push_back(flipped_at);
    }
  }
  ASSERT_EQ(neighbours.size(), 8u);
  std::map<std::size_t, int> by_flips;
  for (const auto& [quads, next] : neighbours) {
    ++by_flips[next.size()];
    for (const Quads& other : next) {
      EXPECT_TRUE(neighbours.at(other).contains(quads));  // a flip can be taken back
      EXPECT_NE(neighbours.at(other).size(), next.size());
    }
  }
  EXPECT_EQ(by_flips, (std::map<std::size_t, int>{{6, 2}, {2, 6}}));
}

TEST(Diagram, AFlipReplacesTheQuadruplet) {
  Diagram d = grown(4, {0, 3});
  int flips = 0;
  for (Diagram::HalfEdge h = 0; h < 2 * d.edges(); ++h) {
    if (!can_flip(d, h)) continue;
    ++flips;
    Diagram after = d;
    after.flip(h);
    expect_consistent(after);
    EXPECT_EQ(after.quad(h), flipped(d.quad(h)));
    // Edges that are not around the flipped one keep their names.
    const std::set<int> around{h / 2, d.next(h) / 2, d.previous(h) / 2, d.next(h ^ 1) / 2,
                               d.previous(h ^ 1) / 2};
    for (int e = 0; e < d.edges(); ++e) {
      if (!around.contains(e)) {
        EXPECT_EQ(after.quad(2 * e), d.quad(2 * e));
      }
    }
  }
  EXPECT_GT(flips, 0);
}

RC_GTEST_PROP(DiagramProperty, FlippingTwiceRestores, ()) {
  const int disks = *rc::gen::inRange(3, 12);
  const auto choices = *rc::gen::container<std::vector<int>>(20, rc::gen::inRange(0, 1000));
  Diagram d = grown(disks, choices);
  for (const int choice : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 1000))) {
    const Diagram::HalfEdge h = choice % (2 * d.edges());
    if (!can_flip(d, h)) continue;
    const Quads before = d.quads();
    const Quad q = d.quad(h);
    d.flip(h);
    RC_ASSERT(d.is_valid());
    RC_ASSERT(d.quads() != before);
    Diagram back = d;
    back.flip(h);
    RC_ASSERT(back.is_valid());
    RC_ASSERT(back.quads() == before);
    // The half-edge has made half a turn.
    RC_ASSERT(back.quad(h) == reversed(q));
  }
  expect_consistent(d);
}

RC_GTEST_PROP(DiagramProperty, QuadsTellTheDiagram, ()) {
  const int disks = *rc::gen::inRange(2, 12);
  const auto choices = *rc::gen::container<std::vector<int>>(20, rc::gen::inRange(0, 1000));
  Diagram d = grown(disks, choices);
  for (const int choice : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 1000))) {
    const Diagram::HalfEdge h = choice % (2 * d.edges());
    if (can_flip(d, h)) d.flip(h);
  }
  Quads quads = d.quads();
  RC_ASSERT(std::is_sorted(quads.begin(), quads.end()));
  // Any order and either direction of walking an edge will do.
  for (std::size_t k = 0; k < quads.size(); ++k) {
    std::swap(quads[k], quads[static_cast<std::size_t>(choices[k % 20]) % quads.size()]);
    if (choices[k % 20] % 2 == 0) quads[k] = reversed(quads[k]);
  }
  const Diagram again = diagram_of(disks, quads);
  expect_consistent(again);
  RC_ASSERT(again.quads() == d.quads());
}

}  // namespace
}  // namespace voroproof::internal
