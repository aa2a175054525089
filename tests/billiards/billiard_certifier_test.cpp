// Histories of small billiards, derived by hand, and wrong ones.
#include "certify/billiards/billiard_certifier.h"

#include <gtest/gtest.h>

#include "history/error.h"
#include "tests/billiards/billiard_cases.h"

namespace voroproof::internal::testing {
namespace {

TEST(BilliardCertifier, HeadOn) {
  BilliardCase c = head_on();
  expect_certified(c);
  c.events = {R"({"t":2.0000005,"collide":[0,1],"v":[[0,0],[1,0]]})"};
  expect_certified(c);
  c.events = {R"({"t":1.9999995,"collide":[0,1],"v":[[0,0],[1,0]]})"};
  expect_certified(c);
  c.events = {R"({"t":2.000002,"collide":[0,1],"v":[[0,0],[1,0]]})"};
  expect_refuted(c, Fault::wrong_time, 2);
  c.events = {R"({"t":1.999998,"collide":[0,1],"v":[[0,0],[1,0]]})"};
  expect_refuted(c, Fault::wrong_time, 2);
  c.events = {R"({"t":2,"collide":[0,1],"v":[[0,0],[1,0.001]]})"};
  expect_refuted(c, Fault::wrong_response, 2);
  c.events = {R"({"t":2,"collide":[0,1],"v":[[0,0],[1.00000001,0]]})"};
  expect_refuted(c, Fault::wrong_response, 2);
  c.events = {R"({"t":2,"collide":[0,1],"v":[[0,0],[1,0]],"p":[[2,0.1],[4,0]]})"};
  expect_refuted(c, Fault::wrong_response, 2);
  c.events = {R"({"t":2,"collide":[0,1]})"};
  expect_certified(c);
  EXPECT_EQ(c.judge().computed_velocities, 1);
  // A centre may be off by the way of the tolerance, also at a velocity that is not claimed.
  c.events = {R"({"t":2,"collide":[0,1],"p":[[2,0],[4.0000005,0]]})"};
  expect_certified(c);
  c.events = {R"({"t":2,"collide":[0,1],"p":[[2,0],[4.000002,0]]})"};
  expect_refuted(c, Fault::wrong_response, 2);
}

TEST(BilliardCertifier, MissingAndRepeated) {
  BilliardCase c = head_on();
  c.events.clear();
  c.collisions = 0;
  expect_refuted(c, Fault::missing_event, 2);
  c = head_on();
  c.events.push_back(c.events.front());
  c.collisions = 2;
  EXPECT_EQ(c.judge().verdict, Verdict::refuted);
  c = head_on();
  c.collisions = 2;
  expect_refuted(c, Fault::bad_count, 3);
}

// Without restitution the two stay in touch; that is no second collision.
TEST(BilliardCertifier, RepeatedWithoutRestitution) {
  BilliardCase c{R"("restitution":0,"frame":"none","disks":[
    {"center":[0,0],"radius":1,"velocity":[1,0]},{"center":[4,0],"radius":1,"velocity":[0,0]}])",
                 "5",
                 {R"({"t":2,"collide":[0,1],"v":[[0.5,0],[0.5,0]]})"},
                 1};
  expect_certified(c);
  c.events.push_back(c.events.front());
  c.collisions = 2;
  EXPECT_EQ(c.judge().verdict, Verdict::refuted);
  // Nor do they approach where the velocities are rounded.
  c.events = {R"({"t":2,"collide":[0,1],"v":[[0.5,0],[0.49999999999999994,0]]})",
              R"({"t":2.0000005,"collide":[0,1],"v":[[0.5,0],[0.49999999999999994,0]]})"};
  EXPECT_EQ(c.judge().verdict, Verdict::refuted);
  // Claimed late, they stay in each other.
  c.events = {R"({"t":2.0000005,"collide":[0,1],"v":[[0.5,0],[0.5,0]]})"};
  c.collisions = 1;
  expect_refuted(c, Fault::overlap, 2);
}

