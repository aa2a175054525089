// Runs that take up another's history, against that other, whole.
#include <gtest/gtest.h>

#include <cmath>

#include "corpus/generate.h"
#include "history/resumption_point.h"
#include "tests/support/random_scenes.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {
namespace {

// Takes the run up after so many events, for `cuts` numbers of events between none and all.
void expect_same_from_everywhere(const Scene& scene, std::size_t cuts,
                                 const MotionOptions& options = {}) {
  const RecordedRun whole = run(scene, options);
  const std::size_t all = whole.events.size();
  for (std::size_t cut = 0; cut <= cuts; ++cut) {
    const std::size_t events = all * cut / cuts;
    const RecordedRun resumed = resume(scene, whole, events, options);
    ASSERT_EQ(difference(whole, resumed), "")
        << "after " << events << " of " << all << ": " << resumed.outcome.reason;
    EXPECT_EQ(whole.outcome.t, resumed.outcome.t);
    EXPECT_EQ(whole.outcome.reason, resumed.outcome.reason);
    EXPECT_EQ(whole.final_diagram, resumed.final_diagram);
    EXPECT_EQ(whole.stats.flips, resumed.stats.flips);
    EXPECT_EQ(whole.stats.disk_collisions, resumed.stats.disk_collisions);
    EXPECT_EQ(whole.stats.wall_collisions, resumed.stats.wall_collisions);
    EXPECT_EQ(whole.stats.maneuvers, resumed.stats.maneuvers);
    EXPECT_EQ(resumed.begins, 1);
  }
}

TEST(ResumptionPoint, IsTheLastPlaceWhereADoubleIsBetween) {
  ResumptionPoint point;
  EXPECT_EQ(point.events(), 0u);
  EXPECT_EQ(point.t0(), 0);
  point.see(1);
  EXPECT_EQ(point.events(), 0u);
  EXPECT_EQ(point.t0(), 0.5);
  point.see(2);
  EXPECT_EQ(point.events(), 1u);
  EXPECT_EQ(point.t0(), 1.5);
  // Nothing is between equal times, and nothing between neighbours.
  point.see(2);
  point.see(std::nextafter(2, 3));
  EXPECT_EQ(point.events(), 1u);
  const double two_up = std::nextafter(std::nextafter(std::nextafter(2, 3), 3), 3);
  point.see(two_up);
  EXPECT_EQ(point.events(), 4u);
  EXPECT_GT(point.t0(), std::nextafter(2, 3));
  EXPECT_LT(point.t0(), two_up);
}

TEST(EngineResumption, Reference) {
  for (const double density : {0.05, 0.4}) {
    ReferenceOptions options;
    options.n = 40;
    options.horizon = 60;
    options.density = density;
    expect_same_from_everywhere(generate_reference(options), 12);
  }
}

// Ties, and collisions whose ties are proved by symmetry much later.
TEST(EngineResumption, TiesAndMirrorSymmetry) {
  GridOptions options;
  options.n = 25;
  options.spacing = 2.5;
  options.horizon = 20;
  for (const auto motion : {GridOptions::Motion::random, GridOptions::Motion::shear}) {
    options.motion = motion;
    expect_same_from_everywhere(generate_grid(options), 12);
  }
}

TEST(EngineResumption, LawsManeuversAndLateStates) {
  Random random(6);
  for (int k = 0; k < 6; ++k) {
    Scene scene = random_scene({.n = 15, .rmin = 3, .rmax = 12, .maneuvers = 3 * k}, random);
    if (k % 3 == 1) scene.restitution = Rational(4, 5);
    if (k % 3 == 2) scene.law = ContainerLaw::whole;
    if (k % 3 == 2) scene.container_restitution = Rational(9, 10);
    MotionOptions options;
    options.late_states = k % 2 == 1;
    expect_same_from_everywhere(scene, 8, options);
  }
}

TEST(EngineResumption, FewDisksAndEventsAtZeroAndAtTheHorizon) {
  expect_same_from_everywhere(scene_of(10, 30, {}), 1);
  expect_same_from_everywhere(scene_of(10, 30, {disk(0, 0, 1, 1, 0)}), 3);
  expect_same_from_everywhere(scene_of(10, 30, {disk(-3, 0, 1, 1, 0), disk(3, 0, 1, -1, 0)}), 5);
  // They touch at 0; one reaches the wall at the horizon.
  expect_same_from_everywhere(scene_of(10, 8, {disk(-1, 0, 1, 1, 0), disk(1, 0, 1, -1, 0)}), 4);
}

// Collisions at right angles and cradles at one instant, a maneuver at that of a collision.
TEST(EngineResumption, InstantsOfManyEvents) {
  Scene cradle = scene_of(20, 40,
                          {disk(-6, 0, 1, 1, 0), disk(0, 0, 1, 0, 0), disk(6, 0, 1, -1, 0),
                           disk(0, 6, 1, 0, -1), disk(0, -6, 1, 0, 1)});
  expect_same_from_everywhere(cradle, 10);
  cradle.maneuvers.push_back({4, 1, Rational(1, 2), Rational(1, 3)});
  cradle.maneuvers.push_back({4, 3, Rational(0), Rational(1)});
  expect_same_from_everywhere(cradle, 10);
}

// A run that stops does so again where it is taken up.
TEST(EngineResumption, OfAStoppedRun) {
  Scene scene = scene_of(10, 1000, {disk(9, 0, 1, 0, Rational(1, 2))});
  scene.container_restitution = Rational(1, 2);
  scene.disks[0].vx = 1;
  const RecordedRun stopped = run(scene);
  ASSERT_EQ(stopped.outcome.kind, Outcome::Kind::stopped);
  const RecordedRun again = resume(scene, stopped, stopped.events.size());
  EXPECT_EQ(difference(stopped, again), "");
  EXPECT_EQ(again.outcome.reason, stopped.outcome.reason);
}

// What is told is held against what is computed.
TEST(EngineResumption, RefusesWhatIsOfAnotherRun) {
  ReferenceOptions options;
  options.n = 20;
  options.horizon = 40;
  const Scene scene = generate_reference(options);
  const RecordedRun whole = run(scene);
  const std::size_t all = whole.events.size();
  std::size_t collision = 0, flip = 0;
  while (whole.events[collision].kind != Event::Kind::collision) ++collision;
  while (whole.events[flip].kind != Event::Kind::flip) ++flip;
  ASSERT_LT(collision + 1, all);
  RecordedRun wrong = whole;
  wrong.events[collision].second.vx = std::nextafter(wrong.events[collision].second.vx, 100);
  EXPECT_THROW(resume(scene, wrong, all), OtherRun);
  wrong = whole;
  wrong.events[collision].t = std::nextafter(wrong.events[collision].t, 100);
  EXPECT_THROW(resume(scene, wrong, all), OtherRun);
  wrong = whole;
  wrong.events[collision].second.px = 0;
  EXPECT_THROW(resume(scene, wrong, all), OtherRun);
  wrong = whole;
  wrong.events[collision].i = wrong.events[collision].i == 3 ? 4 : 3;
  EXPECT_THROW(resume(scene, wrong, all), OtherRun);
  wrong = whole;
  wrong.events.erase(wrong.events.begin() + static_cast<std::ptrdiff_t>(flip));
  EXPECT_THROW(resume(scene, wrong, all - 1), OtherRun);
  wrong = whole;
  wrong.initial.pop_back();
  EXPECT_THROW(resume(scene, wrong, all), OtherRun);
  wrong = whole;
  wrong.events[0] = {Event::Kind::maneuver, whole.events[0].t, {}, 1, 1, {}, {}};
  EXPECT_THROW(resume(scene, wrong, all), OtherRun);
}

}  // namespace
}  // namespace voroproof::internal::testing
