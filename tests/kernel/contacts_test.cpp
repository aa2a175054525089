// Collisions that answer no entry, and overlaps that no collision answers: each history is wrong at
// one rule of docs/kernel.md, section 4, and has a neighbour that is right.
#include "tests/kernel/histories.h"

namespace voroproof_kernel {
namespace {

using Claims = std::vector<std::string>;

void expect(Verdict due, const std::string& scene, const Claims& claims,
            const std::string& horizon = "3", const std::string& initial = kTwo) {
  Options options;
  const Result r = check(scene, history_of(scene, claims, horizon, initial), options);
  EXPECT_EQ(r.verdict, due) << "line " << r.line << ": " << r.reason;
}

std::string disks(const std::string& first, const std::string& second) {
  return first + "," + second;
}

// The overlap of the two is as small as the rounding: it is accepted where they part at once, and
// refuted where it lasts.
TEST(KernelContacts, TinyDisksThatStayInEachOther) {
  const std::string two = disks(disk("-1e-13", "0", "2.2e-14", "5e-11", "0"),
                                disk("1e-13", "0", "2.2e-14", "-5e-11", "0"));
  const std::string t = "{\"t\":0.0015605,\"collide\":[0,1],";
  expect(Verdict::certified, scene_of(two), {t + R"("v":[[-5e-11,0],[5e-11,0]]})"});
  expect(Verdict::refuted, scene_of(two, "3", ",\"restitution\":0"), {t + R"("v":[[0,0],[0,0]]})"});
}

// Two points that graze a disk from two sides meet there at t = 1: before that all is right, and
// from then on nothing is decided, whatever the edges do.
TEST(KernelContacts, PointsThatMeetAtADisk) {
  const std::string scenes = disk("-1", "0", "0", "1", "0") + "," + disk("1", "0", "0", "-1", "0") +
                             "," + disk("0", "2", "2", "0", "0") + "," +
                             disk("0", "7", "0.5", "0", "0");
  const std::string initial =
      "[[-1,0,2,2],[-1,1,2,2],[-1,2,0,3],[-1,2,1,0],[-1,2,3,1],[-1,3,2,2],[0,2,-1,-1],"
      "[1,2,-1,-1],[2,3,-1,-1]]";
  for (const Truth truth : {Truth::recorded, Truth::exact}) {
    EXPECT_EQ(verdict(scene_of(scenes, "0.5"), {}, truth, "0.5", initial), Verdict::certified);
    for (const std::string horizon : {"1", "1.5", "3"}) {
      EXPECT_EQ(verdict(scene_of(scenes, horizon), {}, truth, horizon, initial),
                Verdict::undecided);
    }
    const std::string turned =
        scene_of(scenes, "3", R"(,"maneuvers":[{"t":1,"disk":0,"velocity":[1,-1]}])");
    EXPECT_EQ(verdict(turned, {R"({"t":1,"maneuver":0,"v":[1,-1]})"}, truth, "3", initial),
              Verdict::undecided);
  }
}

// Two points that meet as neighbours, in the open and at the wall.
TEST(KernelContacts, PointsThatMeet) {
  const std::string open =
      scene_of(disks(disk("-1", "0", "0", "1", "0"), disk("1", "0", "0", "-1", "0")), "1");
  const std::string wall =
      scene_of(disks(disk("49", "-1", "0", "1", "1"), disk("49", "1", "0", "1", "-1")), "1");
  for (const Truth truth : {Truth::recorded, Truth::exact}) {
    EXPECT_EQ(verdict(open, {}, truth, "1"), Verdict::undecided);
    EXPECT_EQ(verdict(wall,
                      {R"({"t":1,"collide":[-1,0],"v":[null,[-1,1]]})",
                       R"({"t":1,"collide":[-1,1],"v":[null,[-1,-1]]})"},
                      truth, "1"),
              Verdict::undecided);
  }
}

// Claimed late, without restitution: what they have come into each other stays.
TEST(KernelContacts, AnsweredAndOn) {
  const std::string scene =
      scene_of(disks(disk("-1", "0", "1", "1", "0"), disk("1", "0", "1", "0", "0")), "3",
               ",\"restitution\":0");
  const std::string v = R"(,"collide":[0,1],"v":[[0.5,0],[0.5,0]]})";
  expect(Verdict::certified, scene, {"{\"t\":0" + v});
  expect(Verdict::refuted, scene, {"{\"t\":5e-7" + v});
}

// Two that rest in each other by a rounding, until a maneuver drives one into the other: claimed at
// once the collision is right, and later it answers an entry that is half a second past.
TEST(KernelContacts, DrivenOnAfterARest) {
  const std::string scene =
      scene_of(disks(disk("\"-0x1.000000000004p0\"", "0", "1", "\"0x1p-46\"", "0"),
                     disk("\"0x1.000000000004p0\"", "0", "1", "\"-0x1p-46\"", "0")),
               "3", R"(,"maneuvers":[{"t":1.5,"disk":0,"velocity":[1,0]}])");
  const std::string turn = R"({"t":1.5,"maneuver":0,"v":[1,0]})";
  const std::string v = R"(,"collide":[0,1],"v":[["-0x1p-46",0],[1,0]]})";
  expect(Verdict::certified, scene, {turn, "{\"t\":1.5" + v});
  expect(Verdict::refuted, scene, {turn, "{\"t\":1.5000005" + v});
}

// The disks are at rest for longer: a claim half a second after the turn answers nothing.
TEST(KernelContacts, ClaimedLongAfterAShallowEntry) {
  const std::string scene =
      scene_of(disks(disk("\"-0x1.000000000004p0\"", "0", "1", "\"0x1p-46\"", "0"),
                     disk("\"0x1.000000000004p0\"", "0", "1", "\"-0x1p-46\"", "0")),
               "3", R"(,"maneuvers":[{"t":1.125,"disk":0,"velocity":["0x1p-47",0]}])");
  const std::string turn = R"({"t":1.125,"maneuver":0,"v":["0x1p-47",0]})";
  const std::string v = R"(,"collide":[0,1],"v":[["-0x1p-46",0],["0x1p-47",0]]})";
  expect(Verdict::certified, scene, {turn, "{\"t\":1.125" + v});
  expect(Verdict::refuted, scene, {turn, "{\"t\":1.25" + v});
}

// Two overlap, a maneuver turns one back, and while they part a collision is claimed, which drives
// them into each other until the next maneuver.
TEST(KernelContacts, NoCollisionWhileTheyPart) {
  const std::string scene = scene_of(
      disks(disk("-1", "0", "1", "1", "0"), disk("1", "0", "1", "0", "0")), "3",
      R"(,"maneuvers":[{"t":1e-7,"disk":0,"velocity":[-1,0]},{"t":2e-7,"disk":1,"velocity":[5,0]}])");
  const std::string first = R"({"t":1e-7,"maneuver":0,"v":[-1,0]})";
  const std::string second = R"({"t":2e-7,"maneuver":1,"v":[5,0]})";
  expect(Verdict::certified, scene,
         {R"({"t":5e-8,"collide":[0,1],"v":[[0,0],[1,0]]})", first, second});
  expect(Verdict::refuted, scene,
         {first, R"({"t":1.5e-7,"collide":[0,1],"v":[[0,0],[-1,0]]})", second});
}

// A fast disk leaves the container, is turned back by a maneuver, and hits the other side: the one
// claim answers the second exit, and none the first.
TEST(KernelContacts, OneClaimAnswersOneExit) {
  const std::string rest = R"(,{"t":8e-7,"disk":0,"velocity":[0,0]}])";
  for (const bool leaves : {false, true}) {
    const std::string x = leaves ? "48" : "20";
    const std::string scene =
        scene_of(disks(disk(x, "0", "1", "2e8", "0"), disk("0", "30", "1", "0", "0")), "3",
                 R"(,"maneuvers":[{"t":1e-7,"disk":0,"velocity":[-2e8,0]})" + rest);
    const std::string hit = leaves ? "6.85e-7" : "5.45e-7";
    expect(leaves ? Verdict::refuted : Verdict::certified, scene,
           {R"({"t":1e-7,"maneuver":0,"v":[-2e8,0]})",
            "{\"t\":" + hit + R"(,"collide":[-1,0],"v":[null,[2e8,0]]})",
            R"({"t":8e-7,"maneuver":0,"v":[0,0]})"});
  }
}

// A graze may be claimed when it is, and at no other time.
TEST(KernelContacts, GrazeClaimedAtAnotherTime) {
  const std::string scene =
      scene_of(disks(disk("0", "0", "1", "0", "0"), disk("-4", "2", "1", "1", "0")), "8");
  expect(Verdict::certified, scene, {R"({"t":4,"collide":[0,1],"v":[[0,0],[1,0]]})"}, "8");
  // Half a second later, parting: the velocities obey the law.
  expect(Verdict::refuted, scene,
         {R"({"t":4.5,"collide":[0,1],"v":[["1/17","4/17"],["16/17","-4/17"]]})"}, "8");
}

// Two pass through each other sideways and are then parted by a flip, on lines that last from the
// beginning to the end. Smaller disks have the same flips and do not touch.
TEST(KernelContacts, PassingThroughAndPartedByAFlip) {
  const std::string initial =
      "[[-1,0,1,2],[-1,1,3,0],[-1,2,0,3],[-1,3,2,1],[0,1,-1,2],[0,2,1,-1],[1,2,3,0],[1,3,-1,2],"
      "[2,3,1,-1]]";
  const Claims flips = {R"({"t":10.141327529410143,"flip":[1,2,3,0]})",
                        R"({"t":13.273392557783733,"flip":[-1,0,1,2]})",
                        R"({"t":17.33974883299592,"flip":[2,3,0,-1]})",
                        R"({"t":21.60867247058986,"flip":[0,1,2,3]})"};
  for (const bool large : {false, true}) {
    const std::string r = large ? "1" : "0.5";
    std::string scene =
        scene_of(disk("-10", "1.875", r, "1", "0") + "," + disk("0", "0", r, "0", "0") + "," +
                     disk("8", "6", r, "0", "0") + "," + disk("8", "-5", r, "0", "0"),
                 "25");
    // Where the radii are equal the diagram depends on the sum of this one and theirs.
    if (!large) scene.replace(scene.find("\"radius\":50"), 11, "\"radius\":50.5");
    expect(large ? Verdict::refuted : Verdict::certified, scene, flips, "25", initial);
  }
}

// Two fast disks with the edge of two others between them: they may not collide, though they will
// touch within the tolerance.
TEST(KernelContacts, OnlyNeighboursCollide) {
  const std::string initial =
      "[[-1,0,3,2],[-1,1,2,3],[-1,2,0,1],[-1,3,1,0],[0,2,3,-1],[0,3,-1,2],[1,2,-1,3],[1,3,2,-1],"
      "[2,3,0,1]]";
  const std::string scene = scene_of(
      disk("-1.65", "0", "0.2", "1e6", "0") + "," + disk("0.65", "0", "0.2", "0", "0") + "," +
          disk("0", "0.5", "0.1", "0", "0") + "," + disk("0", "-0.5", "0.1", "0", "0"),
      "1.5e-6");
  expect(Verdict::refuted, scene, {R"({"t":1e-6,"collide":[0,1],"v":[[0,0],[1e6,0]]})"}, "1.5e-6",
         initial);
}

// A fast point enters a disk, is claimed to have hit it while it is inside, and leaves it
// elsewhere; or passes through it, is claimed to have hit it, and is turned away by a maneuver.
// With the third disk on the right it has other neighbours then, by no flip; with the third below
// it has the same. Cells that wind twice tell of the first, a proof anew of edges of the second.
TEST(KernelContacts, OtherNeighboursAfterAHiddenMoment) {
  for (const bool right : {true, false}) {
    for (const bool through : {false, true}) {
      const std::string third =
          right ? disk("5", "0", "1", "0", "0") : disk("0", "-8", "0.5", "0", "0");
      const std::string initial =
          right ? "[[-1,0,2,2],[-1,2,0,0],[0,1,2,2],[0,2,-1,1],[0,2,1,-1],[1,2,0,0]]"
                : "[[-1,0,1,2],[-1,0,2,1],[-1,1,0,0],[-1,2,0,0],[0,1,-1,-1],[0,2,-1,-1]]";
      const std::string point = through ? disk("1.6", "0.05", "0", "-3e6", "0")
                                        : disk("1.81", "0.29", "0", "-1087500", "65000");
      std::string scene =
          scene_of(disk("0", "0", "1", "0", "0") + "," + point + "," + third, "4e-6",
                   through ? R"(,"maneuvers":[{"t":9.1e-7,"disk":1,"velocity":[-3e5,0]}])" : "");
      scene.replace(scene.find("\"radius\":50"), 11, "\"radius\":10");
      scene.replace(scene.find("\"mass\":1"), 8, "\"mass\":1e12");
      Claims claims = {through ? R"({"t":9e-7,"collide":[0,1]})"
                               : R"({"t":1.6e-6,"collide":[0,1]})"};
      if (through) claims.push_back(R"({"t":9.1e-7,"maneuver":1})");
      const Result r = check(scene, history_of(scene, claims, "4e-6", initial), {});
      EXPECT_EQ(r.verdict, right ? Verdict::refuted : Verdict::certified) << r.reason;
      const char* why = through ? "collapses at 9e-07" : "turn 2 times";
      if (right) {
        EXPECT_NE(r.reason.find(why), std::string::npos) << r.reason;
      }
    }
  }
}

}  // namespace
}  // namespace voroproof_kernel