// A window of time ends after so many claims, wherever that is: here at a claim of 0 and 1, which
// have overlapped for long, but by less than the rounding.
TEST(BilliardCertifier, ThroughTheSideOfTheBox) {
  BilliardCase c{R"("dimension":3,"frame":{"periodic":[8,8,8]},"disks":[
    {"center":[1,4,4],"radius":0.5,"velocity":[-1,0,0]},
    {"center":[6,4,4],"radius":0.5,"velocity":[1,0,0]}])",
                 "5",
                 {R"({"t":1,"collide":[0,1],"image":[-1,0,0],"v":[[1,0,0],[-1,0,0]]})",
                  R"({"t":4,"collide":[0,1],"image":[0,0,0],"v":[[-1,0,0],[1,0,0]]})"},
                 2};
  expect_certified(c);
  BilliardCase unnamed = c;
  unnamed.events[0] = R"({"t":1,"collide":[0,1],"v":[[1,0,0],[-1,0,0]]})";
  unnamed.events[1] = R"({"t":4,"collide":[0,1],"v":[[-1,0,0],[1,0,0]]})";
  expect_certified(unnamed);
  BilliardCase wrong = c;
  wrong.events[0] = R"({"t":1,"collide":[0,1],"image":[1,0,0],"v":[[1,0,0],[-1,0,0]]})";
  expect_refuted(wrong, Fault::wrong_image, 2);
  wrong = c;
  wrong.events[1] = R"({"t":4,"collide":[0,1],"image":[-1,0,0],"v":[[-1,0,0],[1,0,0]]})";
  expect_refuted(wrong, Fault::wrong_image, 3);
  // A ball that leaves on the left and is seen on the right is no other ball.
  wrong = c;
  wrong.events.erase(wrong.events.begin());
  wrong.collisions = 1;
  expect_refuted(wrong, Fault::missing_event, 2);
}

// Lees-Edwards: the image above moves to the right at 1/2 * 4 = 2 and meets disk 0, which rises.
TEST(BilliardCertifier, ShearedImages) {
  BilliardCase c{R"("frame":{"periodic":[16,4],"shear":"1/2"},"disks":[
    {"center":[4,1],"radius":0.5,"velocity":[0,0]},
    {"center":[0,1],"radius":0.5,"velocity":[0,-1]}])",
                 "2.5",
                 {},
                 0};
  // LatticeImage (0, 1) of disk 1 is at (2 t, 5 - t): it passes (4, 3) at 2, and (4.5, 2.75)
  // at 2.25.
  expect_certified(c);
  c.members = R"("frame":{"periodic":[16,4],"shear":"1/2"},"disks":[
    {"center":[4,1],"radius":0.5,"velocity":[0,0]},
    {"center":[-1,1],"radius":0.5,"velocity":[0,0]}])";
  // LatticeImage (0, 0) is at rest: only one that drifts along at a distance of 4 could meet.
  expect_certified(c);
  c.members = R"("frame":{"periodic":[16,4],"shear":"1/2"},"disks":[
    {"center":[4,1],"radius":0.5,"velocity":[0,0]},
    {"center":[0,-3],"radius":0.5,"velocity":[0,0]}])";
  // LatticeImage (0, 1) of disk 1 is at (2 t, 1): it touches disk 0 at 3/2, moving at 2.
  expect_refuted(c, Fault::missing_event, 2);
  c.collisions = 1;
  c.events = {R"({"t":1.5,"collide":[0,1],"image":[0,1],"v":[[2,0],[-2,0]]})"};
  expect_certified(c);
}

TEST(BilliardCertifier, Walls) {
  const std::string box = R"("frame":{"walls":[
    {"normal":[1,0],"offset":0},{"normal":[0,1],"offset":0},
    {"normal":[-1,0],"offset":-10},{"normal":[0,-1],"offset":-10}]},)";
  BilliardCase c{box + R"("disks":[{"center":[5,5],"radius":1,"velocity":[1,0]}])",
                 "6",
                 {R"({"t":4,"collide":[-3,0],"v":[null,[-1,0]],"p":[null,[9,5]]})"},
                 1};
  expect_certified(c);
  BilliardCase wrong = c;
  wrong.events = {R"({"t":4,"collide":[-1,0],"v":[null,[-1,0]]})"};
  EXPECT_EQ(wrong.judge().verdict, Verdict::refuted);
  wrong.events.clear();
  wrong.collisions = 0;
  expect_refuted(wrong, Fault::missing_event, 2);  // it leaves the box
  // Into a corner: both walls at one instant, in either order, but not one alone.
  BilliardCase corner{box + R"("disks":[{"center":[5,5],"radius":1,"velocity":[1,1]}])",
                      "6",
                      {R"({"t":4,"collide":[-4,0],"v":[null,[1,-1]]})",
                       R"({"t":4,"collide":[-3,0],"v":[null,[-1,-1]]})"},
                      2};
  expect_certified(corner);
  corner.events = {R"({"t":4,"collide":[-3,0],"v":[null,[-1,1]]})",
                   R"({"t":4,"collide":[-4,0],"v":[null,[-1,-1]]})"};
  expect_certified(corner);
  corner.events = {R"({"t":4,"collide":[-3,0],"v":[null,[-1,1]]})"};
  corner.collisions = 1;
  expect_refuted(corner, Fault::missing_event, 3);
}

