// Narrowing isolated roots in double-doubles.
#include <gtest/gtest.h>

#include "engine/static_diagram.h"
#include "filtered/search/collapse.h"
#include "library/maneuver_input.h"
#include "tests/filtered/search/collapse_truth.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
namespace {

// From intervals that reach half way to the next roots, where the slope of the flip polynomial may
// vanish: then a Newton step shows nothing of them before they are halved.
TEST(RefinedCollapse, DoubleDoublesReachItFromTheWidestIntervals) {
  Random random(2);
  int all = 0, refined = 0, wide = 0;
  for (int k = 0; k < 6; ++k) {
    ComputedMotion motion(motion_input(random_scene({.n = 8, .rmin = 2, .rmax = 8}, random)), {});
    TierCounts tiers;
    CollapseSearch search(motion, tiers);
    const Diagram diagram = static_diagram(motion, 0, tiers);
    for (Diagram::HalfEdge h = 0; h < 2 * diagram.edges(); h += 2) {
      const Quad q = diagram.quad(h);
      if (q.s == q.e) continue;
      const auto roots = isolate_roots(CollapseTruth(motion.input(), q).polynomial(), 0, 12);
      for (std::size_t i = 0; i < roots.size(); ++i) {
        const Rational from = i == 0 ? 0 : Rational((roots[i - 1].hi + roots[i].lo) / 2);
        const Rational to =
            i + 1 == roots.size() ? 12 : Rational((roots[i].hi + roots[i + 1].lo) / 2);
        const double lo = round_nearest(from), hi = round_nearest(to);
        const DdBall dd =
            search.refine_until(q, lo, hi, [](const DdBall& t) { return t.rad < 1e-20; });
        const Ball truth = search.refine(q, to_rational(lo), to_rational(hi), 256);
        ++all;
        refined += dd.rad < 1e-20;
        wide += !(search.newton(q, lo, hi).rad < hi - lo);
        const Rational off = truth.midpoint() - to_rational(dd.hi) - to_rational(dd.lo);
        ASSERT_LE(abs(off), to_rational(dd.rad));
      }
    }
  }
  EXPECT_GT(wide, 0.5 * all);
  EXPECT_EQ(refined, all);
}

}  // namespace
}  // namespace voroproof::internal::testing
