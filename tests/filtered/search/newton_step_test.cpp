// The bound of a Newton step against roots in balls of 400 bits, from wide and narrow intervals,
// for motion as it is given and as it is known after collisions.
#include "filtered/search/newton_step.h"

#include <gtest/gtest.h>

#include <cmath>

#include "filtered/search/collapse.h"
#include "tests/filtered/search/end_of_runs.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {
namespace {

struct Tally {
  int roots = 0, unknown = 0;
  double worst = 0;       // error over bound
  double least_gain = 0;  // largest bound over the length of an isolating interval
};

// All flips to come of the edges at the end of a run.
void expect_bounds(const RandomScene& family, const char* horizon, Tally& tally) {
  at_end_of_runs(family, horizon, 3, [&](Engine& engine) {
    const double start = round_up(Rational(horizon));
    TierCounts counts;
    CollapseSearch search(engine.motion(), counts);
    for (int e = 0; e < engine.diagram().edges(); ++e) {
      const Quad q = engine.diagram().quad(2 * e);
      const Collapse c = search.after(q, start, start + 8);
      if (c.kind != Collapse::Kind::root || c.fine) continue;
      const Ball root = search.refine(q, to_rational(c.lo), to_rational(c.hi), 400);
      ASSERT_LT(root.radius().to_double(), 1e-40);
      const Rational truth = root.midpoint();
      // The narrowest, where the errors of the states and of double-doubles are all there is.
      const double nearest = round_nearest(truth);
      const bool cocircular = flip_polynomial_is_cocircularity(engine.motion(), q);
      const DdBall narrow = newton_step(engine.motion(), q, std::nextafter(nearest, -INFINITY),
                                        std::nextafter(nearest, INFINITY), cocircular);
      if (narrow.rad < INFINITY) {
        const Rational off = abs(Rational(truth - to_rational(narrow.hi) - to_rational(narrow.lo)));
        ASSERT_LE(off, to_rational(narrow.rad)) << text(q);
      }
      for (const double widen : {0.0, 1e-12, 1e-8, 1e-5, 1e-3, 1e-1}) {
        const DdBall step =
            newton_step(engine.motion(), q, c.lo - widen, c.hi + 3 * widen, cocircular);
        ++tally.roots;
        if (!(step.rad < INFINITY)) {
          ++tally.unknown;
          continue;
        }
        const Rational off = abs(Rational(truth - to_rational(step.hi) - to_rational(step.lo)));
        ASSERT_LE(off, to_rational(step.rad)) << text(q) << " widened by " << widen;
        tally.worst = std::fmax(tally.worst, Rational(off / to_rational(step.rad)).get_d());
        if (widen == 0) tally.least_gain = std::fmax(tally.least_gain, step.rad / (c.hi - c.lo));
      }
    }
  });
}

TEST(NewtonStep, GivenMotion) {
  Tally tally;
  expect_bounds({}, "0", tally);
  EXPECT_GT(tally.roots, 300);
  EXPECT_LT(tally.unknown, tally.roots / 3);
  EXPECT_GT(tally.worst, 0.01);  // a bound, and not a distant one
}

TEST(NewtonStep, AfterCollisions) {
  Tally tally;
  expect_bounds({}, "30", tally);
  EXPECT_GT(tally.roots, 300);
  EXPECT_LT(tally.unknown, tally.roots / 3);
}

// For equal radii the step is one for C.
TEST(NewtonStep, EqualRadii) {
  for (const char* horizon : {"0", "30"}) {
    Tally tally;
    expect_bounds({.rmin = 5, .rmax = 5}, horizon, tally);
    expect_bounds({.rmin = 0, .rmax = 0}, horizon, tally);
    EXPECT_GT(tally.roots, 300);
    EXPECT_LT(tally.unknown, tally.roots / 3);
    EXPECT_GT(tally.worst, 0.003);
    EXPECT_LT(tally.least_gain, 1e-4);
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