TEST(BilliardCertifier, AWallThatMovesAndOneThatIsSlanted) {
  BilliardCase c{
      R"("frame":{"walls":[{"normal":["3/5","4/5"],"offset":-5,"speed":1,"restitution":"1/2"}]},
    "disks":[{"center":[0,0],"radius":1,"velocity":["-3/5","-4/5"]}])",
      "3",
      {R"({"t":2,"collide":[-1,0],"v":[null,["6/5","8/5"]]})"},
      1};
  // The gap is 5 - 1 - t - t; the velocity of approach 2, of departure 1 from a wall that follows
  // at 1.
  expect_certified(c);
  c.events = {R"({"t":2,"collide":[-1,0],"v":[null,["3/5","4/5"]]})"};
  expect_refuted(c, Fault::wrong_response, 2);
}

// It comes to one that rests.
TEST(BilliardCertifier, AWallThatComes) {
  BilliardCase c{R"("frame":{"walls":[{"normal":[1,0],"offset":-6,"speed":1}]},"disks":[
    {"center":[0,0],"radius":1,"velocity":[0,0]},{"center":[40,0],"radius":1,"velocity":[-1,0]}])",
                 "8",
                 {R"({"t":5,"collide":[-1,0],"v":[null,[2,0]]})"},
                 1};
  expect_certified(c);
  c.events.clear();
  c.collisions = 0;
  expect_refuted(c, Fault::missing_event, 2);
}

TEST(BilliardCertifier, ASphere) {
  BilliardCase c{R"("dimension":3,"frame":{"center":[1,0,0],"radius":10},
    "disks":[{"center":[1,0,0],"radius":1,"velocity":[1,2,2]}])",
                 "5",
                 {R"({"t":3,"collide":[-1,0],"v":[null,[-1,-2,-2]],"p":[null,[4,6,6]]})"},
                 1};
  expect_certified(c);
  c.events.clear();
  c.collisions = 0;
  expect_refuted(c, Fault::missing_event, 2);
}

TEST(BilliardCertifier, UnderGravity) {
  BilliardCase floor{R"("frame":{"walls":[{"normal":[0,1],"offset":0}]},"gravity":[0,-1],
    "disks":[{"center":[0,3],"radius":1,"velocity":[1,0]}])",
                     "7",
                     {R"({"t":2,"collide":[-1,0],"v":[null,[1,2]],"p":[null,[2,1]]})",
                      R"({"t":6,"collide":[-1,0],"v":[null,[1,2]],"p":[null,[6,1]]})"},
                     2};
  expect_certified(floor);
  floor.events.pop_back();
  floor.collisions = 1;
  expect_refuted(floor, Fault::missing_event, 3);
  // On top of a fixed disk, which neither falls nor moves.
  BilliardCase pillar{R"("frame":"none","gravity":[0,-1],"disks":[
    {"center":[0,4],"radius":1,"velocity":[0,0]},{"center":[0,0],"radius":1,"fixed":true}])",
                      "7",
                      {R"({"t":2,"collide":[0,1],"v":[[0,2],null]})",
                       R"({"t":6,"collide":[0,1],"v":[[0,2],[0,0]]})"},
                      2};
  expect_certified(pillar);
  pillar.events[0] = R"({"t":2,"collide":[0,1],"v":[[0,0],null]})";
  expect_refuted(pillar, Fault::wrong_response, 2);
  // Two that fall alike never meet, whatever the gravity.
  expect_certified({R"("frame":"none","gravity":[0,-3],"disks":[
    {"center":[0,4],"radius":1,"velocity":[1,0]},{"center":[0,0],"radius":1,"velocity":[1,0]}])",
                    "9",
                    {}});
}

