// What makes a set of edges the Voronoi diagram: right diagrams pass, and each condition that a
// wrong one violates is found and named.
#include "certify/initial_proof.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/static_diagram.h"
#include "filtered/computed/computed_motion.h"
#include "history/scene_motion.h"
#include "tests/support/lattice_scene.h"
#include "tests/support/random_scenes.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {
namespace {

using HalfEdge = Diagram::HalfEdge;

// A scene at t = 0.
class Sites {
 public:
  explicit Sites(Scene scene, bool filters = true)
      : scene_(std::move(scene)), motion_(motion_input(scene_), options(filters)) {}

  Motion& motion() { return motion_; }
  int disks() const { return static_cast<int>(scene_.disks.size()); }
  // That of the engine's, not of the certifier's, rooms: at t, and just after.
  Diagram at(const Rational& t) {
    TierCounts counts;
    return static_diagram(motion_, t, counts);
  }
  Diagram just_after(const Rational& t) {
    Diagram d = at(t);
    TierCounts counts;
    settle(d, motion_, Moment::at(t), counts);
    return d;
  }
  std::optional<InitialFault> fault(const Diagram& d, const Rational& t = 0) {
    TierCounts counts;
    return fault(d, t, 1, counts);
  }
  std::optional<InitialFault> fault(const Diagram& d, const Rational& t, int threads,
                                    TierCounts& counts) {
    return initial_fault(d, motion_, t, counts, threads);
  }

