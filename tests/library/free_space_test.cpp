// Where a probe fits, by the library's headers alone: two disks by hand. The answers of larger
// scenes are compared with brute force in tests/queries.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <variant>
#include <vector>

#include "tests/library/scenes.h"
#include "voroproof/voroproof.h"

namespace {

using namespace voroproof;
using namespace voroproof::internal::testing;

void expect_encloses(const Enclosure& e, double value) {
  EXPECT_LE(e.lower, value);
  EXPECT_GE(e.upper, value);
  EXPECT_LT(e.upper - e.lower, 1e-12);
}

// The gap of the two is 4 at t = 0, that to the wall 6.
TEST(FreeSpaceOfALibrary, AtAnInstant) {
  Instant instant(two_disks(), 0);
  const std::vector<Void> whole = instant.voids(2);
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_EQ(whole[0].tunnels.size(), 3u);
  EXPECT_EQ(whole[0].vertices, (std::vector<std::array<int, 3>>{{-1, 0, 1}, {-1, 1, 0}}));
  EXPECT_EQ(instant.voids(Number("16/5")).size(), 2u);
  EXPECT_TRUE(instant.voids(5).empty());

  const CriticalRadii radii = instant.critical();
  ASSERT_EQ(radii.tunnels.size(), 3u);
  expect_encloses(radii.tunnels[2].closes, 2);
  EXPECT_EQ(radii.tunnels[2].at.kind, ClearancePlace::Kind::gate);
  EXPECT_EQ(radii.tunnels[2].at.generators, (std::vector<int>{0, 1}));
  ASSERT_EQ(radii.voids.size(), 2u);
  expect_encloses(radii.voids[0].vanishes, 10 - 112.0 / 22);

  const std::vector<OffsetArc> arcs = instant.offset(Number("5/2"));
  ASSERT_EQ(arcs.size(), 3u);
  EXPECT_FALSE(arcs[0].from);
  ASSERT_TRUE(arcs[1].from && arcs[1].to);
  expect_encloses(arcs[1].from->y, std::sqrt(3.25));
  EXPECT_THROW(instant.voids(-1), std::invalid_argument);
}

// The gap is 4 - 2t up to the collision at 2, and 2(t - 2) after it.
TEST(FreeSpaceOfALibrary, OverTime) {
  const Scene scene = two_disks();
  RecordedMotion motion(scene, simulate(scene));
  const std::vector<Opening> open = motion.tunnel_openings(0, 1, Number("1/2"), 0, 8);
  ASSERT_EQ(open.size(), 2u);
  expect_encloses(open[0].to, 1.5);
  expect_encloses(open[1].from, 2.5);
  const std::vector<VoidLife> lives = motion.void_lives(Number("16/5"), 0, 8);
  ASSERT_EQ(lives.size(), 6u);
  EXPECT_EQ(lives[2].before, (std::vector<std::size_t>{0, 1}));
  expect_encloses(lives[2].from, 0.4);
  const std::vector<Opening> fits = motion.void_openings({-1, 0, 1}, 5, 0, 8);
  ASSERT_EQ(fits.size(), 1u);
  expect_encloses(fits[0].from, 1 + std::sqrt(11.0));
  EXPECT_THROW(motion.void_lives(1, 3, 3), std::invalid_argument);
  EXPECT_THROW(motion.tunnel_openings(0, 0, 1, 0, 8), std::invalid_argument);
}

// A path that leads through the wall: the circles that the diagram speaks of are not there.
TEST(FreeSpaceOfALibrary, OfPathsThatDoNotFit) {
  const Scene scene = two_disks();
  History history = simulate(scene);
  auto& hit = std::get<CollisionEvent>(history.events.at(0));
  hit.velocity[0] = Vector{-40, 0};
  RecordedMotion motion(scene, history);
  EXPECT_THROW(motion.void_lives(1, 0, 8), InputError);
}

}  // namespace
