// The search for collapses, tier by tier, against real algebraic numbers.
#include "filtered/search/collapse.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "engine/static_diagram.h"
#include "exact/polynomial.h"
#include "filtered/search/contact.h"
#include "library/maneuver_input.h"
#include "tests/filtered/search/collapse_truth.h"
#include "tests/support/compact_arithmetic.h"
#include "tests/support/random_scenes.h"
#include "tests/support/rough_contact.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {
namespace {

MotionOptions without_filters() {
  MotionOptions options;
  options.filters = false;
  return options;
}

std::uint64_t searches(const TierCounts& counts, Tier tier) {
  return counts.decided[static_cast<int>(Predicate::flip_search)][static_cast<int>(tier)];
}

// A search may stop early with "none up to here": goes on until `end`.
Collapse search_to(CollapseSearch& search, Collapse c, const Quad& q, double end) {
  for (int k = 0; k < 1000 && c.kind == Collapse::Kind::none && c.lo < end; ++k) {
    c = search.after(q, c.lo, end);
  }
  return c;
}

RootInterval interval(const Collapse& c) {
  return c.fine ? *c.fine : RootInterval{to_rational(c.lo), to_rational(c.hi)};
}

bool within(const ExactTime& t, const Rational& lo, const Rational& hi) {
  return compare(t, lo) >= 0 && compare(t, hi) <= 0;
}

// The answer is the true one, its interval isolates the root, and every way to refine it keeps it.
void expect_collapse(const Collapse& c, const std::optional<ExactTime>& truth,
                     const CollapseTruth& edge, const CollapseSearch& search, Motion& motion,
                     const Quad& q) {
  SCOPED_TRACE(text(q));
  ASSERT_EQ(c.kind, truth ? Collapse::Kind::root : Collapse::Kind::none);
  if (!truth) return;
  const RootInterval i = interval(c);
  ASSERT_TRUE(within(*truth, i.lo, i.hi));
  ASSERT_LE(to_rational(c.lo), i.lo);
  ASSERT_GE(to_rational(c.hi), i.hi);
  ASSERT_EQ(isolate_roots(edge.polynomial(), i.lo, i.hi).size(), 1u);
  const DdBall dd = search.refine(q, c.lo, c.hi);
  if (std::isfinite(dd.rad)) {
    const Rational mid = to_rational(dd.hi) + to_rational(dd.lo), rad = to_rational(dd.rad);
    ASSERT_TRUE(within(*truth, mid - rad, mid + rad));
  }
  double lo = 0, hi = 0;
  search.refine(q, i.lo, i.hi, 256).to_interval(lo, hi);
  ASSERT_TRUE(within(*truth, to_rational(lo), to_rational(hi)));
  ExactMotion exact(motion);
  ASSERT_EQ(CollapseSearch::exact_root(q, i.lo, i.hi, exact), *truth);
}

// A time, in doubles, at which no two of some generators have touched yet, and soon will (or
// `most`): from then on the lines are not where the disks are. Overlapping: 0.
double free_until(const Motion& motion, std::vector<GenId> ids, double most) {
  double first = most;
  std::sort(ids.begin(), ids.end());
  for (std::size_t a = 0; a < ids.size(); ++a) {
    for (std::size_t b = a + 1; b < ids.size(); ++b) {
      first = std::fmin(first, rough_contact(motion, ids[a], ids[b], 0).value_or(most));
    }
  }
  return std::fmax(0, first - 1e-6);
}

struct Tally {
  TierCounts tiers;
  int roots = 0, none = 0, second_roots = 0;
};

// All edges of the diagram at the instant, both by `after` and by `from`. The searches look
// beyond contacts of the generators, as the engine's do; what they find there does not matter.
void expect_right(const Scene& scene, const MotionOptions& options, bool at_start, Tally& tally) {
  const double end = 12;
  ComputedMotion motion(motion_input(scene), options);
  CollapseSearch search(motion, tally.tiers);
  std::vector<GenId> all(scene.disks.size() + 1);
  std::iota(all.begin(), all.end(), container_id);
  // A time before anything touches, which is no double.
  const Rational t = at_start ? Rational(0) : Rational(free_until(motion, all, end)) / 3;
  TierCounts unused;
  const Diagram diagram = static_diagram(motion, t, unused);
  const Moment now = Moment::at(t);
  for (Diagram::HalfEdge h = 0; h < 2 * diagram.edges(); h += 2) {
    const Quad q = diagram.quad(h);
    if (q.s == q.e) {
      EXPECT_EQ(search.from(q, now, end).kind, Collapse::Kind::none);
      continue;
    }
    const Rational free = to_rational(free_until(motion, {q.l, q.r, q.s, q.e}, end));
    // A collapse later than that counts as none.
    const auto counted = [&](Collapse c, const Quad& edge) {
      c = search_to(search, c, edge, end);
      if (c.kind == Collapse::Kind::root && to_rational(c.lo) > free) c.kind = Collapse::Kind::none;
      return c;
    };
    const CollapseTruth edge(motion.input(), q);
    const auto truth = edge.after(ExactTime(t), free);
    ++(truth ? tally.roots : tally.none);
    const Collapse by_from = counted(search.from(q, now, end), q);
    ASSERT_NO_FATAL_FAILURE(expect_collapse(by_from, truth, edge, search, motion, q));
    const Collapse by_after = counted(search.after(q, now.hi, end), q);
    ASSERT_NO_FATAL_FAILURE(expect_collapse(by_after, truth, edge, search, motion, q));
    if (!truth) continue;
    // The search goes on beyond the flip, for the edge that it leaves.
    const Quad next = flipped(q);
    const CollapseTruth next_edge(motion.input(), next);
    const auto next_truth = next_edge.after(*truth, free);
    const RootInterval fine = interval(by_after);
    const Collapse beyond = counted(search.after(next, by_after.hi, end, &fine), next);
    ASSERT_NO_FATAL_FAILURE(expect_collapse(beyond, next_truth, next_edge, search, motion, next));
    tally.second_roots += next_truth.has_value();
  }
}

Tally expect_right(const RandomScene& family, const MotionOptions& options, int scenes) {
  Random random(1);
  Tally tally;
  for (int k = 0; k < scenes && !::testing::Test::HasFatalFailure(); ++k) {
    expect_right(random_scene(family, random), options, k % 2 == 0, tally);
  }
  return tally;
}

TEST(CollapseSearch, RandomScenesAreDecidedInDoubles) {
  for (const auto& [rmin, rmax] :
       {std::pair(2.0, 8.0), std::pair(1e-2, 15.0), std::pair(0.0, 0.0), std::pair(5.0, 5.0)}) {
    const Tally t = expect_right({.n = 8, .rmin = rmin, .rmax = rmax}, {}, 5);
    EXPECT_GT(t.roots, 5);
    EXPECT_GT(t.none, 20);
    // Beyond a flip the search starts in the second tier; nothing random is a tie.
    EXPECT_GT(searches(t.tiers, Tier::filter), 100u);
    EXPECT_EQ(searches(t.tiers, Tier::exact), 0u);
  }
}

TEST(CollapseSearch, WithoutFiltersBallsDecide) {
  for (const auto& [rmin, rmax] : {std::pair(2.0, 8.0), std::pair(5.0, 5.0)}) {
    const Tally t = expect_right({.n = 7, .rmin = rmin, .rmax = rmax}, without_filters(), 4);
    EXPECT_GT(t.roots, 5);
    EXPECT_EQ(searches(t.tiers, Tier::filter), 0u);
    EXPECT_EQ(searches(t.tiers, Tier::dd), 0u);
    EXPECT_GT(searches(t.tiers, Tier::ball), 100u);
    EXPECT_EQ(searches(t.tiers, Tier::exact), 0u);
  }
}

// Radii that differ by little: pairs of roots near each other, one of the edge and one of the
// circle that touches from inside. The in-circle functions tell them apart.
TEST(CollapseSearch, NearlyEqualRadii) {
  for (const double difference : {1e-4, 1e-7, 1e-10, 1e-13, 1e-15}) {
    const Tally t = expect_right({.n = 6, .rmin = 5, .rmax = 5 + difference}, {}, 3);
    EXPECT_GT(t.roots, 5);
    EXPECT_GT(searches(t.tiers, Tier::filter), 50u);
    EXPECT_EQ(searches(t.tiers, Tier::ball), 0u);
    EXPECT_EQ(searches(t.tiers, Tier::exact), 0u);
  }
}

// Counts, for the edges between the disks of a scene of four, the answers that are double roots;
// all must be the true ones.
int expect_double_roots(const Scene& scene, TierCounts& tiers) {
  ComputedMotion motion(motion_input(scene), {});
  CollapseSearch search(motion, tiers);
  TierCounts unused;
  const Diagram diagram = static_diagram(motion, 0, unused);
  int found = 0;
  for (Diagram::HalfEdge h = 0; h < 2 * diagram.edges(); h += 2) {
    const Quad q = diagram.quad(h);
    if (std::min({q.l, q.r, q.s, q.e}) < 0 || q.s == q.e) continue;
    const CollapseTruth edge(motion.input(), q);
    const double end = free_until(motion, {q.l, q.r, q.s, q.e}, 12);
    const auto truth = edge.after(ExactTime(Rational(0)), to_rational(end));
    Collapse c = search_to(search, search.after(q, 0, end), q, end);
    // The search may see more of the window than it is asked for.
    if (!truth && c.kind == Collapse::Kind::root && c.lo >= end) c.kind = Collapse::Kind::none;
    expect_collapse(c, truth, edge, search, motion, q);
    if (!truth || ::testing::Test::HasFatalFailure()) continue;
    const RootInterval i = interval(c);
    found +=
        !isolate_roots(gcd(edge.polynomial(), edge.polynomial().derivative()), i.lo, i.hi).empty();
  }
  return found;
}

Rational pseudo_random(int k, int i) { return Rational((k * 37 + i * i * 29 + 11) % 31 - 15) / 32; }

// Two pairs of mirror images at time 1 alone: the outer and the inner circle touch all four there,
// and the flip polynomial has a double root. That there are not two of them only exact algebra
// says.
TEST(CollapseSearch, DoubleRootsAreFoundExactly) {
  TierCounts tiers;
  int roots = 0;
  for (int k = 0; k < 12; ++k) {
    const auto v = [&](int i) { return pseudo_random(k, i); };
    const Rational low = 1, high = Rational(5 + k % 3) / 4;
    roots += expect_double_roots(
        scene_of(100, 12,
                 {disk(-4 - v(0), -v(1), low, v(0), v(1)), disk(4 - v(2), -v(3), low, v(2), v(3)),
                  disk(-3 - v(4), 5 - v(5), high, v(4), v(5)),
                  disk(3 - v(6), 5 - v(7), high, v(6), v(7))}),
        tiers);
  }
  EXPECT_GT(roots, 3);
  EXPECT_GE(searches(tiers, Tier::exact), static_cast<std::uint64_t>(roots));
}

// Two disks and their images under a rotation are mirror images in pairs at isolated times, here 1:
// symmetry proves that their double roots are single instants.
TEST(CollapseSearch, DoubleRootsOfTurnedPairsAreFoundBySymmetry) {
  TierCounts tiers;
  int roots = 0;
  for (int k = 0; k < 12; ++k) {
    const Rational vax = pseudo_random(k, 0), vay = pseudo_random(k, 1);
    const Rational vbx = pseudo_random(k, 2), vby = pseudo_random(k, 3);
    // The rotation that carries (1, 5) onto (-1, 5).
    const Rational cos(12, 13), sin(5, 13);
    const Rational vcx = cos * vax - sin * vay, vcy = sin * vax + cos * vay;
    const Rational vdx = cos * vbx - sin * vby, vdy = sin * vbx + cos * vby;
    const Rational low = 1, high = Rational(5 + k % 3) / 4;
    roots += expect_double_roots(
        scene_of(100, 12,
                 {disk(-4 - vax, -vay, low, vax, vay), disk(4 - vcx, -vcy, low, vcx, vcy),
                  disk(-3 - vbx, 5 - vby, high, vbx, vby), disk(3 - vdx, 5 - vdy, high, vdx, vdy)}),
        tiers);
  }
  EXPECT_GT(roots, 3);
  EXPECT_EQ(searches(tiers, Tier::ball), 0u);
  EXPECT_EQ(searches(tiers, Tier::exact), 0u);
}

// A point that touches another generator and goes on has tangent circles that mean nothing: what
// is seen of the edge then, still in the window, is no verdict about a collapse before.
TEST(CollapseSearch, ContactsInTheWindowHideNoCollapse) {
  const RandomScene points{.n = 7, .rmin = 0, .rmax = 0};
  const RandomScene small{.n = 7, .rmin = 0.01, .rmax = 0.1};
  EXPECT_GT(expect_right(points, {}, 12).roots, 20);
  EXPECT_GT(expect_right(points, without_filters(), 12).roots, 10);
  EXPECT_GT(expect_right(small, without_filters(), 12).roots, 10);
}

// Four disks at the corners of a rhombus, two of which fly apart: at time 1 all four touch a
// circle around the origin.
Scene rhombus(const Rational& radius, const Rational& other, const Rational& velocity) {
  const Rational half = 3 + other - radius - velocity;
  return scene_of(100, 4,
                  {disk(3, 0, radius, 0, 0), disk(-3, 0, radius, 0, 0),
                   disk(0, half, other, 0, velocity), disk(0, -half, other, 0, -velocity)});
}

// The edge between the disks 2 and 3, or that between 0 and 1, from one to the other.
Quad edge_between(const Motion& motion, const Rational& t, GenId a, GenId b) {
  TierCounts unused;
  const Diagram d = static_diagram(motion, t, unused);
  for (Diagram::HalfEdge h = 0; h < 2 * d.edges(); ++h) {
    const Quad q = d.quad(h);
    if (q.l == a && q.r == b && q.s >= 0 && q.e >= 0 && q.s != q.e) return q;
  }
  return {0, 0, 0, 0};
}

// Balls of a number that is exactly zero have no sign: where bisection meets the root, as over
// [0, 2], or the window ends there, the fourth tier must decide.
TEST(CollapseSearch, ARootAtARationalTime) {
  for (const double end : {1, 2}) {
    for (const Rational& other : {Rational(1, 2), Rational(1, 4)}) {
      ComputedMotion motion(motion_input(rhombus(Rational(1, 2), other, Rational(1, 8))),
                            without_filters());
      TierCounts tiers;
      CollapseSearch search(motion, tiers);
      const Quad q = edge_between(motion, 0, 2, 3);
      // Halving a window comes upon the root itself. Balls go as far as they can, and on from
      // there.
      Collapse c = search.after(q, 0, end);
      while (c.kind == Collapse::Kind::none && c.lo < 1) c = search.after(q, c.lo, end);
      const CollapseTruth edge(motion.input(), q);
      const auto truth = edge.after(ExactTime(Rational(0)), 2);
      ASSERT_TRUE(truth);
      EXPECT_EQ(*truth, ExactTime(Rational(1)));
      expect_collapse(c, truth, edge, search, motion, q);
      // Comparisons of times rely on the root being inside its interval, or its only point.
      ExactMotion exact(motion);
      const RootInterval i = interval(c);
      EXPECT_TRUE(compare(CollapseSearch::exact_root(q, i.lo, i.hi, exact), Rational(1)) == 0);
      EXPECT_LT(c.hi - c.lo, 1e-6);
    }
  }
}

TEST(CollapseSearch, AtTheInstantOfTheCollapse) {
  for (const MotionOptions& options : {MotionOptions{}, without_filters()}) {
    for (const Rational& other : {Rational(1, 2), Rational(1, 4)}) {
      ComputedMotion motion(motion_input(rhombus(Rational(1, 2), other, Rational(1, 8))), options);
      TierCounts tiers;
      CollapseSearch search(motion, tiers);
      const Quad q = edge_between(motion, 0, 2, 3);
      EXPECT_EQ(search.from(q, Moment::at(1), 4).kind, Collapse::Kind::now);
      // The edge that the flip leaves has a root there too, and stays.
      EXPECT_EQ(search.from(flipped(q), Moment::at(1), 4).kind, Collapse::Kind::none);
      EXPECT_EQ(searches(tiers, Tier::exact), 2u);
    }
  }
}

// While four stay cotangent the edge of the largest id exists: 3 with its opposite 2.
TEST(CollapseSearch, CotangentForGood) {
  for (const MotionOptions& options : {MotionOptions{}, without_filters()}) {
    for (const Rational& other : {Rational(1, 2), Rational(1, 4)}) {
      Scene growing = rhombus(Rational(1, 2), Rational(1, 2), 0);
      for (DiskInput& d : growing.disks) {  // away from the origin, each in proportion
        d.vx = d.x / 8;
        d.vy = d.y / 8;
      }
      for (const Scene& scene : {rhombus(Rational(1, 2), other, 0), growing}) {
        ComputedMotion motion(motion_input(scene), options);
        TierCounts tiers;
        CollapseSearch search(motion, tiers);
        const Quad q{2, 3, 0, 1}, r{2, 3, 1, 0};
        // One of the two is the edge; either is judged by the rule.
        for (const Quad& edge : {q, r}) {
          EXPECT_EQ(search.from(edge, Moment::at(1), 4).kind, Collapse::Kind::none);
        }
        const Quad between = edge_between(motion, 0, 2, 3).l == 2
                                 ? edge_between(motion, 0, 2, 3)
                                 : flipped(edge_between(motion, 0, 0, 1));
        EXPECT_EQ(search.from(flipped(between), Moment::at(1), 4).kind, Collapse::Kind::now);
      }
    }
  }
}

// At t = 128/57 the four would be on one line, long after others have come between: a root, but
// no circles. What is known up to there is the answer, not that nothing can be decided.
TEST(CollapseSearch, FourOnALineLater) {
  const auto speed = [](long thirtyseconds) -> Rational { return Rational(thirtyseconds) / 32; };
  const Scene scene = scene_of(100, 20,
                               {disk(32, Rational(65, 2), 1, speed(-40), 0),
                                disk(11, Rational(57, 2), 1, speed(37), speed(57)),
                                disk(8, Rational(65, 2), 1, speed(-40), 0),
                                disk(29, Rational(57, 2), 1, speed(-27), speed(57))});
  const Quad q{0, 1, 2, 3};
  for (const MotionOptions& options : {MotionOptions{}, without_filters()}) {
    ComputedMotion motion(motion_input(scene), options);
    TierCounts tiers;
    CollapseSearch search(motion, tiers);
    for (const Quad& edge : {q, flipped(q)}) {
      const Collapse c = search.from(edge, Moment::at(0), 4);
      if (c.kind == Collapse::Kind::now) continue;  // one of the two is illegal from 0 on
      EXPECT_EQ(c.kind, Collapse::Kind::none);
      EXPECT_GT(c.lo, 1);
      EXPECT_LT(c.lo, 2.25);
    }
    EXPECT_GT(searches(tiers, Tier::exact), 0u);
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
