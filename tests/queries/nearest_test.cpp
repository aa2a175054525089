// Near disks and closest pairs against all distances in 100 digits.
#include "library/queries/nearest.h"

#include <gtest/gtest.h>

#include <deque>
#include <numeric>
#include <set>

#include "tests/queries/brute_moment.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
namespace {

using Pair = std::pair<GenId, GenId>;

std::deque<BruteMoment> moments() {
  Random random(21);
  std::deque<BruteMoment> all;
  for (const int n : {1, 2, 3, 12, 40}) {
    all.emplace_back(random_scene({.n = n, .density = 0.3}, random));
    all.emplace_back(random_scene({.n = n, .rmin = 0.01, .rmax = 20}, random));
  }
  return all;
}

TEST(NearestDisks, OfRandomPoints) {
  Random random(4);
  for (BruteMoment& m : moments()) {
    for (int k = 0; k < 20; ++k) {
      const Point2 p{to_rational(uniform(random, -150, 150)),
                     to_rational(uniform(random, -150, 150))};
      const auto point = oracle::rounded(oracle::ExactCircle{p.x, p.y, 0});
      std::vector<GenId> order(m.disks.size());
      std::iota(order.begin(), order.end(), 0);
      std::sort(order.begin(), order.end(), [&](GenId a, GenId b) {
        return m.distance(a, point.x, point.y) < m.distance(b, point.x, point.y);
      });
      const auto nearest = nearest_disks(m.moment.motion, 0, p, 5, m.counts);
      ASSERT_EQ(nearest.size(), std::min<std::size_t>(5, order.size()));
      for (std::size_t i = 0; i < nearest.size(); ++i) {
        EXPECT_EQ(nearest[i].disk, order[i]);
        EXPECT_TRUE(contains(nearest[i].distance, m.distance(order[i], point.x, point.y)));
        EXPECT_TRUE(is_narrow(nearest[i].distance, 300));
        EXPECT_FALSE(nearest[i].tied);
      }
    }
  }
}

TEST(NearestDisks, TiesAreProved) {
  // Two at the distance sqrt(8) - 1, the third at sqrt(13) - 1.
  BruteMoment m(scene_of(20, 1, {disk(2, 2, 1, 0, 0), disk(-2, 2, 1, 0, 0), disk(3, -2, 1, 0, 0)}));
  const auto nearest = nearest_disks(m.moment.motion, 0, {0, 0}, 9, m.counts);
  ASSERT_EQ(nearest.size(), 3u);
  EXPECT_EQ(nearest[0].disk, 0);
  EXPECT_FALSE(nearest[0].tied);
  EXPECT_EQ(nearest[1].disk, 1);
  EXPECT_TRUE(nearest[1].tied);
  EXPECT_EQ(nearest[2].disk, 2);
  EXPECT_FALSE(nearest[2].tied);
  // A hair's breadth is none.
  BruteMoment n(
      scene_of(20, 1,
               {disk(Rational(2) + Rational(1, Integer("1" + std::string(60, '0'))), 2, 1, 0, 0),
                disk(-2, 2, 1, 0, 0)}));
  const auto order = nearest_disks(n.moment.motion, 0, {0, 0}, 2, n.counts);
  EXPECT_EQ(order[0].disk, 1);
  EXPECT_FALSE(order[1].tied);
}

TEST(Neighbours, AreThoseOfTheEdges) {
  for (BruteMoment& m : moments()) {
    Clearance clearance = m.clearance_for(0);
    for (GenId g = 0; g < m.size(); ++g) {
      std::map<GenId, int> expected;
      for (const Quad& q : m.moment.diagram.quads()) {
        if (q.l == g) ++expected[q.r];
        if (q.r == g) ++expected[q.l];
      }
      if (m.size() == 1) expected[container_id] = 1;
      std::map<GenId, int> found;
      for (const Neighbour& n : neighbours(clearance, g)) {
        found[n.generator] = n.edges;
        EXPECT_TRUE(contains(n.gap, m.gap(g, n.generator)));
        EXPECT_TRUE(is_narrow(n.gap, 300));
      }
      EXPECT_EQ(found, expected);
    }
  }
}

void expect_closest(BruteMoment& m) {
  Clearance clearance = m.clearance_for(0);
  for (const bool disks_only : {false, true}) {
    const ClosestPairs closest =
        disks_only ? closest_disks(clearance) : closest_generators(clearance);
    std::vector<Pair> best;
    Real least = 0;
    for (GenId j = 0; j < m.size(); ++j) {
      for (GenId i = disks_only ? 0 : container_id; i < j; ++i) {
        const Real gap = m.gap(i, j), difference = gap - least;
        if (best.empty() || difference < -1e-60) best.clear();
        if (best.empty()) least = gap;
        if (best.empty() || abs(difference) < 1e-60) best.emplace_back(i, j);
      }
    }
    std::sort(best.begin(), best.end());
    EXPECT_EQ(closest.pairs, best) << disks_only;
    if (!best.empty()) {
      EXPECT_LE(Real(closest.gap.lo), least + 1e-60);
      EXPECT_GE(Real(closest.gap.hi), least - 1e-60);
    }
  }
}

TEST(ClosestPairs, OfRandomScenes) {
  for (BruteMoment& m : moments()) expect_closest(m);
}

TEST(ClosestPairs, AllOfALattice) {
  std::vector<DiskInput> disks;
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y < 4; ++y) disks.push_back(disk(3 * x, 3 * y, 1, 0, 0));
  }
  BruteMoment m(scene_of(40, 1, disks));
  expect_closest(m);
}

// Two small disks on the wall and one above them: the pair at the wall is closest, but the circles
// that touch both and stay in the container meet the third.
TEST(ClosestPairs, OfDisksNeedNotBeNeighbours) {
  const Rational r(1, 100);
  const auto on_wall = [&](const Rational& x) {
    // Far below the middle of a wide container the wall is nearly straight.
    return disk(x, Rational(-1000) + Rational(2, 100), r, 0, 0);
  };
  BruteMoment m(scene_of(1000, 1,
                         {on_wall(Rational(51, 100)), on_wall(Rational(-51, 100)),
                          disk(0, Rational(-1000) + Rational(92, 100), r, 0, 0)}));
  for (const Quad& q : m.moment.diagram.quads()) {
    EXPECT_NE(std::minmax(q.l, q.r), std::minmax(0, 1));
  }
  Clearance clearance = m.clearance_for(0);
  EXPECT_EQ(closest_disks(clearance).pairs, (std::vector<Pair>{{0, 1}}));
  expect_closest(m);
}

TEST(ClosestPairs, NoDisksAndTouchingOnes) {
  BruteMoment none(scene_of(10, 1, {}));
  Clearance empty = none.clearance_for(0);
  EXPECT_TRUE(closest_generators(empty).pairs.empty());
  BruteMoment touching(scene_of(10, 1, {disk(-1, 0, 1, 0, 0), disk(1, 0, 1, 0, 0)}));
  Clearance clearance = touching.clearance_for(0);
  const ClosestPairs closest = closest_generators(clearance);
  EXPECT_EQ(closest.pairs, (std::vector<Pair>{{0, 1}}));
  EXPECT_TRUE(contains(closest.gap, 0));
}

}  // namespace
}  // namespace voroproof::internal::testing
