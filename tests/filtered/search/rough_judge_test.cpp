// Verdicts in plain doubles against verdicts in balls of 300 bits, at all roots of flip
// polynomials, from narrow and wide intervals, for motion as it is given and after collisions.
#include "filtered/search/rough_judge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "filtered/numbers/double_roots.h"
#include "filtered/numbers/subdivision.h"
#include "filtered/search/flip_polynomial.h"
#include "filtered/search/rough_circles.h"
#include "tests/filtered/search/end_of_runs.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {
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
    const Judgement rough = judge_roughly(motion, q, lo, hi, f);
    if (narrow) {
      ++tally.roots;
      tally.collapses += rough == Judgement::collapses;
      tally.stays += rough == Judgement::stays;
      tally.unknown += rough == Judgement::unknown;
    }
    if (rough == Judgement::unknown) continue;
    tally.wide += !narrow;
    // At both ends and in the middle: a verdict is of the whole interval.
    for (const double t : {lo, 0.5 * (lo + hi), hi}) {
      const auto at = sites(motion, q, make(to_rational(t)));
      const Judgement truth = judge(
          q, at, [&] { return at; }, f);
      if (truth == Judgement::unknown) continue;
      ASSERT_EQ(truth, rough) << text(q) << " at " << t;
    }
  }
}

