// Clearance of disks that grow, of parabolas between walls, and of contacts with images: by hand,
// and against sampling.
#include <gtest/gtest.h>

#include <cmath>

#include "library/planning/given_clearance.h"
#include "library/planning/wall_clearance.h"

namespace voroproof::internal {
namespace {

const auto always = [] { return true; };

// A disk that moves straight from one place to another, from t = 0 on.
GivenPath growing(const char* name, Rational radius, Rational growth, Vec3 from, Vec3 to,
                  int until) {
  return {name, radius, {{0, from}, {until, to}}, {}, growth};
}

void expect_encloses(const Enclosure& e, double value) {
  EXPECT_LE(e.lo, value + 1e-15);
  EXPECT_GE(e.hi, value - 1e-15);
  EXPECT_LT(e.hi - e.lo, 1e-14);
}

TEST(GrowingClearance, DisksAtRest) {
  GivenPaths given;
  given.paths = {growing("a", 1, 1, {0, 0}, {0, 0}, 2), growing("b", 1, 2, {10, 0}, {10, 0}, 2)};
  const auto least = GivenClearance(given, always).least();
  ASSERT_TRUE(least);
  EXPECT_TRUE(least->is_exact());
  EXPECT_EQ(least->t, 2);
  EXPECT_EQ(least->reach, 8);
  EXPECT_TRUE(keeps_clear(*least, 2, Touching::is_too_near));
  EXPECT_TRUE(falls_short(*least, Rational(2000001, 1000000), Touching::is_too_near));
  const auto spells = GivenClearance(given, always).spells_below(5);
  ASSERT_EQ(spells.size(), 1u);
  expect_encloses(spells[0].from, 1);
  expect_encloses(spells[0].to, 2);
}

// The gap of two is least later than their distance: root(1 + u^2) - (2 + u) / 4 - 1/2 for
// u = t - 2 is least where u = 1 / root(15), and root(15) / 4 - 1 there.
TEST(GrowingClearance, ADiskThatPasses) {
  GivenPaths given;
  given.paths = {growing("a", Rational(1, 2), Rational(1, 4), {0, 0}, {0, 0}, 4),
                 growing("b", 0, 0, {-2, 1}, {2, 1}, 4)};
  const GivenClearance clearance(given, always);
  const auto least = clearance.least();
  ASSERT_TRUE(least);
  const double gap_there = std::sqrt(15.0) / 4 - 1;
  expect_encloses(gap(*least), gap_there);
  EXPECT_NEAR(least->t.get_d(), 2 + 1 / std::sqrt(15.0), 1e-14);
  EXPECT_TRUE(falls_short(*least, 0, Touching::is_allowed));
  EXPECT_TRUE(falls_short(*least, Rational(-317, 10000), Touching::is_allowed));
  EXPECT_TRUE(keeps_clear(*least, Rational(-318, 10000), Touching::is_allowed));
  const auto spells = clearance.spells_below(Rational(1, 10));
  ASSERT_EQ(spells.size(), 1u);
  const auto at = [](double t) { return std::hypot(t - 2, 1) - 0.5 - t / 4; };
  EXPECT_NEAR(at(spells[0].from.lo), 0.1, 1e-12);
  EXPECT_NEAR(at(spells[0].to.hi), 0.1, 1e-12);
  EXPECT_LT(spells[0].from.hi, least->t);
  EXPECT_GT(spells[0].to.lo, least->t);
}

// The gap does not change, or only until the centres meet.
TEST(GrowingClearance, SquaresOfLines) {
  GivenPaths given;
  given.paths = {growing("a", Rational(1, 2), 1, {0, 0}, {0, 0}, 3),
                 growing("b", Rational(1, 2), 0, {1, 0}, {4, 0}, 3)};
  auto least = GivenClearance(given, always).least();
  ASSERT_TRUE(least);
  EXPECT_EQ(least->t, 0);
  EXPECT_TRUE(keeps_clear(*least, 0, Touching::is_allowed));
  EXPECT_TRUE(falls_short(*least, 0, Touching::is_too_near));
  given.paths = {growing("a", 0, 1, {0, 0}, {0, 0}, 3), growing("b", 0, 0, {-1, 0}, {2, 0}, 3)};
  least = GivenClearance(given, always).least();
  ASSERT_TRUE(least);
  EXPECT_EQ(least->t, 1);
  EXPECT_EQ(least->distance2, 0);
  expect_encloses(gap(*least), -1);
}

// A disk meets its own image when it has grown to half of the side.
TEST(GrowingClearance, OwnImages) {
  GivenPaths given;
  given.sides = {6, 0, 0};
  given.paths = {growing("a", 1, 1, {0, 0}, {50, 0}, 2)};
  const auto least = GivenClearance(given, always).least();
  ASSERT_TRUE(least);
  EXPECT_EQ(least->t, 2);
  EXPECT_TRUE(keeps_clear(*least, 0, Touching::is_allowed));
  EXPECT_TRUE(falls_short(*least, 0, Touching::is_too_near));
}

// y = t^2 - 2 t + 3 above a floor: the gap t^2 - 9/4 t + 5/2 is least between the ends.
TEST(GrowingClearance, AParabolaAboveAWall) {
  GivenPaths given;
  given.paths = {{"a",
                  Rational(1, 2),
                  {{0, {0, 3}}, {3, {0, 6}}},
                  {{{0, 3}, {0, -2}, {0, 1}}},
                  Rational(1, 4)}};
  given.walls = {{{0, 1, 0}, 0, 0}, {{1, 0, 0}, -20, Rational(1)}};
  const WallClearance wall(given, always);
  const auto least = wall.least();
  ASSERT_TRUE(least);
  EXPECT_TRUE(least->is_exact());
  EXPECT_EQ(least->i, -1);
  EXPECT_EQ(least->t, Rational(9, 8));
  EXPECT_EQ(least->reach, Rational(79, 64));
  EXPECT_TRUE(keeps_clear(*least, Rational(79, 64), Touching::is_too_near));
  EXPECT_TRUE(falls_short(*least, Rational(80, 64), Touching::is_too_near));
  const auto spells = wall.spells_below(Rational(3, 2));
  ASSERT_EQ(spells.size(), 1u);
  const double root = std::sqrt(81.0 / 64 - 1);
  expect_encloses(spells[0].from, 1.125 - root);
  expect_encloses(spells[0].to, 1.125 + root);
  // The other wall comes nearer by 5/4 in a unit of time.
  ASSERT_EQ(wall.spells_below(17).size(), 2u);
  expect_encloses(wall.spells_below(17)[0].from, 2);
  given.contacts = {{-1, 0, Rational(9, 8)}};
  expect_encloses(gap(*WallClearance(given, always).least()), 0);
}

// In a sphere; and a disk about its centre that grows beyond it.
TEST(GrowingClearance, InARoundFrame) {
  GivenPaths given;
  given.paths = {{"a",
                  Rational(1, 2),
                  {{0, {-2, 0}}, {4, {2, 0}}},
                  {{{-2, 0}, {1, 4}, {0, -1}}},
                  Rational(1, 8)}};
  given.container = RoundFrame{{0, 0, 0}, 6};
  const WallClearance wall(given, always);
  const auto least = wall.least();
  ASSERT_TRUE(least);
  const auto at = [](double t) { return 6 - 0.5 - t / 8 - std::hypot(t - 2, 4 * t - t * t); };
  double lowest = at(0);
  for (int k = 0; k <= 4000; ++k) lowest = std::min(lowest, at(k / 1000.0));
  EXPECT_LE(gap(*least).lo, lowest);
  EXPECT_GT(gap(*least).hi, lowest - 1e-6);
  EXPECT_LT(gap(*least).hi - gap(*least).lo, 1e-14);
  EXPECT_FALSE(keeps_clear(*least, Rational(gap(*least).hi), Touching::is_allowed) &&
               falls_short(*least, Rational(gap(*least).lo), Touching::is_allowed));
  const auto spells = wall.spells_below(2);
  ASSERT_EQ(spells.size(), 1u);
  EXPECT_NEAR(at(spells[0].from.lo), 2, 1e-12);
  EXPECT_NEAR(at(spells[0].to.hi), 2, 1e-12);
  given.paths = {growing("b", 5, 1, {0, 0}, {0, 0}, 2)};
  expect_encloses(gap(*WallClearance(given, always).least()), -1);
  ASSERT_EQ(WallClearance(given, always).spells_below(0).size(), 1u);
  expect_encloses(WallClearance(given, always).spells_below(0)[0].from, 1);
}

// Two touch across the side of a box, when they overlap most beside it.
TEST(GrowingClearance, AContactIsOfOneImage) {
  GivenPaths given;
  given.sides = {Rational(7, 2), 0, 0};
  const Vec3 off{Rational(-7, 4), 0}, nearest{Rational(-3, 2), 0};
  given.paths = {growing("a", 1, 0, {0, 0}, {0, 0}, 2),
                 GivenPath{"b", 1, {{0, off}, {1, nearest}, {2, off}}}};
  given.contacts = {{0, 1, 1, {1, 0, 0}}};
  const auto least = GivenClearance(given, always).least();
  ASSERT_TRUE(least);
  EXPECT_EQ(least->t, 1);
  expect_encloses(gap(*least), -0.5);
}

// As many images as the way is long, not as its box is large.
TEST(GrowingClearance, FarFalls) {
  GivenPaths given;
  given.in_space = true;
  given.sides = {2, 2, 2};
  for (int g = 0; g < 3; ++g) {
    GivenPath path{std::to_string(g), Rational(1, 4), {{0, {g, 0, 0}}, {1, {g + 900, 900, 901}}}};
    path.curves = {{{g, 0, 0}, {0, 0, 1}, {900, 900, 900}}};
    given.paths.push_back(std::move(path));
  }
  given.paths[1].curves[0][1] = {7, 20, 1};
  given.paths[1].waypoints[1].at = {908, 920, 901};
  const auto least = GivenClearance(given, always).least();
  ASSERT_TRUE(least);
  // The first and the third are a side apart: both at one place.
  EXPECT_EQ(least->distance2, 0);
  EXPECT_EQ(least->t, 0);
  EXPECT_EQ(least->j, 2);
  EXPECT_EQ(least->image, (LatticeImage{-1, 0, 0}));
  EXPECT_GT(GivenClearance(given, always).spells_below(Rational(1, 2)).size(), 10u);
}

}  // namespace
}  // namespace voroproof::internal
