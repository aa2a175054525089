// A history taken at its word: the diagram and its edges by name, and claims that make no sense.
#include "certify/replay.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <variant>
#include <vector>

#include "tests/certify/begun_replay.h"
#include "tests/certify/claimed_history.h"
#include "tests/support/lattice_scene.h"

namespace voroproof::internal::testing {
namespace {

// ---- The diagram ----

TEST(Replay, OfNoDisk) {
  const Begun b(scene_of(10, 1, {}));
  EXPECT_EQ(b.replay.disks(), 0);
  EXPECT_EQ(b.replay.find({0, 1, 2, 3}), -1);
  EXPECT_EQ(b.replay.next_maneuver(), 0u);
}

// One disk has no diagram, but a contact with the container to watch.
TEST(Replay, OfOneDisk) {
  Begun b(scene_of(10, 20, {disk(0, 0, 1, 1, 0)}));
  EXPECT_EQ(b.replay.disks(), 1);
  EXPECT_EQ(b.replay.adjacency(container_id, 0), 0);
  EXPECT_EQ(b.replay.pair_of(0), std::pair(container_id, 0));
  EXPECT_EQ(b.replay.find({container_id, 0, 0, 0}), -1);
  EXPECT_EQ(b.replay.find_mirrored({container_id, 0, 1, 2}), -1);
  EXPECT_TRUE(b.replay.take(FlipEvent{1, {container_id, 0, 1, 2}}).is_none());
  b.replay.prefetch(FlipEvent{1, {container_id, 0, 1, 2}});
  const auto place = b.replay.take(collision(9, container_id, 0, {}, {-1, 0}));
  ASSERT_FALSE(place.is_none());
  EXPECT_EQ(place.half, -1);
  EXPECT_EQ(place.turns, container_id);
  EXPECT_EQ(b.replay.path(0).at(11), (ExactVec2{7, 0}));
}

// Every edge has the same third generator on both sides, and none can flip.
TEST(Replay, OfTwoDisks) {
  Begun b(scene_of(10, 0, {disk(-3, 0, 1, 0, 0), disk(3, 0, 1, 0, 0)}));
  ASSERT_EQ(b.replay.diagram().edges(), 3);
  for (const Quad& q : {Quad{0, 1, -1, -1}, Quad{-1, 0, 1, 1}, Quad{-1, 1, 0, 0}}) {
    const HalfEdge h = b.replay.find(q);
    ASSERT_GE(h, 0);
    EXPECT_EQ(b.replay.diagram().quad(h), q);
    EXPECT_EQ(b.replay.find(reversed(q)), Diagram::twin(h));
    EXPECT_EQ(b.replay.find_mirrored(q), -1);
    EXPECT_EQ(b.replay.adjacency(q.l, q.r), h / 2);
    const Diagram before = b.replay.diagram();
    EXPECT_TRUE(b.replay.take(FlipEvent{0, q}).is_none());
    EXPECT_EQ(b.replay.diagram(), before);
  }
  EXPECT_EQ(b.replay.find({0, 1, -1, 0}), -1);
}

// Both edges of a pair with the same two others, told from each other by their orientation.
TEST(Replay, ConfigurationI) {
  const Begun b(gap_scene());
  const Quad q{0, 1, -1, 2}, mirrored{0, 1, 2, -1};
  const HalfEdge h = b.replay.find(q), m = b.replay.find(mirrored);
  ASSERT_GE(h, 0);
  ASSERT_GE(m, 0);
  EXPECT_NE(h / 2, m / 2);
  EXPECT_EQ(b.replay.diagram().quad(h), q);
  EXPECT_EQ(b.replay.diagram().quad(m), mirrored);
  EXPECT_EQ(b.replay.find(reversed(q)), Diagram::twin(h));
  EXPECT_EQ(b.replay.find(reversed(mirrored)), Diagram::twin(m));
  EXPECT_EQ(b.replay.find_mirrored(q), m);
  EXPECT_EQ(b.replay.find_mirrored(mirrored), h);
  EXPECT_EQ(find_edge(b.replay.diagram(), q), h);
  const int edge = b.replay.adjacency(0, 1);
  EXPECT_TRUE(edge == h / 2 || edge == m / 2);
}

RC_GTEST_PROP(Replay, FindsTheEdgesThatThereAre, ()) {
  const Begun b(scene_of(*lattice_scenes({})));
  const int n = b.replay.disks();
  RC_PRE(n >= 2 && !b.history.initial.empty());
  const Diagram& d = b.replay.diagram();
  std::set<Quad> names;
  std::set<std::pair<GenId, GenId>> pairs;
  for (HalfEdge h = 0; h < 2 * d.edges(); ++h) {
    const Quad q = d.quad(h);
    names.insert(q);
    pairs.insert({q.l, q.r});
    RC_ASSERT(d.quad(b.replay.find(q)) == q);
    RC_ASSERT(b.replay.pair_of(h / 2) == std::pair(std::min(q.l, q.r), std::max(q.l, q.r)));
  }
  for (GenId j = 0; j < n; ++j) {
    for (GenId i = container_id; i < n; ++i) {
      if (i == j) continue;
      const int edge = b.replay.adjacency(i, j);
      RC_ASSERT((edge >= 0) == pairs.contains({i, j}));
      if (edge >= 0) RC_ASSERT(b.replay.pair_of(edge) == std::pair(std::min(i, j), std::max(i, j)));
      for (GenId s = container_id; s < n; ++s) {
        for (GenId e = container_id; e < n; ++e) {
          const Quad q{i, j, s, e};
          RC_ASSERT((b.replay.find(q) >= 0) == names.contains(q));
          RC_ASSERT((b.replay.find_mirrored(q) >= 0) == (s != e && names.contains({i, j, e, s})));
        }
      }
    }
  }
}

RC_GTEST_PROP(Replay, OfTheEnginesHistoryEndsWithItsDiagram, ()) {
  Begun b(scene_of(*lattice_scenes({.maneuvers = true, .elastic = false})));
  RC_PRE(b.scene.disks.size() >= 2 && b.history.complete());
  // Collisions at t = 0 come before the diagram.
  for (const Claim& claim : claimed_history(b.scene, b.history).events) {
    b.replay.prefetch(claim);
    const auto place = b.replay.take(claim);
    RC_ASSERT(!place.is_none());
    if (const auto* hit = std::get_if<CollideEvent>(&claim)) {
      RC_ASSERT(place.turns == hit->i);
      RC_ASSERT(b.replay.diagram().org(place.half) == hit->j);
    }
    if (const auto* flip = std::get_if<FlipEvent>(&claim)) {
      RC_ASSERT(place.turns == Replay::Place::kNone);
      // The half-edge of the claim has turned.
      RC_ASSERT(b.replay.diagram().quad(place.half) == flipped(flip->quad) ||
                b.replay.diagram().quad(place.half) == reversed(flipped(flip->quad)));
    }
  }
  std::vector<Quad> expected = b.history.final_diagram;
  RC_ASSERT(b.replay.diagram().quads() == expected);
  RC_ASSERT(b.replay.next_maneuver() == b.scene.maneuvers.size());
}

// ---- Nonsense ----

void expect_nothing(Begun& b, const Claim& claim) {
  const Diagram diagram = b.replay.diagram();
  const int changes = b.replay.changes();
  const std::size_t maneuver = b.replay.next_maneuver();
  const ExactPair at = b.replay.positions(0, 1, 100);
  EXPECT_TRUE(b.replay.take(claim).is_none());
  EXPECT_EQ(b.replay.diagram(), diagram);
  EXPECT_EQ(b.replay.changes(), changes);
  EXPECT_EQ(b.replay.next_maneuver(), maneuver);
  EXPECT_EQ(b.replay.positions(0, 1, 100), at);
}

TEST(Replay, TakesNoNonsense) {
  Scene scene = gap_scene();
  scene.maneuvers = {{1, 0, 1, 0}};
  Begun b(scene);
  expect_nothing(b, FlipEvent{1, {0, 1, 2, 2}});
  expect_nothing(b, FlipEvent{1, {0, 2, -1, 1}});  // 1 is on both sides of that edge
  expect_nothing(b, FlipEvent{1, {-1, 2, 0, 1}});  // no neighbours
  expect_nothing(b, ManeuverEvent{1, 1});
  expect_nothing(b, ManeuverEvent{1, 2});
}

// Without velocities, and without a normal or masses to compute them from.
TEST(Replay, TakesNoCollisionThatHasNoResponse) {
  Begun massless(scene_of(10, 9, {disk(-3, 0, 1, 0, 0, 0), disk(3, 0, 1, 0, 0, 0)}));
  expect_nothing(massless, CollideEvent{.t = 1, .i = 0, .j = 1});
  Begun b(scene_of(10, 9, {disk(-3, 0, 1, 1, 0), disk(3, 0, 1, -1, 0)}));
  expect_nothing(b, CollideEvent{.t = 3, .i = 0, .j = 1});  // the centres coincide
  CollideEvent claim{.t = 1, .i = 0, .j = 1};
  claim.p = {Vec2{1, 1}, Vec2{1, 1}};
  expect_nothing(b, claim);
  // At its word where it gives them.
  EXPECT_FALSE(b.replay.take(collision(3, 0, 1, {1, 1}, {2, 2})).is_none());
}

// ---- Without orientation ----

TEST(Replay, TakesTheMirroredEdgeWhereQuadrupletsAreUnoriented) {
  const Scene scene = scene_of(30, 1,
                               {disk(0, 5, 1, 0, 0), disk(5, 0, 1, 0, 0), disk(-5, 0, 1, 0, 0),
                                disk(0, -5, 1, 0, 0), disk(0, 0, 1, 0, 0)});
  Begun oriented(scene);
  CertifyOptions options = recorded();
  options.unoriented = true;
  Begun unoriented(scene, options);
  const Diagram& d = oriented.replay.diagram();
  int tried = 0;
  for (HalfEdge h = 0; h < 2 * d.edges(); ++h) {
    const Quad q = d.quad(h), mirrored{q.l, q.r, q.e, q.s};
    if (q.s == q.e || oriented.replay.find(mirrored) >= 0) continue;
    ++tried;
    expect_nothing(oriented, FlipEvent{0.5, mirrored});
    Replay taken = unoriented.replay;
    const auto place = taken.take(FlipEvent{0.5, mirrored});
    ASSERT_FALSE(place.is_none());
    Replay expected = unoriented.replay;
    ASSERT_FALSE(expected.take(FlipEvent{0.5, q}).is_none());
    EXPECT_EQ(taken.diagram(), expected.diagram());
  }
  EXPECT_GT(tried, 0);
}

// Where the name of one edge is that of another without orientation, the one that collapses then
// is taken.
TEST(Replay, TakesTheEdgeThatCollapsesOfTwoWithOneName) {
  CertifyOptions options = recorded();
  options.unoriented = true;
  const Begun b(gap_scene(), options);
  ASSERT_FALSE(b.history.events.empty());
  ASSERT_EQ(b.history.events[0].kind, Event::Kind::flip);
  const double t = b.history.events[0].t;
  const Quad q = b.history.events[0].edge, mirrored{q.l, q.r, q.e, q.s};
  ASSERT_GE(b.replay.find_mirrored(q), 0);
  Replay by_name = b.replay, by_other_name = b.replay;
  ASSERT_FALSE(by_name.take(FlipEvent{t, q}).is_none());
  ASSERT_FALSE(by_other_name.take(FlipEvent{t, mirrored}).is_none());
  EXPECT_EQ(by_other_name.diagram(), by_name.diagram());
  EXPECT_NE(by_name.diagram(), b.replay.diagram());
  // At its word where orientation counts.
  const Begun strict(gap_scene());
  Replay at_its_word = strict.replay;
  ASSERT_FALSE(at_its_word.take(FlipEvent{t, mirrored}).is_none());
  EXPECT_NE(at_its_word.diagram(), by_name.diagram());
}

}  // namespace
}  // namespace voroproof::internal::testing
