// A Newton step for an in-circle function against the roots of the flip polynomial, also those at
// which that function is not zero.
#include "filtered/search/branch_search.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/static_diagram.h"
#include "library/maneuver_input.h"
#include "tests/filtered/search/collapse_truth.h"
#include "tests/support/random_scenes.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {
namespace {

struct Tally {
  int roots = 0, refined = 0;
};

// Looks at all roots of f of every edge of the diagram at the start, most of which lie beyond the
// end of the edge, isolated in intervals of about that width.
void expect_the_root(const Scene& scene, const Rational& width, Tally& tally) {
  const ComputedMotion motion(motion_input(scene), {});
  TierCounts counts;
  const Diagram diagram = static_diagram(motion, Rational(0), counts);
  for (Diagram::HalfEdge h = 0; h < 2 * diagram.edges(); h += 2) {
    const Quad q = diagram.quad(h);
    if (q.s == q.e) continue;
    const CollapseTruth edge(motion.input(), q);
    for (RootInterval root : isolate_roots(edge.polynomial(), Rational(0), Rational(12))) {
      refine(edge.polynomial(), root, width);
      const double lo = round_down(root.lo), hi = round_up(root.hi);
      if (isolate_roots(edge.polynomial(), to_rational(lo), to_rational(hi)).size() != 1) continue;
      ++tally.roots;
      const DdBall found = refine_branch(motion, q, lo, hi);
      if (!std::isfinite(found.rad)) continue;
      ++tally.refined;
      const Rational mid = to_rational(found.hi) + to_rational(found.lo);
      const Rational rad = to_rational(found.rad);
      EXPECT_EQ(isolate_roots(edge.polynomial(), mid - rad, mid + rad).size(), 1u)
          << text(q) << " in [" << lo << ", " << hi << "]";
    }
  }
}

TEST(BranchSearch, RefinesToTheRootOrNotAtAll) {
  for (const auto& [rmin, rmax] :
       {std::pair(2.0, 8.0), std::pair(0.0, 0.0), std::pair(0.01, 0.1)}) {
    Random random(1);
    Tally tally;
    for (int k = 0; k < 10; ++k) {
      const RandomScene family{.n = 7, .rmin = rmin, .rmax = rmax};
      expect_the_root(random_scene(family, random), Rational(1, k % 2 == 0 ? 1'000 : 1'000'000),
                      tally);
    }
    EXPECT_GT(tally.refined, 50);
    EXPECT_GT(tally.roots, tally.refined);
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