TEST(BilliardCertifier, GrowingDisks) {
  BilliardCase c{R"("frame":"none","disks":[
    {"center":[0,0],"radius":1,"velocity":[0,0],"growth":0.5,"mass":1},
    {"center":[4,0],"radius":1,"velocity":[0,0],"growth":0.5,"mass":1}])",
                 "4",
                 {R"({"t":2,"collide":[0,1],"v":[[-1,0],[1,0]]})"},
                 1};
  expect_certified(c);
  c.events = {R"({"t":2,"collide":[0,1],"v":[[0,0],[0,0]]})"};
  expect_refuted(c, Fault::wrong_response, 2);
  c.events.clear();
  c.collisions = 0;
  expect_refuted(c, Fault::missing_event, 2);
}

// Three in a row touch at one instant: two collisions, of which the second comes of the first.
TEST(BilliardCertifier, Cradle) {
  BilliardCase c{R"("frame":"none","disks":[
    {"center":[0,0],"radius":1,"velocity":[1,0]},
    {"center":[4,0],"radius":1,"velocity":[0,0]},
    {"center":[6,0],"radius":1,"velocity":[0,0]}])",
                 "5",
                 {R"({"t":2,"collide":[0,1],"v":[[0,0],[1,0]]})",
                  R"({"t":2,"collide":[1,2],"v":[[0,0],[1,0]]})"},
                 2};
  expect_certified(c);
  std::swap(c.events[0], c.events[1]);
  EXPECT_EQ(c.judge().verdict, Verdict::refuted);
  c.events = {R"({"t":2,"collide":[0,1],"v":[[0,0],[1,0]]})"};
  c.collisions = 1;
  expect_refuted(c, Fault::missing_event, 3);
}

TEST(BilliardCertifier, Grazes) {
  BilliardCase c{R"("frame":"none","disks":[
    {"center":[0,0],"radius":1,"velocity":[1,0]},{"center":[4,2],"radius":1,"velocity":[0,0]}])",
                 "8",
                 {}};
  expect_certified(c);
  c.events = {R"({"t":4,"collide":[0,1],"v":[[1,0],[0,0]]})"};
  c.collisions = 1;
  expect_certified(c);
  EXPECT_EQ(c.judge().grazes, 1);
  c.events = {R"({"t":4.1,"collide":[0,1],"v":[[1,0],[0,0]]})"};
  EXPECT_EQ(c.judge().verdict, Verdict::refuted);
  // Once, though both are within the tolerance of it.
  c.events = {R"({"t":3.9999999999,"collide":[0,1],"v":[[1,0],[0,0]]})",
              R"({"t":4,"collide":[0,1],"v":[[1,0],[0,0]]})"};
  c.collisions = 2;
  EXPECT_EQ(c.judge().verdict, Verdict::refuted);
  // A little nearer, and it is a collision that is missing.
  c.events.clear();
  c.collisions = 0;
  c.members = R"("frame":"none","disks":[
    {"center":[0,0],"radius":1,"velocity":[1,0]},{"center":[4,1.9999999],"radius":1,"velocity":[0,0]}])";
  EXPECT_EQ(c.judge().verdict, Verdict::refuted);
}

TEST(BilliardCertifier, TheHorizon) {
  BilliardCase c = head_on();
  c.horizon = "2";
  expect_certified(c);
  EXPECT_EQ(c.judge().at_horizon, 1);
  c.events.clear();
  c.collisions = 0;
  expect_certified(c);
  EXPECT_EQ(c.judge().left_out, 1);
  c.horizon = "2.0000005";
  expect_certified(c);
  EXPECT_EQ(c.judge().left_out, 1);
  c.horizon = "2.000002";
  expect_refuted(c, Fault::missing_event, 2);
}

