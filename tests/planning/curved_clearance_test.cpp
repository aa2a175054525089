// Clearance of curves, in space, in periodic boxes and between heights: against sampling, against
// the same motion told in another way, and by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "library/planning/given_clearance.h"

namespace voroproof::internal {
namespace {

const auto always = [] { return true; };

// Paths of pieces without jumps: of two disks or more, from 0 to 4.
class RandomPieces {
 public:
  explicit RandomPieces(unsigned seed) : random_(seed) {}

  GivenPaths paths(int n, int degree, bool in_space) {
    GivenPaths given;
    given.in_space = in_space;
    for (int g = 0; g < n; ++g) {
      GivenPath path{std::to_string(g), Rational(integer(0, 3)) / 2, {{0, place(in_space)}}};
      Rational t = 0;
      for (const int duration : {1, 2, 1}) {
        Curve curve{path.waypoints.back().at};
        for (int k = 1; k <= degree; ++k) curve.push_back(place(in_space) * Rational(1, 4));
        Vec3 end{};
        for (std::size_t k = curve.size(); k-- > 0;) end = end * Rational(duration) + curve[k];
        t += duration;
        path.waypoints.push_back({t, end});
        path.curves.push_back(std::move(curve));
      }
      given.paths.push_back(std::move(path));
    }
    return given;
  }

  int integer(int low, int high) {
    return static_cast<int>(std::uniform_int_distribution<int>(low, high)(random_));
  }

 private:
  Vec3 place(bool in_space) {
    return {integer(-6, 6), integer(-6, 6), in_space ? integer(-6, 6) : 0};
  }