 private:
  static MotionOptions options(bool filters) {
    MotionOptions options;
    options.filters = filters;
    return options;
  }
  Scene scene_;
  ComputedMotion motion_;
};

std::string told(const std::optional<InitialFault>& fault) { return fault ? fault->truth : "none"; }

HalfEdge find(const Diagram& d, const Quad& q) {
  for (HalfEdge h = 0; h < 2 * d.edges(); ++h) {
    if (d.quad(h) == q) return h;
  }
  return -1;
}

// The half-edge from one generator to the other, of which there is one.
HalfEdge between(const Diagram& d, GenId l, GenId r) {
  for (HalfEdge h = 0; h < 2 * d.edges(); ++h) {
    if (d.org(h) == l && d.dest(h) == r) return h;
  }
  return -1;
}

// The diagram with every vertex walked the other way round.
Diagram mirrored(const Diagram& d) {
  std::vector<Quad> quads;
  for (const Quad& q : d.quads()) quads.push_back(canonical(Quad{q.r, q.l, q.s, q.e}));
  return diagram_of(d.disks(), quads);
}

std::set<GenId> members(const Quad& q) { return {q.l, q.r, q.s, q.e}; }

Scene square(const Rational& vx, const Rational& vy) {
  return scene_of(
      20, 1,
      {disk(5, 0, 1, vx, 0), disk(0, 5, 1, 0, vy), disk(-5, 0, 1, -vx, 0), disk(0, -5, 1, 0, -vy)});
}

// ---- Right diagrams ----

TEST(InitialProof, TwoDisks) {
  for (const Rational& r : {Rational(1), Rational(3), Rational(1, 7)}) {
    for (const bool filters : {true, false}) {
      Sites s(scene_of(10, 1, {disk(-4, 0, 1, 0, 0), disk(4, 1, r, 0, 0)}), filters);
      const Diagram d = s.just_after(0);
      ASSERT_EQ(d.edges(), 3);
      EXPECT_EQ(told(s.fault(d)), "none");
    }
  }
}

TEST(InitialProof, ThreeDisks) {
  // In general position; of equal radii in a row with the centre of the container; around it.
  for (const std::vector<DiskInput>& disks :
       {std::vector{disk(-4, 1, 1, 0, 0), disk(4, 2, 2, 0, 0), disk(0, -5, 1, 0, 0)},
        std::vector{disk(-4, 0, 1, 0, 0), disk(0, 0, 1, 0, 0), disk(4, 0, 1, 0, 0)},
        std::vector{disk(-3, 0, 2, 0, 0), disk(3, 0, 2, 0, 0), disk(0, 0, Rational(1, 2), 0, 0)}}) {
    for (const bool filters : {true, false}) {
      Sites s(scene_of(10, 1, disks), filters);
      EXPECT_EQ(told(s.fault(s.just_after(0))), "none");
    }
  }
}

TEST(InitialProof, TenDisksOfManyKinds) {
  Random random(3);
  for (const auto& [rmin, rmax] :
       {std::pair(1.0, 9.0), std::pair(4.0, 4.0), std::pair(0.0, 0.0), std::pair(1e-6, 20.0)}) {
    for (int k = 0; k < 5; ++k) {
      const Scene scene = random_scene({.n = 10, .rmin = rmin, .rmax = rmax}, random);
      Sites s(scene), slow(scene, false);
      const Diagram d = s.just_after(0);
      EXPECT_EQ(told(s.fault(d)), "none") << text(scene);
      EXPECT_EQ(told(slow.fault(d)), "none") << text(scene);
      // At another time, that is no binary64, too.
      EXPECT_EQ(told(s.fault(s.just_after(Rational(1, 7)), Rational(1, 7))), "none");
    }
  }
}

// Small integers: touching disks, and cotangent ones that part or stay.
RC_GTEST_PROP(InitialProof, RightDiagramsPass, ()) {
  const Scene scene = scene_of(*lattice_scenes({}));
  RC_PRE(scene.disks.size() >= 2);
  for (const bool filters : {true, false}) {
    Sites s(scene, filters);
    const auto fault = s.fault(s.just_after(0));
    if (fault) RC_FAIL(fault->truth);
  }
}

// ---- Cotangent at t = 0 ----

// Which of the two diagonals is an edge just after is up to the velocities; where the four stay
// cotangent, that of the largest id is.
TEST(InitialProof, CotangencyIsDecidedByTheVelocities) {
  struct Case {
    Rational vx, vy;
    bool horizontal;  // whether the neighbours are those on the x axis: 0 and 2, not 1 and 3
  };
  for (const Case& c : {Case{0, 0, false}, Case{1, 1, false}, Case{1, 0, false}, Case{0, 1, true},
                        Case{-1, 0, true}, Case{0, -1, false}, Case{1, 2, true},
                        Case{Rational(1, 1000000000), 0, false}}) {
    for (const bool filters : {true, false}) {
      Sites s(square(c.vx, c.vy), filters);
      Diagram d = s.at(0);
      for (int k = 0; k < 2; ++k) {
        const bool horizontal = between(d, 0, 2) >= 0;
        ASSERT_NE(horizontal, between(d, 1, 3) >= 0);
        const HalfEdge h = horizontal ? between(d, 0, 2) : between(d, 1, 3);
        const auto fault = s.fault(d);
        if (horizontal == c.horizontal) {
          EXPECT_EQ(told(fault), "none") << c.vx << " " << c.vy;
        } else {
          ASSERT_TRUE(fault.has_value()) << c.vx << " " << c.vy;
          ASSERT_TRUE(fault->edge.has_value());
          EXPECT_EQ(canonical(*fault->edge), canonical(d.quad(h)));
          EXPECT_FALSE(fault->vertex || fault->conflict || fault->cell);
          EXPECT_NE(fault->truth.find("cotangent"), std::string::npos);
        }
        d.flip(h);
      }
    }
  }
}

// ---- What is wrong is named ----

// No circle touches the three in the order of the vertex: the diagram seen in a mirror.
TEST(InitialProof, AVertexWithoutCircle) {
  for (const bool filters : {true, false}) {
    Sites s(scene_of(10, 1, {disk(-4, 1, 1, 0, 0), disk(4, 2, 2, 0, 0), disk(0, -5, 1, 0, 0)}),
            filters);
    const Diagram right = s.just_after(0), wrong = mirrored(right);
    ASSERT_TRUE(wrong.is_valid());
    const auto fault = s.fault(wrong);
    ASSERT_TRUE(fault.has_value());
    ASSERT_TRUE(fault->vertex.has_value());
    EXPECT_FALSE(fault->edge || fault->conflict || fault->cell);
    // It is one of the diagram's, and by its order none of the right one's.
    std::set<Triple> of_wrong, of_right;
    for (HalfEdge h = 0; h < 2 * wrong.edges(); ++h) {
      of_wrong.insert(end_vertex(wrong.quad(h)));
      of_right.insert(end_vertex(right.quad(h)));
    }
    EXPECT_TRUE(of_wrong.contains(*fault->vertex));
    EXPECT_FALSE(of_right.contains(*fault->vertex));
    EXPECT_EQ(*fault->vertex, canonical(*fault->vertex));
    EXPECT_NE(fault->truth.find("no circle touches"), std::string::npos);
  }
}

// A generator inside the circle of a vertex: the one edge of a square that is a little too long.
TEST(InitialProof, AnEdgeThatIsNotLegal) {
  for (const bool filters : {true, false}) {
    for (const Rational& nearer : {Rational(1), Rational(1, 1'000'000'000'000'000'000)}) {
      Scene scene = square(0, 0);
      scene.disks[1].y = Rational(5 - nearer);
      Sites s(scene, filters);
      Diagram d = s.just_after(0);
      ASSERT_GE(between(d, 1, 3), 0);
      EXPECT_EQ(told(s.fault(d)), "none");
      d.flip(between(d, 1, 3));
      const Quad q = canonical(d.quad(between(d, 0, 2)));
      const auto fault = s.fault(d);
      ASSERT_TRUE(fault.has_value());
      ASSERT_TRUE(fault->edge && fault->vertex && fault->conflict);
      EXPECT_FALSE(fault->cell);
      EXPECT_EQ(canonical(*fault->edge), q);
      // 1 is in the circle of 0, 2 and 3, and 3 in that of 0, 1 and 2.
      EXPECT_EQ(*fault->vertex, *fault->conflict == 1 ? (Triple{0, 2, 3}) : (Triple{0, 1, 2}));
      EXPECT_TRUE(*fault->conflict == 1 || *fault->conflict == 3);
      EXPECT_NE(fault->truth.find("contains a point of generator"), std::string::npos);
    }
  }
}

// Five disks in the order of the corners of a pentagram and one in their middle: circles and edges
// are right, and the cells wind twice.
TEST(InitialProof, ACellThatDoesNotTurnOnce) {
  const int corner[5][2] = {{10, 0}, {3, 9}, {-8, 6}, {-8, -6}, {3, -9}};
  for (const int step : {1, 2}) {
    std::vector<DiskInput> disks;
    std::vector<Quad> quads;
    for (int k = 0; k < 5; ++k) {
      const auto& [x, y] = corner[k * step % 5];
      disks.push_back(disk(x, y, 1, 0, 0));
      const int before = (k + 4) % 5, after = (k + 1) % 5;
      for (const Quad& q : {Quad{5, k, before, after}, {k, after, -1, 5}, {-1, k, after, before}}) {
        quads.push_back(canonical(q));
      }
    }
    disks.push_back(disk(0, 0, 1, 0, 0));
    for (const bool filters : {true, false}) {
      Sites s(scene_of(100, 3, disks), filters);
      const auto fault = s.fault(diagram_of(6, quads));
      ASSERT_EQ(fault.has_value(), step == 2);
      if (!fault) continue;
      ASSERT_TRUE(fault->cell.has_value());
      EXPECT_FALSE(fault->edge || fault->vertex || fault->conflict);
      EXPECT_NE(fault->truth.find("turn 2 times"), std::string::npos) << fault->truth;
    }
  }
}

// A point that touches a disk: its cell has no area.
TEST(InitialProof, ACellWithoutAreaIsUndecided) {
  Sites s(scene_of(20, 1, {disk(0, 0, 2, 0, 0), disk(2, 0, 0, 0, 0, 1)}));
  Diagram d(2);
  d.start(0, 1);
  EXPECT_THROW(s.fault(d), Undecided);
}

// A point flies into a disk and out of it again: while it is inside or on the boundary there is no
// diagram, whatever the edges are.
TEST(InitialProof, AWrongTangencyIsUndecided) {
  const Scene scene =
      scene_of(20, 10, {disk(0, 0, 2, 0, 0), disk(-5, 0, 0, 1, 0, 1), disk(9, 9, 1, 0, 0)});
  for (const bool filters : {true, false}) {
    Sites s(scene, filters);
    const Diagram d = s.just_after(0);
    EXPECT_EQ(told(s.fault(d, Rational(1, 2))), "none");
    for (const Rational& t : {Rational(3), Rational(4), Rational(7)}) {
      EXPECT_THROW(s.fault(d, t), Undecided) << t;
    }
  }
}

// Of scenes without cotangent generators there is one diagram, and whatever flips are made on it,
// what comes out is another or has a fault.
TEST(InitialProof, NoOtherDiagramPasses) {
  Random random(8);
  int wrong = 0, edges = 0, vertices = 0;
  for (int k = 0; k < 60; ++k) {
    const Scene scene = random_scene({.n = 3 + k % 8, .rmin = 0.5, .rmax = 12}, random);
    Sites s(scene), slow(scene, false);
    const Diagram right = s.just_after(0);
    Diagram d = right;
    for (int flips = 0; flips < 5; ++flips) {
      const auto h = static_cast<HalfEdge>(random() % (2 * d.edges()));
      const Quad q = d.quad(h);
      // A flip that would make an edge of a generator with itself is none.
      if (q.s == q.e) continue;
      d.flip(h);
      if (!d.is_valid()) break;
      const auto fault = s.fault(d);
      EXPECT_EQ(fault.has_value(), d.quads() != right.quads()) << text(scene);
      EXPECT_EQ(told(slow.fault(d)), told(fault));
      if (!fault) continue;
      ++wrong;
      edges += fault->edge.has_value();
      vertices += fault->vertex.has_value() && !fault->edge;
      if (fault->edge) {
        EXPECT_GE(find(d, *fault->edge), 0);
      }
      if (fault->vertex) {
        bool there = false;
        for (HalfEdge g = 0; g < 2 * d.edges(); ++g) {
          there = there || end_vertex(d.quad(g)) == *fault->vertex;
        }
        EXPECT_TRUE(there);
      }
    }
  }
  EXPECT_GT(wrong, 100);
  EXPECT_GT(edges, 0);
  EXPECT_GT(vertices, 0);
}

// What is found, and what it took, is the same for all numbers of threads.
TEST(InitialProof, ThreadsFindTheSame) {
  Random random(4);
  Sites s(random_scene({.n = 3000, .density = 0.1}, random));
  Diagram d = s.just_after(0);
  std::vector<HalfEdge> last;
  for (HalfEdge h = 2 * d.edges() - 2; last.size() < 3; h -= 2) {
    if (d.quad(h).s != d.quad(h).e) last.push_back(h);
  }
  for (int wrong = 0; wrong <= 3; ++wrong) {
    TierCounts alone;
    const auto fault = s.fault(d, 0, 1, alone);
    EXPECT_EQ(fault.has_value(), wrong > 0);
    for (const int threads : {2, 3, 16}) {
      TierCounts counts;
      EXPECT_EQ(told(s.fault(d, 0, threads, counts)), told(fault));
      EXPECT_EQ(counts.decided, alone.decided);
    }
    if (wrong < 3) d.flip(last[wrong]);
  }
}

// The same edges are right at one time and wrong at another: two go apart, and those across come to
// be neighbours.
TEST(InitialProof, AtItsTime) {
  const Scene scene = scene_of(
      20, 4,
      {disk(5, 0, 1, 0, 0), disk(0, 3, 1, 0, 1), disk(-5, 0, 1, 0, 0), disk(0, -3, 1, 0, -1)});
  Sites s(scene);
  const Diagram early = s.at(1), late = s.at(3);
  ASSERT_GE(between(early, 1, 3), 0);
  ASSERT_GE(between(late, 0, 2), 0);
  EXPECT_EQ(told(s.fault(early, 1)), "none");
  EXPECT_EQ(told(s.fault(late, 3)), "none");
  const auto fault = s.fault(early, 3);
  ASSERT_TRUE(fault.has_value());
  ASSERT_TRUE(fault->edge.has_value());
  EXPECT_EQ(members(*fault->edge), (std::set<GenId>{0, 1, 2, 3}));
}

}  // namespace
}  // namespace voroproof::internal::testing
