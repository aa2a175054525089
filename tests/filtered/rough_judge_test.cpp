// Verdicts in plain doubles against verdicts in balls of 300 bits, at all roots of flip
// polynomials, from narrow and wide intervals, for motion as it is given and after collisions.
#include "filtered/rough_judge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "filtered/double_roots.h"
#include "filtered/flip_polynomial.h"
#include "filtered/rough_circles.h"
#include "filtered/subdivision.h"
#include "tests/filtered/end_of_runs.h"
#include "tests/support/scene_run.h"

namespace voroproof::testing {
namespace {

struct Tally {
  int roots = 0, collapses = 0, stays = 0, unknown = 0;  // from the intervals of the search
  int wide = 0;                                          // decided from wider ones
};

// The sign of f beyond the root does not matter here: whatever is said of it, the verdicts agree.
void expect_same(const Motion& motion, const Quad& q, double lo, double hi, Tally& tally,
                 bool narrow) {
  const MakeBall make{300};
  for (const Sign f : {Sign::positive, Sign::negative}) {
    const Verdict rough = judge_roughly(motion, q, lo, hi, f);
    if (narrow) {
      ++tally.roots;
      tally.collapses += rough == Verdict::collapses;
      tally.stays += rough == Verdict::stays;
      tally.unknown += rough == Verdict::unknown;
    }
    if (rough == Verdict::unknown) continue;
    tally.wide += !narrow;
    // At both ends and in the middle: a verdict is of the whole interval.
    for (const double t : {lo, 0.5 * (lo + hi), hi}) {
      const auto at = sites(motion, q, make(to_rational(t)));
      const Verdict truth = judge(
          q, at, [&] { return at; }, f);
      if (truth == Verdict::unknown) continue;
      ASSERT_EQ(truth, rough) << text(q) << " at " << t;
    }
  }
}

void expect_verdicts(const RandomScene& family, const char* horizon, Tally& tally) {
  at_end_of_runs(family, horizon, 5, [&](Engine<true>& engine) {
    const Motion& motion = engine.motion();
    const double start = round_up(Rational(horizon)), end = start + 8;
    for (int e = 0; e < engine.diagram().edges(); ++e) {
      const Quad q = engine.diagram().quad(2 * e);
      BernsteinForm form;
      if (q.s == q.e || form_flip_polynomial<true>(motion, q, start, end, form)) continue;
      each_root(form, start, end, [&](const DoubleRoot& root) {
        expect_same(motion, q, root.lo, root.hi, tally, true);
        for (const double widen : {1e-9, 1e-6, 1e-3, 1e-1, 2.0}) {
          expect_same(motion, q, root.lo - widen, root.hi + 3 * widen, tally, false);
        }
        return true;
      });
    }
  });
}

void expect_most_decided(const Tally& tally) {
  EXPECT_GT(tally.roots, 300);
  EXPECT_GT(tally.collapses, 50);
  EXPECT_GT(tally.stays, 50);
  EXPECT_LT(tally.unknown, tally.roots / 50);

  EXPECT_GT(tally.wide, 300);
}

TEST(RoughJudge, GivenMotion) {
  Tally tally;
  expect_verdicts({}, "0", tally);
  expect_most_decided(tally);
}

TEST(RoughJudge, AfterCollisions) {
  Tally tally;
  expect_verdicts({}, "30", tally);
  expect_most_decided(tally);
}

// A sign of any four generators, about times at which it changes: an interval with such a time has
// no sign, and one beside it is certain where it is narrow enough. `truth` and `told` say it of an
// edge, the latter of its start or its end.
template <class Truth, class Told>
void expect_over_the_whole_interval(Truth&& truth, Told&& told) {
  const MakeBall make{300};
  int changes[2] = {}, certain[2] = {};
  std::mt19937 random(7);
  const int n = 30;
  at_end_of_runs({.n = n, .rmin = 0.1, .rmax = 5}, "10", 6, [&](Engine<true>& engine) {
    const Motion& motion = engine.motion();
    std::vector<GenId> ids(n + 1);
    std::iota(ids.begin(), ids.end(), container_id);
    for (int trial = 0; trial < 300; ++trial) {
      std::shuffle(ids.begin(), ids.end(), random);
      const bool wall = trial % 2 == 0;
      if (wall) std::iter_swap(ids.begin() + trial / 2 % 4, std::ranges::find(ids, container_id));
      const Quad q{ids[0], ids[1], ids[2], ids[3]};
      for (const bool at_start : {true, false}) {
        const auto true_sign = [&](const Rational& t) {
          const auto at = sites(motion, q, make(t));
          const auto triples = EdgeTriples<Ball>::of(q, at);
          return at_start ? truth(triples.start, at[3], q.e == container_id)
                          : truth(triples.end, at[2], q.s == container_id);
        };
        const auto rough_sign = [&](double lo, double hi) {
          const RoughCircles circles(motion, q, lo, hi);
          if (!circles.usable()) return Sign::unknown;
          const RoughCircles::Signs signs = told(circles);
          return at_start ? signs.start : signs.end;
        };
        double before = 10, after = 14;
        const Sign first = true_sign(before);
        if (true_sign(after) != -first) continue;
        for (int k = 0; k < 46; ++k) {
          const double middle = 0.5 * (before + after);
          (true_sign(to_rational(middle)) == first ? before : after) = middle;
        }
        ++changes[wall];
        for (const double width : {0.0, 1e-10, 1e-8, 1e-7, 1e-6, 1e-5}) {
          ASSERT_EQ(rough_sign(before - width, after + 2 * width), Sign::unknown)
              << text(q) << before;
          const Sign beside = rough_sign(before - 3 * width, before - 2 * width);
          ASSERT_TRUE(beside == first || beside == Sign::unknown) << text(q) << before;
        }
        const double past = before - 1e-3;
        certain[wall] +=
            true_sign(to_rational(past)) == first && rough_sign(past, past + 1e-9) == first;
      }
    }
  });
  for (const int k : {0, 1}) {
    EXPECT_GT(changes[k], 60);
    EXPECT_GT(10 * certain[k], 9 * changes[k]);
  }
}

TEST(RoughCircles, ExistOverTheWholeInterval) {
  expect_over_the_whole_interval([](const TangentTriple<Ball>& triple, const Site<Ball>&,
                                    bool) { return circle_exists(triple); },
                                 [](const RoughCircles& circles) { return circles.exist(); });
}

// Whether or not the circles exist: these are signs of polynomials.
TEST(RoughCircles, InCircleOverTheWholeInterval) {
  for (const Sign f : {Sign::positive, Sign::negative}) {
    expect_over_the_whole_interval(
        [f](const TangentTriple<Ball>& triple, const Site<Ball>& other, bool is_container) {
          return incircle(triple, other, is_container, f);
        },
        [f](const RoughCircles& circles) { return circles.in_circle(f); });
  }
}

// Beyond one double the bound says nothing, but nothing wrong.
TEST(RoughJudge, ManySizes) {
  Tally tally;
  expect_verdicts({.n = 12, .rmin = 1e-4, .rmax = 12}, "5", tally);
  EXPECT_GT(tally.collapses, 50);
  tally = {};
  expect_verdicts({.n = 12, .rmin = 0, .rmax = 0}, "3", tally);
  EXPECT_GT(tally.roots, 100);
}

}  // namespace
}  // namespace voroproof::testing
