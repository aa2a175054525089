// Whether flip polynomials have roots, against Sturm's count of the roots of a polynomial that is
// put together in rational arithmetic from another formula.
#include "filtered/search/root_presence.h"

#include <gtest/gtest.h>

#include <array>

#include "exact/roots.h"
#include "library/certification.h"
#include "library/maneuver_input.h"
#include "tests/exact/sturm_sequence.h"
#include "tests/support/random_scenes.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {
namespace {

using P = Polynomial<Rational>;

// The circle of the unknown centre (x, y) and radius that touches all four satisfies three linear
// equations, whose solution by Cramer's rule is put into the equation of the first cone.
P flip_polynomial(const Scene& scene, const Quad& q) {
  struct Generator {
    P x, y, r;
  };
  const auto generator = [&](GenId g) {
    if (g == container_id)
      return Generator{{scene.cx}, {scene.cy}, {Rational(-scene.container_radius)}};
    const DiskInput& d = scene.disks[static_cast<std::size_t>(g)];
    return Generator{{d.x, d.vx}, {d.y, d.vy}, {d.radius}};
  };
  const Generator base = generator(q.l);
  std::array<std::array<P, 4>, 3> row;  // x, y, r, x^2 + y^2 - r^2
  for (std::size_t k = 0; k < 3; ++k) {
    const Generator g = generator(std::array<GenId, 3>{q.r, q.s, q.e}[k]);
    const P x = g.x - base.x, y = g.y - base.y, r = g.r - base.r;
    row[k] = {x, y, r, x * x + y * y - r * r};
  }
  const auto det = [&](std::size_t a, std::size_t b, std::size_t c) {
    const auto& [u, v, w] = row;
    return u[a] * (v[b] * w[c] - v[c] * w[b]) - u[b] * (v[a] * w[c] - v[c] * w[a]) +
           u[c] * (v[a] * w[b] - v[b] * w[a]);
  };
  const P x = det(3, 1, 2), y = det(0, 3, 2), r = det(0, 1, 3);
  return x * x + y * y - r * r;
}

struct Tally {
  int with = 0, without = 0;
};

void expect_presence(const RandomScene& family, Tally& tally) {
  Random random(7);
  for (int k = 0; k < 8; ++k) {
    const Scene scene = random_scene(family, random);
    ComputedMotion motion(motion_input(scene), {});
    for (const Quad& q : construct_initial(motion)) {
      if (q.s == q.e) continue;
      const SturmSequence<Rational> sturm(flip_polynomial(scene, q));
      for (const auto& [start, end] : {std::pair(0.0, 1.0), {0.5, 30.0}, {0.0, 1000.0}}) {
        const bool truth = sturm.count(to_rational(start), to_rational(end)) > 0;
        EXPECT_EQ(flip_polynomial_has_root(motion, q, start, end), truth) << text(q);
        ++(truth ? tally.with : tally.without);
      }
    }
  }
}

TEST(RootPresence, IsSturms) {
  Tally tally;
  expect_presence({}, tally);
  EXPECT_GT(tally.with, 200);
  EXPECT_GT(tally.without, 200);
}

TEST(RootPresence, EqualRadiiHaveDoubleRootsThatCount) {
  Tally tally;
  expect_presence({.rmin = 3, .rmax = 3}, tally);
  EXPECT_GT(tally.with, 100);
  EXPECT_GT(tally.without, 100);
}

// After a flip the search starts next to the edge's old root: the first double on either side of
// it.
TEST(RootPresence, StartsNextToARoot) {
  Random random(8);
  Tally tally;
  for (int k = 0; k < 8; ++k) {
    const Scene scene = random_scene({}, random);
    ComputedMotion motion(motion_input(scene), {});
    for (const Quad& q : construct_initial(motion)) {
      if (q.s == q.e) continue;
      const P f = flip_polynomial(scene, q);
      const SturmSequence<Rational> sturm(f);
      for (RootInterval root : isolate_roots(f, Rational(0), Rational(100))) {
        refine(f, root, Rational(1, Integer(1) << 80));
        for (const double start : {round_down(root.lo), round_up(root.hi)}) {
          for (const double length : {0x1p-20, 1.0, 1000.0}) {
            const double end = start + length;
            const bool truth = sturm.count(to_rational(start), to_rational(end)) > 0;
            EXPECT_EQ(flip_polynomial_has_root(motion, q, start, end), truth) << text(q);
            ++(truth ? tally.with : tally.without);
          }
        }
      }
    }
  }
  EXPECT_GT(tally.with, 500);
  EXPECT_GT(tally.without, 100);
}

// A double root and no change of sign: a fourth disk that grazes the circle of three at rest.
TEST(RootPresence, AGrazedCircleIsARoot) {
  const Scene scene = scene_of(1000, 100,
                               {disk(10, 0, 1, 0, 0), disk(-10, 0, 1, 0, 0), disk(0, -10, 1, 0, 0),
                                disk(-20, 11, 2, 1, 0), disk(-20, 12, 2, 1, 0)});
  const ComputedMotion motion(motion_input(scene), {});
  EXPECT_TRUE(flip_polynomial_has_root(motion, {0, 1, 2, 3}, 15, 25));
  EXPECT_FALSE(flip_polynomial_has_root(motion, {0, 1, 2, 3}, 21, 22));
  EXPECT_FALSE(flip_polynomial_has_root(motion, {0, 1, 2, 4}, 15, 25));
}

TEST(RootPresence, ACommonVelocityHasNone) {
  const Scene scene = scene_of(100, 50,
                               {disk(10, 0, 1, 1, 0), disk(-10, 0, 1, 1, 0), disk(0, -10, 1, 1, 0),
                                disk(0, 10, 1, 1, 0), disk(0, 15, 2, 1, 0)});
  const ComputedMotion motion(motion_input(scene), {});
  EXPECT_FALSE(flip_polynomial_has_root(motion, {0, 1, 2, 3}, 0, 50));  // zero throughout
  EXPECT_FALSE(flip_polynomial_has_root(motion, {0, 1, 2, 4}, 0, 50));  // a constant
}

}  // namespace
}  // namespace voroproof::internal::testing