// What comes after it stops is not missing; what comes before is.
TEST(BilliardCertifier, HistoriesThatStop) {
  BilliardCase c = head_on();
  c.members.insert(c.members.size() - 1, R"(,{"center":[8,0],"radius":1,"velocity":[0,0]})");
  c.horizon = "9";
  const auto verdict = [&](const std::string& t) {
    c.last = R"({"stopped":{"t":)" + t + R"(,"reason":"a limit"}})";
    return c.judge().verdict;
  };
  // The next collision is that of 1 and 2, at t = 4.
  for (const char* const t : {"2", "3", "4", "4.0000005"})
    EXPECT_EQ(verdict(t), Verdict::undecided) << t;
  EXPECT_EQ(verdict("4.1"), Verdict::refuted);
  c.events.clear();
  EXPECT_EQ(verdict("2"), Verdict::undecided);
  EXPECT_EQ(verdict("3"), Verdict::refuted);
  c.members += R"(,"maneuvers":[{"t":1,"disk":1,"velocity":[0,0]}])";
  EXPECT_EQ(verdict("1"), Verdict::undecided);
  EXPECT_EQ(verdict("1.5"), Verdict::refuted);
}

TEST(BilliardCertifier, Maneuvers) {
  BilliardCase c{R"("frame":"none","disks":[
    {"center":[0,0],"radius":1,"velocity":[1,0]},{"center":[4,0],"radius":1,"velocity":[0,0]}],
    "maneuvers":[{"t":1,"disk":0,"velocity":[0,1]}])",
                 "5",
                 {R"({"t":1,"maneuver":0,"v":[0,1],"p":[1,0]})"},
                 0,
                 1};
  expect_certified(c);
  c.events = {R"({"t":1,"maneuver":0})"};
  expect_certified(c);
  c.events = {R"({"t":1,"maneuver":0,"v":[0,2]})"};
  expect_refuted(c, Fault::wrong_response, 2);
  c.events = {R"({"t":1.1,"maneuver":0})"};
  expect_refuted(c, Fault::missing_event, 2);
  c.events = {R"({"t":1,"maneuver":1})"};
  c.maneuvers = 1;
  EXPECT_EQ(c.judge().verdict, Verdict::refuted);
  c.events.clear();
  c.maneuvers = 0;
  expect_refuted(c, Fault::missing_event, 2);
}

TEST(BilliardCertifier, FewDisks) {
  expect_certified({R"("frame":"none","disks":[])", "5", {}});
  expect_certified(
      {R"("frame":{"periodic":[3,3]},"disks":[{"center":[0,0],"radius":1,"velocity":[1,2]}])",
       "1000",
       {}});
  expect_certified(
      {R"("frame":{"periodic":[3,3]},"disks":[{"center":[0,0],"radius":1,"velocity":[1,2]}])",
       "0",
       {}});
  expect_certified(
      {R"("frame":"none","disks":[{"center":[0,0],"radius":1,"fixed":true}])", "5", {}});
}

// Bystanders far away, fast or slow, change the windows of time and nothing else.
// Three would touch at one instant of a late clock. Its rounded time is late, so that the pair that
// does not collide overlaps for a moment, by more than the size of the scene explains.
// A ball that bounces once a unit of time, for longer than a window has claims.
// Far from everything, at a speed of its own.
// One runs past 10^5 images of the other, in a window that its slow beginning made long.
// Nothing happens for long: windows become longer, as many as there would be else.
TEST(BilliardCertifier, DisksThatAreNotInTheirPlaces) {
  const auto fault = [](const std::string& members) {
    try {
      BilliardCase{members, "1", {}}.judge();
    } catch (const InputError& error) {
      const std::string what = error.what();
      return what.substr(what.find("disks"));
    }
    return std::string("none");
  };
  EXPECT_EQ(fault(R"("frame":{"periodic":[8,8]},"disks":[
    {"center":[0.5,1],"radius":1,"velocity":[0,0]},{"center":[7.75,1],"radius":1,"velocity":[0,0]}])"),
            "disks[1]: overlaps: disk 0 and disk 1 at image [-1,0] are at a distance below the sum "
            "of their radii");
  EXPECT_EQ(fault(R"("frame":{"walls":[{"normal":[0,1],"offset":0}]},"disks":[
    {"center":[0,0.5],"radius":1,"velocity":[0,0]}])"),
            "disks[0]: is not wholly inside of wall -1");
  EXPECT_EQ(fault(R"("frame":{"center":[0,0],"radius":1},"disks":[
    {"center":[0,0],"radius":2,"velocity":[0,0]}])"),
            "disks[0].radius: the disk does not fit into the frame up to the horizon");
}

}  // namespace
}  // namespace voroproof::internal::testing
