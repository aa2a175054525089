// Clearance of given paths, against fine sampling and by hand.
#include "library/planning/given_clearance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "exact/patience.h"

namespace voroproof::internal {
namespace {

const auto always = [] { return true; };

GivenPath path(const char* name, Rational radius, std::vector<Waypoint> waypoints) {
  return {name, radius, std::move(waypoints)};
}

GivenPaths given(std::vector<GivenPath> paths) {
  GivenPaths all;
  all.paths = std::move(paths);
  return all;
}

double sampled_gap(const GivenPath& a, const GivenPath& b, double t) {
  const auto at = [t](const GivenPath& p) -> std::pair<double, double> {
    const auto& w = p.waypoints;
    std::size_t k = 1;
    while (k + 1 < w.size() && w[k].t.get_d() < t) ++k;
    const double s = (t - w[k - 1].t.get_d()) / (w[k].t.get_d() - w[k - 1].t.get_d());
    return {w[k - 1].at[0].get_d() * (1 - s) + w[k].at[0].get_d() * s,
            w[k - 1].at[1].get_d() * (1 - s) + w[k].at[1].get_d() * s};
  };
  const auto [x, y] = at(a);
  const auto [u, v] = at(b);
  return std::hypot(x - u, y - v) - a.radius.get_d() - b.radius.get_d();
}

// Random paths of other starts, ends and waypoints, overlaps among them.
GivenPaths random_paths(std::mt19937_64& random, int n) {
  const auto integer = [&](int low, int high) {
    return static_cast<int>(std::uniform_int_distribution<int>(low, high)(random));
  };
  std::vector<GivenPath> paths;
  for (int g = 0; g < n; ++g) {
    GivenPath p = path("p", Rational(integer(0, 8), 4), {});
    p.radius.canonicalize();
    Rational t(integer(0, 12));
    for (int k = integer(2, 6); k > 0; --k) {
      p.waypoints.push_back({t, {Rational(integer(-20, 20)), Rational(integer(-20, 20))}});
      t += Rational(integer(1, 9)) / 3;
    }
    paths.push_back(p);
  }
  return given(std::move(paths));
}

TEST(GivenClearance, AsSamplingFinds) {
  std::mt19937_64 random(5);
  for (int round = 0; round < 20; ++round) {
    const GivenPaths all = random_paths(random, 2 + round % 7);
    const std::vector<GivenPath>& paths = all.paths;
    const GivenClearance clearance(all, always);
    double lowest = HUGE_VAL;
    std::vector<NearSpell> spells = clearance.spells_below(3);
    for (std::size_t i = 0; i < paths.size(); ++i) {
      for (std::size_t j = i + 1; j < paths.size(); ++j) {
        const double from =
            std::max(paths[i].waypoints.front().t.get_d(), paths[j].waypoints.front().t.get_d());
        const double to =
            std::min(paths[i].waypoints.back().t.get_d(), paths[j].waypoints.back().t.get_d());
        for (int k = 0; k <= 2000 && from <= to; ++k) {
          const double t = from + (to - from) * k / 2000, gap = sampled_gap(paths[i], paths[j], t);
          lowest = std::min(lowest, gap);
          const bool inside = std::any_of(spells.begin(), spells.end(), [&](const NearSpell& s) {
            return s.nearest.i == static_cast<int>(i) && s.nearest.j == static_cast<int>(j) &&
                   s.from.lo <= t && t <= s.to.hi;
          });
          if (std::fabs(gap - 3) < 1e-6) continue;  // doubles do not tell
          EXPECT_EQ(inside, gap < 3) << t << " " << gap;
        }
      }
    }
    const auto least = clearance.least();
    EXPECT_EQ(least.has_value(), lowest < HUGE_VAL);
    if (!least) continue;
    EXPECT_LE(gap(*least).lo, lowest + 1e-9);
    EXPECT_GT(gap(*least).hi, lowest - 0.5);  // speeds are below 170, steps below 0.01 / 2
    const Vec3 apart = place_at(paths[static_cast<std::size_t>(least->i)], least->t) -
                       place_at(paths[static_cast<std::size_t>(least->j)], least->t);
    EXPECT_EQ(Rational(dot(apart, apart)), least->distance2);
  }
}

// Two cross at the origin half a second apart, through a waypoint of one: one spell, its ends
// known.
TEST(GivenClearance, SpellsGoOnOverWaypoints) {
  const GivenPaths paths = given({path("a", 1, {{-10, {-10, 0}}, {0, {0, 0}}, {10, {10, 0}}}),
                                  path("b", 1, {{-10, {0, 0}}, {10, {0, 0}}})});
  const GivenClearance clearance(paths, always);
  const auto spells = clearance.spells_below(1);
  ASSERT_EQ(spells.size(), 1u);
  EXPECT_EQ(spells[0].from.lo, -3);
  EXPECT_EQ(spells[0].from.hi, -3);
  EXPECT_EQ(spells[0].to.lo, 3);
  EXPECT_EQ(spells[0].to.hi, 3);
  EXPECT_EQ(spells[0].nearest.t, 0);
  EXPECT_EQ(gap(spells[0].nearest).hi, -2);
  // At a gap of exactly the distance nothing is below it.
  const GivenPaths apart =
      given({path("a", 1, {{0, {0, 0}}, {1, {1, 0}}}), path("b", 1, {{0, {0, 3}}, {1, {1, 3}}})});
  EXPECT_TRUE(GivenClearance(apart, always).spells_below(1).empty());
  EXPECT_EQ(GivenClearance(apart, always).spells_below(Rational(11, 10)).size(), 1u);
}

TEST(GivenClearance, FewAndShortPaths) {
  const GivenPaths none;
  EXPECT_FALSE(GivenClearance(none, always).least());
  const GivenPaths one = given({path("a", 1, {{0, {0, 0}}})});
  EXPECT_FALSE(GivenClearance(one, always).least());
  // There at one time only, for a moment; and never.
  const GivenPaths moment =
      given({path("a", 1, {{0, {0, 0}}, {1, {1, 0}}}), path("b", 1, {{1, {4, 0}}, {2, {0, 0}}}),
             path("c", 0, {{3, {4, 0}}})});
  const auto least = GivenClearance(moment, always).least();
  ASSERT_TRUE(least);
  EXPECT_EQ(least->t, 1);
  EXPECT_EQ(gap(*least).lo, 1);
  const auto spells = GivenClearance(moment, always).spells_below(2);
  ASSERT_EQ(spells.size(), 1u);
  EXPECT_EQ(spells[0].from.lo, 1);
  EXPECT_EQ(spells[0].to.hi, 1);
}

// Two that turn at one time while they are near, over and over: so many spells as they are apart
// between, and none within another.
TEST(GivenClearance, WhoTurnAtOneTimeAreNearOnce) {
  GivenPaths all = given({path("a", 1, {}), path("b", 1, {})});
  for (int k = 0; k <= 40; ++k) {
    all.paths[0].waypoints.push_back({k, {0, 0}});
    all.paths[1].waypoints.push_back({k, {k % 2 == 0 ? 9 : 2, 0}});
  }
  const auto spells = GivenClearance(all, always).spells_below(1);
  ASSERT_EQ(spells.size(), 20u);
  for (std::size_t k = 0; k < spells.size(); ++k) {
    EXPECT_LT(spells[k].from.hi, 2.0 * static_cast<double>(k) + 1);
    EXPECT_GT(spells[k].to.lo, 2.0 * static_cast<double>(k) + 1);
  }
}

// On the recorded path of the second contact, which comes first, the two are apart by a rounding.
TEST(GivenClearance, AContactIsZeroAlsoWhereRoundingsLeaveAGap) {
  const Rational apart = Rational(2) + Rational(1) / (Integer(1) << 40);
  GivenPaths paths = given({path("a", 1, {{0, {0, 0}}, {9, {0, 0}}}),
                            path("b", 1, {{0, {9, 0}}, {5, {2, 0}}, {9, {9, 0}}}),
                            path("c", 1, {{0, {0, 50}}, {9, {0, 50}}}),
                            path("d", 1, {{0, {9, 50}}, {3, {apart, 50}}, {9, {9, 50}}})});
  paths.contacts = {{0, 1, 5}, {2, 3, 3}};
  const auto least = GivenClearance(paths, always).least();
  ASSERT_TRUE(least);
  EXPECT_EQ(std::pair(least->i, least->j), std::pair(2, 3));
  EXPECT_EQ(least->t, 3);
  EXPECT_EQ(least->distance2, 4);
}

TEST(GivenClearance, Interrupted) {
  const GivenPaths one = given({path("a", 1, {{0, {0, 0}}})});
  EXPECT_THROW(GivenClearance(one, [] { return false; }).least(), Interrupted);
}

}  // namespace
}  // namespace voroproof::internal