  std::mt19937_64 random_;
};

// How far two are apart at a time, less their radii, in doubles: the nearest image, horizontally
// and never where heights tell them apart.
double sampled_gap(const GivenPaths& given, std::size_t i, std::size_t j, double t, double height) {
  const auto at = [&](const GivenPath& path, std::size_t axis) {
    std::size_t k = 1;
    while (k + 1 < path.waypoints.size() && path.waypoints[k].t.get_d() < t) ++k;
    const double s = t - path.waypoints[k - 1].t.get_d();
    double value = 0;
    const Curve& curve = path.curves[k - 1];
    for (std::size_t power = curve.size(); power-- > 0;)
      value = value * s + curve[power][axis].get_d();
    return value;
  };
  double square = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double offset = at(given.paths[j], axis) - at(given.paths[i], axis);
    const double side = given.sides[axis].get_d();
    if (side != 0) offset -= side * std::round(offset / side);
    if (height > 0 && axis == 2) {
      if (std::fabs(std::fabs(offset) - height) < 1e-6) return NAN;  // doubles do not tell
      if (std::fabs(offset) >= height) return HUGE_VAL;
      continue;
    }
    square += offset * offset;
  }
  return std::sqrt(square) - given.paths[i].radius.get_d() - given.paths[j].radius.get_d();
}

struct World {
  int degree;
  bool in_space, is_periodic;
  int height;  // 0: none
};

class CurvedClearance : public testing::TestWithParam<World> {};

TEST_P(CurvedClearance, AsSamplingFinds) {
  const World& world = GetParam();
  RandomPieces pieces(7);
  std::size_t found = 0;
  for (int round = 0; round < 16; ++round) {
    GivenPaths given = pieces.paths(3 + round % 3, world.degree, world.in_space);
    if (world.is_periodic) given.sides = {9, 0, world.in_space ? Rational(7) : Rational(0)};
    ClearanceRules rules;
    if (world.height > 0) rules.height = world.height;
    const GivenClearance clearance(given, always, rules);
    const auto least = clearance.least();
    const auto spells = clearance.spells_below(1);
    found += spells.size();
    double lowest = HUGE_VAL;
    for (std::size_t i = 0; i < given.paths.size(); ++i) {
      for (std::size_t j = i + 1; j < given.paths.size(); ++j) {
        for (int k = 0; k <= 4000; ++k) {
          const double t = k / 1000.0, here = sampled_gap(given, i, j, t, world.height);
          if (std::isnan(here)) continue;
          lowest = std::min(lowest, here);
          const auto inside = [&](const NearSpell& s) {
            return s.nearest.i == static_cast<int>(i) && s.nearest.j == static_cast<int>(j) &&
                   s.from.lo <= t && t <= s.to.hi;
          };
          const auto spell = std::find_if(spells.begin(), spells.end(), inside);
          if (std::fabs(here - 1) < 1e-6) continue;  // doubles do not tell
          EXPECT_EQ(spell != spells.end(), here < 1) << "round " << round << ", t = " << t;
          // Of two images one may be nearer than the one of the spell.
          if (spell == spells.end() || here == HUGE_VAL || world.is_periodic) continue;
          EXPECT_GE(here, gap(spell->nearest).lo - 1e-9);
        }
      }
    }
    if (world.is_periodic) {  // and each has images of itself
      for (const GivenPath& path : given.paths) {
        lowest = std::min(lowest, 9 - 2 * path.radius.get_d());
        if (world.in_space && world.height == 0)
          lowest = std::min(lowest, 7 - 2 * path.radius.get_d());
      }
    }
    ASSERT_EQ(least.has_value(), lowest < HUGE_VAL);
    if (!least) continue;
    EXPECT_LE(gap(*least).lo, lowest + 1e-9);
    EXPECT_GT(gap(*least).hi, lowest - 0.05);
    EXPECT_LT(gap(*least).hi - gap(*least).lo, 1e-12);
  }
  EXPECT_GT(found, 5u);
}

INSTANTIATE_TEST_SUITE_P(Worlds, CurvedClearance,
                         testing::Values(World{1, false, false, 0}, World{2, false, false, 0},
                                         World{7, false, false, 0}, World{3, true, false, 0},
                                         World{1, true, false, 5}, World{3, true, false, 5},
                                         World{1, true, true, 0}, World{2, false, true, 0},
                                         World{3, true, true, 0}),
                         [](const auto& info) {
                           const World& w = info.param;
                           return "Degree" + std::to_string(w.degree) +
                                  (w.in_space ? "Space" : "Plane") +
                                  (w.is_periodic ? "Periodic" : "") +
                                  (w.height > 0 ? "Height" + std::to_string(w.height) : "");
                         });

GivenPath straight(const char* name, Rational radius, std::vector<Waypoint> waypoints) {
  return {name, radius, std::move(waypoints)};
}

// A parabola (s, s^2) passes a point at (0, 5/4): nearest where s^2 = 3/4, at a distance of 1.
TEST(CurvedClearance, AnAlgebraicTimeIsEnclosed) {
  GivenPaths given;
  given.paths = {straight("still", 0, {{-2, {0, Rational(5, 4)}}, {2, {0, Rational(5, 4)}}}),
                 GivenPath{"p", Rational(1, 2), {{-2, {-2, 4}}, {2, {2, 4}}}, {}}};
  given.paths[1].curves = {{{-2, 4, 0}, {1, -4, 0}, {0, 1, 0}}};
  const auto least = GivenClearance(given, always).least();
  ASSERT_TRUE(least);
  const double root = std::sqrt(0.75);
  EXPECT_NEAR(least->t.get_d(), -root, 1e-15);
  EXPECT_LE(least->t.get_d(), -root + 1e-16);
  EXPECT_LE(gap(*least).lo, 0.5);
  EXPECT_GE(gap(*least).hi, 0.5);
  EXPECT_LT(gap(*least).hi - gap(*least).lo, 1e-15);
  // The gap is 1/2 exactly, which an enclosure cannot prove; and nothing false is proved.
  EXPECT_FALSE(keeps_clear(*least, Rational(1, 2), Touching::is_allowed));
  EXPECT_FALSE(falls_short(*least, Rational(1, 2), Touching::is_allowed));
  EXPECT_TRUE(keeps_clear(*least, Rational(499999, 1000000), Touching::is_allowed));
  EXPECT_TRUE(falls_short(*least, Rational(500001, 1000000), Touching::is_allowed));
  // Two spells below a little more, one below much more.
  EXPECT_EQ(GivenClearance(given, always).spells_below(Rational(51, 100)).size(), 2u);
  EXPECT_EQ(GivenClearance(given, always).spells_below(2).size(), 1u);
}

// Two ends of a spell that are less than 2^-120 apart.
TEST(CurvedClearance, AShortSpell) {
  GivenPaths given;
  given.paths = {straight("still", 0, {{0, {0, 0}}, {1, {0, 0}}}),
                 GivenPath{"p", 0, {{0, {Rational(5, 4), 0}}, {1, {Rational(5, 4), 0}}}, {}}};
  given.paths[1].curves = {{{Rational(5, 4), 0, 0}, {-1, 0, 0}, {1, 0, 0}}};
  const Rational little = Rational(1) / (Integer(1) << 244);
  EXPECT_EQ(GivenClearance(given, always).spells_below(1 + little).size(), 1u);
  EXPECT_TRUE(GivenClearance(given, always).spells_below(1).empty());
}

// A least gap that is only neared, where the heights come to differ by enough, is not reached.
TEST(CurvedClearance, LimitsThatAreNotReached) {
  GivenPaths given;
  given.in_space = true;
  given.paths = {straight("a", Rational(1, 2), {{0, {0, 0, 0}}, {1, {0, 0, 0}}}),
                 straight("b", Rational(1, 2), {{0, {1, 0, 1}}, {1, {2, 0, 0}}})};
  const auto least = GivenClearance(given, always, {false, 1}).least();
  ASSERT_TRUE(least);
  EXPECT_EQ(least->distance2, 1);
  EXPECT_TRUE(keeps_clear(*least, 0, Touching::is_too_near));
  given.paths[1].waypoints = {{0, {1, 0, 0}}, {1, {2, 0, 1}}};
  EXPECT_FALSE(
      keeps_clear(*GivenClearance(given, always, {false, 1}).least(), 0, Touching::is_too_near));
}

// Two of these radii, the second at `offset` from the first.
CommonPiece between_heights(const Rational& radius, const Curve& offset) {
  return {{0, 1, {}, 0, 1, {Rational(2 * radius)}}, offset, Rational(1)};
}

// The heights come to differ by enough, or cease to, at roots whose enclosures overlap others.
TEST(CurvedClearance, RootsThatAreNear) {
  // They are near for 1e-40 of the time.
  const Rational steep = Rational(Integer("10000000000000000000000000000000000000000"));
  const CommonPiece thin =
      between_heights(1, {{0, 0, -steep / 2}, {0, 0, 0}, {0, 0, 0}, {0, 0, steep}});
  ASSERT_TRUE(thin.nearest({}));
  EXPECT_EQ(thin.nearest({})->distance2, 0);
  EXPECT_EQ(thin.below(1, {}).size(), 1U);
  // They are near from s = sqrt(1/2) on; s0 and s1 are 2^-81 from that. The least distance of all
  // times is at s0, before it.
  const Rational s0("1709679290002018430137083/2417851639229258349412352"),
      s1 = s0 + Rational(1) / (Integer(1) << 80);
  const CommonPiece before =
      between_heights(Rational(1, 2), {{-s0, 1, Rational(3, 2)}, {1, 0, 0}, {0, 0, -1}});
  ASSERT_TRUE(before.nearest({}));
  EXPECT_FALSE(before.nearest({})->is_reached);
  // The distance is less than 10 up to s1.
  const CommonPiece brief =
      between_heights(Rational(1, 2), {{10 - s1, 0, Rational(3, 2)}, {1, 0, 0}, {0, 0, -1}});
  EXPECT_EQ(brief.below(9, {}).size(), 1U);
  const CommonPiece none =
      between_heights(Rational(1, 2), {{10 - s0, 0, Rational(3, 2)}, {1, 0, 0}, {0, 0, -1}});
  EXPECT_TRUE(none.below(9, {}).empty());
}

// A straight way told as a curve gives the same exact answers.
TEST(CurvedClearance, StraightCurvesAreExact) {
  RandomPieces pieces(3);
  for (int round = 0; round < 40; ++round) {
    const GivenPaths curved = pieces.paths(3, 1, round % 2 == 0);
    GivenPaths given = curved;
    for (GivenPath& path : given.paths) path.curves.clear();
    const auto a = GivenClearance(curved, always).least(),
               b = GivenClearance(given, always).least();
    ASSERT_TRUE(a && b);
    EXPECT_TRUE(a->is_exact());
    EXPECT_EQ(a->t, b->t);
    EXPECT_EQ(a->distance2, b->distance2);
    EXPECT_EQ(std::pair(a->i, a->j), std::pair(b->i, b->j));
    EXPECT_EQ(GivenClearance(curved, always).spells_below(2).size(),
              GivenClearance(given, always).spells_below(2).size());
  }
}

// A disk that jumps over another is taken to go straight through it.
TEST(CurvedClearance, AJumpIsAWay) {
  GivenPaths given;
  given.paths = {straight("still", 1, {{0, {0, 0}}, {4, {0, 0}}}),
                 straight("jumps", 1, {{0, {-9, 0}}, {2, {-8, 0}}, {2, {8, 0}}, {4, {9, 0}}})};
  given.paths[1].curves.resize(3);
  const auto least = GivenClearance(given, always).least();
  ASSERT_TRUE(least);
  EXPECT_EQ(least->t, 2);
  EXPECT_EQ(least->distance2, 0);
  const auto spells = GivenClearance(given, always).spells_below(1);
  ASSERT_EQ(spells.size(), 1u);
  EXPECT_EQ(spells[0].from.lo, 2);
  EXPECT_EQ(spells[0].to.hi, 2);
}

// Two cross at different heights: true distances count the height, bands pass over it.
TEST(CurvedClearance, Heights) {
  GivenPaths given;
  given.in_space = true;
  given.paths = {straight("low", 1, {{0, {-5, 0, 0}}, {10, {5, 0, 0}}}),
                 straight("high", 1, {{0, {5, 0, 3}}, {10, {-5, 0, 3}}})};
  const auto space = GivenClearance(given, always).least();
  ASSERT_TRUE(space);
  EXPECT_EQ(space->distance2, 9);
  EXPECT_EQ(space->t, 5);
  EXPECT_FALSE(GivenClearance(given, always, {false, 3}).least());
  const auto band = GivenClearance(given, always, {false, Rational(31, 10)}).least();
  ASSERT_TRUE(band);
  EXPECT_EQ(band->distance2, 0);
  // One climbs through the other's band after it has passed below it.
  given.paths[1].waypoints = {{0, {0, 0, 10}}, {10, {0, 0, 0}}};
  const auto after = GivenClearance(given, always, {false, 2}).least();
  ASSERT_TRUE(after);
  EXPECT_EQ(after->t, 8);  // where the height is 2, and not before
  EXPECT_EQ(after->distance2, 9);
}

TEST(CurvedClearance, ImagesAcrossASide) {
  GivenPaths given;
  given.sides = {10, 0, 0};
  given.paths = {straight("a", 1, {{0, {1, 0}}, {1, {1, 0}}}),
                 straight("b", 1, {{0, {9, 1}}, {1, {9, 0}}})};
  const auto least = GivenClearance(given, always).least();
  ASSERT_TRUE(least);
  EXPECT_EQ(least->image, (LatticeImage{-1, 0, 0}));
  EXPECT_EQ(least->distance2, 4);
  EXPECT_EQ(least->t, 1);
  // Alone a disk is a side away from itself.
  given.paths.pop_back();
  const auto own = GivenClearance(given, always).least();
  ASSERT_TRUE(own);
  EXPECT_EQ(std::pair(own->i, own->j), std::pair(0, 0));
  EXPECT_EQ(own->distance2, 100);
  EXPECT_EQ(GivenClearance(given, always).spells_below(9).size(), 1u);
  EXPECT_TRUE(GivenClearance(given, always).spells_below(8).empty());
}

// Between frames nothing is known: two exchange their places.
TEST(CurvedClearance, FramesOnly) {
  GivenPaths given;
  given.paths = {straight("a", 1, {{0, {0, 0}}, {1, {9, 0}}}),
                 straight("b", 1, {{0, {9, 0}}, {1, {0, 0}}, {2, {0, 0}}})};
  const auto ways = GivenClearance(given, always).least();
  ASSERT_TRUE(ways);
  EXPECT_EQ(ways->distance2, 0);
  const GivenClearance frames(given, always, {true, {}});
  const auto least = frames.least();
  ASSERT_TRUE(least);
  EXPECT_EQ(least->distance2, 81);
  EXPECT_EQ(least->t, 0);
  EXPECT_EQ(frames.spells_below(8).size(), 2u);
}

// An overlap that is allowed, and contact where 0 is asked for.
TEST(CurvedClearance, Allowances) {
  const Approach touching{0, 1, 0, 4, 2}, overlapping{0, 1, 0, 1, 2};
  EXPECT_FALSE(keeps_clear(touching, 0, Touching::is_too_near));
  EXPECT_TRUE(falls_short(touching, 0, Touching::is_too_near));
  EXPECT_TRUE(keeps_clear(touching, 0, Touching::is_allowed));
  EXPECT_FALSE(keeps_clear(overlapping, 0, Touching::is_allowed));
  EXPECT_TRUE(keeps_clear(overlapping, -1, Touching::is_too_near));
  EXPECT_FALSE(keeps_clear(overlapping, Rational(-99, 100), Touching::is_too_near));
  EXPECT_TRUE(keeps_clear(overlapping, -3, Touching::is_too_near));
}

}  // namespace
}  // namespace voroproof::internal
