// Points that meet: there is no diagram at that instant, and runs stop before it.
#include <gtest/gtest.h>

#include <string>

#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {
namespace {

// Two points graze a disk from two sides, at (0, 0) at t = 1; the second passes so far below.
// `fourth`: another disk, so that the points are neighbours of two disks.
Scene two_at_a_disk(const Rational& below, bool fourth) {
  std::vector<DiskInput> disks{disk(-1, 0, 0, 1, 0, 1), disk(1, Rational(-below), 0, -1, 0, 1),
                               disk(0, 2, 2, 0, 0, 1)};
  if (fourth) disks.push_back(disk(0, 7, Rational(1, 2), 0, 0, 1));
  return scene_of(10, 2, disks);
}

TEST(EnginePoints, ThatMeetAtADiskStopTheRun) {
  for (const bool fourth : {false, true}) {
    const RecordedRun stopped = run(two_at_a_disk(0, fourth));
    EXPECT_EQ(stopped.outcome.kind, Outcome::Kind::stopped);
    EXPECT_NE(stopped.outcome.reason.find("two points meet at a disk"), std::string::npos);
    EXPECT_LT(stopped.outcome.t, 1);
    EXPECT_TRUE(run(two_at_a_disk(Rational(1, 1024), fourth)).complete());
  }
}

TEST(EnginePoints, ThatTurnBeforeDoNotMeet) {
  Scene scene = two_at_a_disk(0, true);
  scene.maneuvers.push_back({Rational(1, 2), 1, Rational(-1), Rational(-1, 2)});
  EXPECT_TRUE(run(scene).complete());
  // At the very instant it is too late.
  scene.maneuvers.front().t = 1;
  EXPECT_EQ(run(scene).outcome.kind, Outcome::Kind::stopped);
}

TEST(EnginePoints, ThatWouldMeetAfterTheHorizonDoNotStopTheRun) {
  Scene scene = two_at_a_disk(0, true);
  scene.horizon = Rational(999, 1000);
  EXPECT_TRUE(run(scene).complete());
  scene.horizon = 1;
  EXPECT_EQ(run(scene).outcome.kind, Outcome::Kind::stopped);
}

TEST(EnginePoints, ThatMeetAsNeighboursStopTheRun) {
  const RecordedRun stopped =
      run(scene_of(10, 2, {disk(-1, 0, 0, 1, 0, 1), disk(1, 0, 0, -1, 0, 1)}));
  EXPECT_EQ(stopped.outcome.kind, Outcome::Kind::stopped);
  EXPECT_NE(stopped.outcome.reason.find("two points meet"), std::string::npos);
}

}  // namespace
}  // namespace voroproof::internal::testing
