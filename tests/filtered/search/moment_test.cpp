// Instants as the searches take them, their order and their rounding.
#include "filtered/search/moment.h"

#include <gtest/gtest.h>

#include <cmath>

#include "corpus/generate.h"
#include "engine/certified.h"
#include "filtered/search/collapse.h"
#include "filtered/search/contact.h"
#include "history/scene_motion.h"
#include "tests/certify/near_collisions.h"
#include "tests/support/compact_arithmetic.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {
namespace {

// Four disks about the circle of radius 10: three at rest, the fourth meets the circle at t = 1. A
// fifth does a moment later, so that two edges flip within the interval that isolates the first.
Scene nearly_together(const Rational& later) {
  const auto incoming = [](const Rational& r, const Rational& t, const Rational& c,
                           const Rational& s) {
    const Rational d = 10 + r + t;
    return disk(d * c, d * s, r, -c, -s);
  };
  const Rational p(3, 5), q(4, 5);
  return scene_of(
      40, 2,
      {disk(12, 0, 2, 0, 0), disk(-13 * p, 13 * q, 3, 0, 0), disk(-14 * p, -14 * q, 4, 0, 0),
       incoming(1, 1, p, q), incoming(Rational(3, 2), 1 + later, q, -p)});
}

TEST(Moment, AnInstantIsNarrowHoweverWideItsFlipIsIsolated) {
  const Scene scene = nearly_together(Rational(1, 10'000'000));
  ComputedMotion motion(motion_input(scene), {});
  TierCounts tiers;
  CollapseSearch collapses(motion, tiers);
  ContactSearch contacts(motion, tiers);
  Chronology chronology(motion, collapses, contacts, tiers);
  Collapse wide;
  wide.kind = Collapse::Kind::root;
  wide.lo = 1 - 1e-6;
  wide.hi = 1 + 1e-6;
  const Moment now = chronology.instant(Moment::of({0, 1, 3, 2}, wide));
  EXPECT_LE(now.lo, 1);
  EXPECT_GE(now.hi, 1);
  EXPECT_LT(now.hi - now.lo, 1e-14);
  // So that what begins at the instant has its flip beyond it.
  const Collapse next = collapses.from({0, 2, 3, 4}, now, 1 + 1e-6);
  ASSERT_EQ(next.kind, Collapse::Kind::root);
  EXPECT_GT(next.lo, now.hi);
}

// Contacts at irrational times 1e-45 apart: exact arithmetic tells, or more bits.
TEST(Moment, AnOrderThatTakesMoreBitsIsNotKnownYet) {
  const Scene scene = near_collisions();
  for (const bool irrational : {true, false}) {
    MotionOptions options;
    if (!irrational) options.max_radicals = 0;
    ComputedMotion motion(motion_input(scene), options);
    TierCounts tiers;
    CollapseSearch collapses(motion, tiers);
    ContactSearch contacts(motion, tiers);
    Chronology chronology(motion, collapses, contacts, tiers);
    const Moment start = chronology.instant(Moment::at(0));
    const auto contact = [&](GenId i, GenId j) {
      return Moment::of(i, j, contacts.from(i, j, start, 2));
    };
    const Moment a = contact(0, 1), b = contact(2, 3);
    std::string why_not;
    const std::optional<int> order = chronology.known_order(a, b, &why_not);
    EXPECT_EQ(order.has_value(), irrational);
    EXPECT_EQ(why_not.empty(), irrational);
    EXPECT_EQ(order.value_or(-1), -1);
    const int before = motion.goal_bits();
    EXPECT_EQ(chronology.compare(a, b), -1);
    EXPECT_EQ(chronology.compare(b, a), 1);
    EXPECT_EQ(motion.goal_bits() > before, !irrational);
  }
}

// Each of these scenes has a flip whose enclosure is narrow, and still has the boundary between two
// doubles inside, before it is narrowed once more.
TEST(Moment, DoubleDoublesRoundWhatTheyCan) {
  struct Choice {
    int n;
    std::uint64_t seed;
    double horizon;
  };
  for (const auto& [n, seed, horizon] :
       {Choice{20, 25, 3000}, Choice{50, 17, 2000}, Choice{100, 17, 1500}}) {
    ReferenceOptions options;
    options.n = n;
    options.seed = seed;
    options.horizon = horizon;
    const RecordedRun r = run(generate_reference(options));
    const auto& rounded = r.stats.tiers.decided[static_cast<int>(Predicate::round_time)];
    EXPECT_GT(rounded[static_cast<int>(Tier::dd)], 4000u);
    EXPECT_EQ(rounded[static_cast<int>(Tier::ball)], 0u) << n;
  }
}

// A rational that is no double ties with itself, and is rounded exactly.
TEST(Moment, ARationalIsKnownExactly) {
  const Scene scene = near_collisions();
  ComputedMotion motion(motion_input(scene), {});
  TierCounts tiers;
  CollapseSearch collapses(motion, tiers);
  ContactSearch contacts(motion, tiers);
  Chronology chronology(motion, collapses, contacts, tiers);
  const Rational third(1, 3);
  const Moment m = Moment::at(third);
  EXPECT_TRUE(m.tight);
  EXPECT_EQ(m.hi, std::nextafter(m.lo, 1));
  EXPECT_EQ(m.rational(), third);
  EXPECT_EQ(chronology.compare(m, Moment::at(third)), 0);
  EXPECT_EQ(chronology.compare(m, Moment::at(Rational(third + Rational(1, Integer(1) << 200)))),
            -1);
  EngineStats stats;
  EXPECT_EQ(Certified(motion, stats).rounded(m), 1.0 / 3);
  EXPECT_EQ(tiers.beyond_filter, 0);
}

}  // namespace
}  // namespace voroproof::internal::testing
