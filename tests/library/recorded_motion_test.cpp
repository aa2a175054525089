// The motion that a history writes down, by hand and by other ways of the library.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <variant>

#include "tests/library/scenes.h"
#include "voroproof/voroproof.h"

namespace {

using namespace voroproof;
using namespace voroproof::internal::testing;

TEST(LibraryRecordedMotion, TwoDisksByHand) {
  const Scene scene = two_disks();  // they meet at t = 2 and at the wall at t = 8
  const History history = simulate(scene);
  RecordedMotion motion(scene, history);
  EXPECT_EQ(motion.positions(0), (std::vector<Vector>{{-3, 0}, {3, 0}}));
  EXPECT_EQ(motion.positions(2), (std::vector<Vector>{{-1, 0}, {1, 0}}));
  EXPECT_EQ(motion.positions(3.5), (std::vector<Vector>{{-2.5, 0}, {2.5, 0}}));
  EXPECT_EQ(motion.velocities(1), (std::vector<Vector>{{1, 0}, {-1, 0}}));
  EXPECT_EQ(motion.velocities(2), (std::vector<Vector>{{-1, 0}, {1, 0}}));
  // A time that is no binary64, rounded once: -3 + 1/3.
  EXPECT_EQ(motion.positions(Number("1/3"))[0][0], Number("-8/3").nearest());
  EXPECT_EQ(motion.gap(0, 1, 0), 4);
  EXPECT_EQ(motion.gap(1, 0, 2), 0);
  EXPECT_EQ(motion.gap(-1, 0, 0), 6);
  EXPECT_EQ(motion.gap(0, 1, Number("1/3")), Number("10/3").nearest());

  const LeastGap least = motion.least_gap(0, 1, 0, 8);
  EXPECT_EQ(least.t, Number(2));
  EXPECT_TRUE(least.contact);
  EXPECT_EQ(least.gap.upper, 0);
  const auto later = motion.least_gap(3, 8);
  ASSERT_TRUE(later.has_value());
  EXPECT_EQ(later->t, Number(3));
  EXPECT_EQ(later->gap.lower, 2);
  const auto near = motion.neighbours(0, 0, 8);
  ASSERT_EQ(near.size(), 2u);
  EXPECT_EQ(near[0].generator, container);
  EXPECT_EQ(near[1].generator, 1);
  EXPECT_EQ(near[1].to, Number(8));
}

TEST(LibraryRecordedMotion, AgreesWithTheReplayedDiagram) {
  const Scene scene = reference(30, 60);
  const History history = simulate(scene);
  const RecordedMotion motion(scene, history);
  for (const char* text : {"0", "1/7", "17", "41.3", "60"}) {
    const Number t(text);
    const Diagram diagram = diagram_at(scene, history, t);
    const auto positions = motion.positions(t);
    const auto velocities = motion.velocities(t);
    for (std::size_t g = 0; g < positions.size(); ++g) {
      EXPECT_EQ(positions[g], diagram.disks[g].center) << text << ' ' << g;
      EXPECT_EQ(velocities[g], diagram.disks[g].velocity) << text << ' ' << g;
    }
  }
}

TEST(LibraryRecordedMotion, HistoriesThatStopAndTimesBeyond) {
  const Scene scene = reference(10, 50);
  SimulateOptions options;
  options.max_events = 20;
  const History history = simulate(scene, options);
  ASSERT_FALSE(history.ending.complete);
  const RecordedMotion motion(scene, history);
  EXPECT_EQ(motion.positions(0).size(), 10u);
  EXPECT_THROW(motion.positions(history.ending.t), std::invalid_argument);
  EXPECT_THROW(motion.positions(-1), std::invalid_argument);
  const RecordedMotion whole(scene, simulate(scene));
  EXPECT_EQ(whole.positions(50).size(), 10u);
  EXPECT_THROW(whole.positions(50.5), std::invalid_argument);
  EXPECT_THROW(whole.gap(0, 10, 1), std::invalid_argument);
  EXPECT_THROW(whole.gap(3, 3, 1), std::invalid_argument);
}

TEST(LibraryRecordedMotion, NobodyAndOne) {
  Scene scene;
  scene.horizon = 1;
  EXPECT_TRUE(RecordedMotion(scene, simulate(scene)).positions(1).empty());
  scene.container_radius = 3;
  scene.disks = {disk(0, 0, 0, 0, 0)};
  RecordedMotion motion(scene, simulate(scene));
  EXPECT_EQ(motion.gap(0, -1, 0.5), 3);
  EXPECT_FALSE(motion.least_gap(0, 1).has_value());
}

TEST(LibraryRecordedMotion, RefusesWhatDoesNotTell) {
  const Scene scene = two_disks();
  History history = simulate(scene);
  EXPECT_THROW(RecordedMotion(reference(2, 8), history), InputError);
  for (Event& event : history.events) {
    if (auto* collision = std::get_if<CollisionEvent>(&event)) collision->center = {};
  }
  EXPECT_EQ(RecordedMotion(scene, history).positions(3.5),
            RecordedMotion(scene, simulate(scene)).positions(3.5));
  for (Event& event : history.events) {
    if (auto* collision = std::get_if<CollisionEvent>(&event)) collision->velocity = {};
  }
  EXPECT_THROW(RecordedMotion(scene, history), InputError);
}

}  // namespace
