// Gaps to the container on given paths, and contacts, against fine sampling and by hand.
#include "library/planning/wall_clearance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "library/planning/given_clearance.h"

namespace voroproof::internal {
namespace {

const auto always = [] { return true; };

// One disk of radius 1 in a container of radius 10 about (1, 0).
GivenPaths one(std::vector<Waypoint> waypoints) {
  GivenPaths given;
  given.paths = {{"a", 1, std::move(waypoints)}};
  given.container = RoundFrame{{1, 0}, 10};
  return given;
}

void expect_encloses(const Enclosure& e, double value) {
  EXPECT_LE(e.lo, value);
  EXPECT_GE(e.hi, value);
  EXPECT_LT(e.hi - e.lo, 1e-12);
}

// Past the wall and back: x - 1 from -8 to 8 in 4, and back in 8.
TEST(WallClearance, ByHand) {
  const GivenPaths given = one({{0, {-7, 0}}, {4, {9, 0}}, {12, {-7, 0}}});
  const WallClearance wall(given, always);
  const auto least = wall.least();
  ASSERT_TRUE(least);
  EXPECT_EQ(least->t, 0);
  EXPECT_EQ(least->distance2, 64);
  expect_encloses(gap(*least), 1);
  EXPECT_TRUE(keeps_clear(*least, 1, Touching::is_too_near));
  EXPECT_FALSE(keeps_clear(*least, Rational(1000000001, 1000000000), Touching::is_too_near));
  // The gap is less than 3 where |x - 1| > 6.
  const std::vector<NearSpell> spells = wall.spells_below(3);
  ASSERT_EQ(spells.size(), 3u);
  expect_encloses(spells[0].to, 0.5);
  expect_encloses(spells[1].from, 3.5);
  expect_encloses(spells[1].to, 5);
  EXPECT_EQ(spells[1].nearest.t, 4);
  expect_encloses(spells[2].from, 11);
  // One that is never less far: beyond the radius, all of the time.
  ASSERT_EQ(wall.spells_below(10).size(), 1u);
  EXPECT_TRUE(wall.spells_below(1).empty());
}

// A disk at rest, one at an instant alone, one on the circle of the distance.
TEST(WallClearance, Degenerate) {
  for (const auto& waypoints :
       {std::vector<Waypoint>{{0, {5, 3}}, {2, {5, 3}}}, std::vector<Waypoint>{{0, {5, 3}}}}) {
    const GivenPaths given = one(waypoints);  // 5 from the centre
    const WallClearance wall(given, always);
    expect_encloses(gap(*wall.least()), 4);
    EXPECT_TRUE(wall.spells_below(4).empty());
    EXPECT_EQ(wall.spells_below(Rational(5)).size(), 1u);
  }
  GivenPaths none;
  none.container = RoundFrame{{0, 0}, 1};
  EXPECT_FALSE(WallClearance(none, always).least());
  EXPECT_TRUE(WallClearance(none, always).spells_below(1).empty());
  EXPECT_FALSE(keeps_clear(Approach{container_id, 0, 0, 81, 9}, 0,
                           Touching::is_too_near));  // touching is not clear
  // Along a chord whose middle is at the distance: the instant parts the spell.
  const GivenPaths chord = one({{0, {-3, 3}}, {8, {5, 3}}});
  const std::vector<NearSpell> spells = WallClearance(chord, always).spells_below(6);
  ASSERT_EQ(spells.size(), 2u);
  expect_encloses(spells[0].to, 4);
  expect_encloses(spells[1].from, 4);
}

// A rounded place beyond the wall, at a contact: the gap is zero there.
TEST(WallClearance, ContactsAreNotOverlaps) {
  const Rational beyond = 10 + Rational(1, 1 << 30);
  GivenPaths given = one({{0, {1, 0}}, {2, {beyond, 0}}, {4, {1, 0}}});
  EXPECT_LT(gap(*WallClearance(given, always).least()).hi, 0);
  EXPECT_EQ(WallClearance(given, always).spells_below(0).size(), 1u);
  given.contacts = {{container_id, 0, 2}};
  const WallClearance wall(given, always);
  expect_encloses(gap(*wall.least()), 0);
  EXPECT_TRUE(wall.spells_below(0).empty());
  EXPECT_FALSE(keeps_clear(*wall.least(), 0, Touching::is_too_near));
  ASSERT_EQ(wall.spells_below(1).size(), 1u);
  EXPECT_EQ(wall.spells_below(1)[0].nearest.t, 2);
}

// The same of two disks, whose rounded places are a little apart or overlap a little.
TEST(WallClearance, ContactsOfDisks) {
  for (const int sign : {-1, 1}) {
    GivenPaths given = one({{0, {-5, 0}}, {2, {-1, 0}}, {4, {-5, 0}}});
    const Rational off = Rational(sign, 1 << 30), place = 1 + off;
    given.paths.push_back({"b", 1, {{0, {5, 0}}, {2, {place, 0}}, {4, {5, 0}}}});
    given.contacts = {{0, 1, 2}};
    const GivenClearance clearance(given, always);
    const auto least = clearance.least();
    ASSERT_TRUE(least);
    EXPECT_EQ(least->t, 2);
    expect_encloses(gap(*least), 0);
    EXPECT_FALSE(keeps_clear(*least, 0, Touching::is_too_near));
    EXPECT_TRUE(clearance.spells_below(0).empty());
    EXPECT_EQ(clearance.spells_below(1).size(), 1u);
    // Less than the rounding: the places tell where the spell is.
    EXPECT_EQ(clearance.spells_below(Rational(1, 1l << 40)).size(), sign < 0 ? 1u : 0u);
  }
}

// An overlap that is less deep than the rounding at a contact of the same piece.
TEST(WallClearance, AContactHidesNoOtherOverlap) {
  const Rational deep(1, 1 << 30), less_deep(1, 1l << 31);
  GivenPaths given = one({{0, {-1, 0}}, {4, {-1, 0}}});
  given.paths.push_back({"b", 1, {{0, {5, 0}}, {2, {1 - deep, 0}}, {4, {1 - less_deep, 0}}}});
  given.contacts = {{0, 1, 2}};
  const auto least = GivenClearance(given, always).least();
  ASSERT_TRUE(least);
  EXPECT_EQ(least->t, 4);
  expect_encloses(gap(*least), -0x1p-31);
}

TEST(WallClearance, AsSamplingFinds) {
  std::mt19937_64 random(7);
  const auto integer = [&](int low, int high) {
    return static_cast<int>(std::uniform_int_distribution<int>(low, high)(random));
  };
  std::size_t found = 0;
  for (int round = 0; round < 60; ++round) {
    std::vector<Waypoint> w;
    Rational t(0);
    for (int k = integer(1, 6); k >= 0; --k) {
      w.push_back({t, {Rational(integer(-8, 10)), Rational(integer(-6, 6))}});
      t += Rational(integer(1, 9)) / 3;
    }
    const GivenPaths given = one(w);
    const WallClearance wall(given, always);
    const double limit = integer(0, 8);
    const std::vector<NearSpell> spells = wall.spells_below(Rational(limit));
    found += spells.size();
    const double end = w.back().t.get_d(), least = gap(*wall.least()).hi;
    double lowest = HUGE_VAL;
    for (int k = 0; k <= 2000; ++k) {
      const double at = end * k / 2000;
      const Vec3 p = place_at(given.paths[0], Rational(at));
      const double here = 9 - std::hypot(p[0].get_d() - 1, p[1].get_d());
      lowest = std::min(lowest, here);
      EXPECT_GE(here, least - 1e-9);
      if (std::fabs(here - limit) < 1e-6) continue;
      const auto covers = [&](const NearSpell& s) { return s.from.lo <= at && at <= s.to.hi; };
      const auto spell = std::find_if(spells.begin(), spells.end(), covers);
      EXPECT_EQ(spell != spells.end(), here < limit) << "round " << round << ", t = " << at;
      if (spell == spells.end()) continue;
      EXPECT_GE(here, gap(spell->nearest).lo - 1e-9);
    }
    EXPECT_LT(lowest - least, 0.1);
  }
  EXPECT_GT(found, 40u);
}

}  // namespace
}  // namespace voroproof::internal