void expect_verdicts(const RandomScene& family, const char* horizon, Tally& tally) {
  at_end_of_runs(family, horizon, 5, [&](Engine& engine) {
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

// Roots of C against in-circle functions and circles in balls of 300 bits, from intervals of every
// width: before and after a collapse, and that the circles exist there or one of them never.
void expect_cocircular_verdicts(const RandomScene& family, Tally& tally) {
  const MakeBall make{300};
  at_end_of_runs(family, "3", 5, [&](Engine& engine) {
    const Motion& motion = engine.motion();
    const double start = 3, end = start + 8;
    const auto expect_right = [&](const Quad& q, const BernsteinForm& form, double lo, double hi,
                                  Sign after) {
      const Judgement verdict = judge_cocircular(motion, q, lo, hi, form.spread, after);
      ++tally.roots;
      tally.collapses += verdict == Judgement::collapses;
      tally.stays += verdict == Judgement::stays;
      tally.unknown += verdict == Judgement::unknown;
      bool exist_throughout = true, one_never = false;
      Sign missing[2] = {Sign::negative, Sign::negative};
      for (const double t : {lo, 0.5 * (lo + hi), hi}) {
        const auto at = sites(motion, q, make(to_rational(t)));
        const auto circles = EdgeTriples<Ball>::of(q, at);
        const Sign exist[2] = {circle_exists(circles.start), circle_exists(circles.end)};
        for (int k = 0; k < 2; ++k) {
          exist_throughout = exist_throughout && exist[k] == Sign::positive;
          if (exist[k] != Sign::negative) missing[k] = Sign::positive;
        }
        if (t == lo || t == hi) {
          const Sign c = t == hi ? after : -after;
          if (verdict == Judgement::collapses) {
            ASSERT_EQ(sign(incircle_value(circles.start, at[3], false)), c) << text(q) << lo;
            ASSERT_EQ(sign(incircle_value(circles.end, at[2], false)), c) << text(q) << lo;
          }
        }
        if (verdict == Judgement::collapses) {
          ASSERT_TRUE(keeps_tangencies(at)) << text(q) << lo;
          ASSERT_EQ(contact_order(q, at), Sign::positive) << text(q) << lo;
        }
      }
      one_never = missing[0] == Sign::negative || missing[1] == Sign::negative;
      if (verdict == Judgement::collapses) {
        ASSERT_TRUE(exist_throughout) << text(q) << lo;
        ASSERT_EQ(after, Sign::negative);
      }
      if (verdict == Judgement::stays) {
        ASSERT_TRUE(one_never || (form.spread == 0 && after == Sign::positive)) << text(q) << lo;
      }
    };
    for (int e = 0; e < engine.diagram().edges(); ++e) {
      // And its mirror image, which is no edge: its circles do not exist.
      for (const Quad& q : {engine.diagram().quad(2 * e), flipped(engine.diagram().quad(2 * e))}) {
        BernsteinForm form;
        if (q.s == q.e || form_for_collapse(motion, q, start, end, form) || form.degree != 4) {
          continue;
        }
        each_root(form, start, end, [&](const DoubleRoot& root) {
          expect_right(q, form, root.lo, root.hi, root.after);
          for (const double widen : {1e-9, 1e-6, 1e-3}) {
            // Over a wider interval C still changes its sign once, if no other root is near.
            expect_right(q, form, root.lo - widen, root.hi, root.after);
          }
          return true;
        });
      }
    }
  });
}

TEST(RoughJudge, CocircularEqualRadii) {
  Tally tally;
  expect_cocircular_verdicts({.rmin = 5, .rmax = 5}, tally);
  expect_cocircular_verdicts({.rmin = 0, .rmax = 0}, tally);
  EXPECT_GT(tally.collapses, 200);
  EXPECT_GT(tally.stays, 200);
  EXPECT_LT(tally.unknown, tally.roots / 20);
}

TEST(RoughJudge, CocircularNearlyEqualRadii) {
  for (const double difference : {1e-5, 1e-9, 1e-13}) {
    Tally tally;
    expect_cocircular_verdicts({.rmin = 5, .rmax = 5 + difference}, tally);
    EXPECT_GT(tally.collapses, 100) << difference;
    EXPECT_GT(tally.stays, 50) << difference;
    // Only the circles tell at a root where C rises.
    EXPECT_LT(tally.unknown, tally.roots / 2) << difference;
  }
}

// About times at which three disks are on one line, where a circle begins or ends to exist: an
// interval with such a time is none of a collapse, and one just beside it may be.
TEST(RoughJudge, CocircularOverTheWholeInterval) {
  std::mt19937 random(11);
  int changes = 0, beside = 0;
  at_end_of_runs({.n = 20, .rmin = 2, .rmax = 2}, "4", 6, [&](Engine& engine) {
    const Motion& motion = engine.motion();
    std::vector<GenId> ids(20);
    std::iota(ids.begin(), ids.end(), 0);
    for (int trial = 0; trial < 400; ++trial) {
      std::shuffle(ids.begin(), ids.end(), random);
      const Quad q{ids[0], ids[1], ids[2], ids[3]};
      // Twice the areas of both triangles, exactly but for the rounding of the motion.
      const auto areas = [&](const Rational& t) {
        const auto at = sites(motion, q, MakeBall{300}(t));
        const auto area = [&](int a, int b, int c) {
          return sign(Ball((at[b].x - at[a].x) * (at[c].y - at[a].y) -
                           (at[b].y - at[a].y) * (at[c].x - at[a].x)));
        };
        return std::pair(area(0, 2, 1), area(1, 3, 0));
      };
      double before = 4, after = 8;
      const auto first = areas(before);
      if (areas(after).first != -first.first) continue;
      for (int k = 0; k < 46; ++k) {
        const double middle = 0.5 * (before + after);
        (areas(to_rational(middle)).first == first.first ? before : after) = middle;
      }
      ++changes;
      for (const double width : {0.0, 1e-12, 1e-9, 1e-6, 1e-3, 1e-1}) {
        for (const double spread : {0.0, 1e-9}) {
          ASSERT_NE(judge_cocircular(motion, q, before - width, after + 2 * width, spread,
                                     Sign::negative),
                    Judgement::collapses)
              << text(q) << before;
        }
      }
      for (const double past : {before - 1e-6, after + 1e-6}) {
        const auto signs = areas(to_rational(past));
        const Judgement verdict =
            judge_cocircular(motion, q, past - 1e-8, past + 1e-8, 0, Sign::negative);
        const bool both = signs.first == Sign::positive && signs.second == Sign::positive;
        if (verdict == Judgement::unknown) continue;
        ASSERT_EQ(verdict == Judgement::collapses, both) << text(q) << past;
        beside += both;
      }
    }
  });
  EXPECT_GT(changes, 200);
  EXPECT_GT(beside, 50);
}

// Three disks nearly on one line: whether their circle exists depends on radii that differ, too.
TEST(RoughJudge, CocircularMindsTheSpread) {
  std::mt19937 random(12);
  const double spread = 0.25;
  int collapses = 0, stays = 0;
  at_end_of_runs({.n = 20, .rmin = 2, .rmax = 2 + spread}, "4", 6, [&](Engine& engine) {
    const Motion& motion = engine.motion();
    std::vector<GenId> ids(20);
    std::iota(ids.begin(), ids.end(), 0);
    for (int trial = 0; trial < 2000; ++trial) {
      std::shuffle(ids.begin(), ids.end(), random);
      const Quad q{ids[0], ids[1], ids[2], ids[3]};
      const double t = 4 + 0.001 * trial;
      const Judgement verdict = judge_cocircular(motion, q, t, t, spread, Sign::negative);
      if (verdict == Judgement::unknown) continue;
      const auto at = sites(motion, q, MakeBall{300}(to_rational(t)));
      const auto circles = EdgeTriples<Ball>::of(q, at);
      const bool both = circle_exists(circles.start) == Sign::positive &&
                        circle_exists(circles.end) == Sign::positive;
      ASSERT_EQ(verdict == Judgement::collapses, both) << text(q) << t;
      if (both) {
        ASSERT_TRUE(keeps_tangencies(at)) << text(q) << t;
      }
      ++(both ? collapses : stays);
    }
  });
  EXPECT_GT(collapses, 500);
  EXPECT_GT(stays, 500);
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
  at_end_of_runs({.n = n, .rmin = 0.1, .rmax = 5}, "10", 6, [&](Engine& engine) {
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
}  // namespace voroproof::internal::testing
