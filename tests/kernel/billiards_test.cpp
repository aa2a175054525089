// Billiards of one to three disks, right and wrong, by hand.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "certify/kernel/files.h"
#include "certify/kernel/kernel.h"

namespace voroproof_kernel {
namespace {

std::string scene_of(const std::string& frame, const std::string& disks,
                     const std::string& more = "", const std::string& horizon = "2") {
  return R"({"format":"voroproof-scene","version":2,"contacts":"bounce","horizon":)" + horizon +
         ",\"frame\":" + frame + more + ",\"disks\":[" + disks + "]}";
}

std::string disk(const std::string& center, const std::string& velocity,
                 const std::string& more = "") {
  return "{\"center\":" + center + ",\"radius\":1,\"velocity\":" + velocity + more + "}";
}

std::string history_of(const std::string& scene, const std::vector<std::string>& claims,
                       const std::string& horizon = "2") {
  int collisions = 0;
  std::string lines = R"({"format":"voroproof-history","version":2,"scene_sha256":")" +
                      sha256(scene) + "\",\"horizon\":" + horizon + ",\"producer\":\"hand\"}\n";
  for (const std::string& c : claims) {
    collisions += c.find("collide") != std::string::npos;
    lines += c + "\n";
  }
  return lines + "{\"end\":{\"t\":" + horizon + ",\"collisions\":" + std::to_string(collisions) +
         ",\"maneuvers\":" + std::to_string(static_cast<int>(claims.size()) - collisions) + "}}\n";
}

Result judged(const std::string& scene, const std::vector<std::string>& claims,
              const std::string& horizon = "2", const Options& options = {}) {
  return check(scene, history_of(scene, claims, horizon), options);
}

void expect(Verdict verdict, const std::string& scene, const std::vector<std::string>& claims,
            std::int64_t line = 0) {
  const Result r = judged(scene, claims);
  EXPECT_EQ(r.verdict, verdict) << r.reason;
  EXPECT_EQ(r.line, line) << r.reason;
}

const std::string kBox = R"({"periodic":[10,null],"walls":[{"normal":[0,1],"offset":0},)"
                         R"({"normal":[0,-1],"offset":-10}]})";
const std::string kAcross = scene_of(kBox, disk("[1,5]", "[-2,0]") + "," + disk("[7,5]", "[0,0]") +
                                               R"(,{"center":[4,2],"radius":1,"fixed":true})");
const std::string kMeet =
    R"({"t":1,"collide":[0,1],"image":[-1,0],"v":[[0,0],[-2,0]],"p":[[-1,5],[7,5]]})";

TEST(KernelBilliards, AcrossAPeriodicAxis) {
  expect(Verdict::certified, kAcross, {kMeet});
  // The nearest image is meant where none is named, and none of the law's numbers is needed.
  expect(Verdict::certified, kAcross, {R"({"t":1,"collide":[0,1]})"});
  expect(Verdict::refuted, kAcross, {}, 2);
  expect(Verdict::refuted, kAcross, {R"({"t":1,"collide":[0,1],"image":[0,0]})"}, 2);
  expect(Verdict::refuted, kAcross, {kMeet, kMeet}, 3);
  expect(Verdict::refuted, kAcross, {R"({"t":1,"collide":[0,1],"v":[[0,1e-8],[-2,0]]})"}, 2);
  expect(Verdict::refuted, kAcross, {R"({"t":1,"collide":[0,1],"p":[[-1,5],[7,5.00001]]})"}, 2);
  // A centre may be off by the way of the tolerance, also at a velocity that is not claimed.
  expect(Verdict::certified, kAcross, {R"({"t":1,"collide":[0,1],"p":[[-1,5],[7.000001,5]]})"});
  expect(Verdict::refuted, kAcross, {R"({"t":1,"collide":[0,1],"p":[[-1,5],[7.00001,5]]})"}, 2);
  expect(Verdict::refuted, kAcross, {R"({"t":0.99999,"collide":[0,1]})"}, 2);
  expect(Verdict::refuted, kAcross, {R"({"t":1.00001,"collide":[0,1]})"}, 2);
  expect(Verdict::certified, kAcross, {R"({"t":1.0000009,"collide":[0,1]})"});
}

TEST(KernelBilliards, CountsAndHorizon) {
  const std::string right = history_of(kAcross, {kMeet});
  std::string wrong = right;
  wrong.replace(wrong.find("\"collisions\":1"), 14, "\"collisions\":2");
  EXPECT_EQ(check(kAcross, wrong, {}).reason, "bad count");
  EXPECT_EQ(check(kAcross, wrong, {}).line, 3);
  // At the horizon they touch and approach; a little before is excused, too.
  for (const std::string horizon : {"1", "1.0000005"}) {
    const Result r = judged(kAcross, {}, horizon);
    EXPECT_EQ(r.verdict, Verdict::certified) << r.reason;
    EXPECT_EQ(r.counts.horizon_events, 1);
  }
  const std::string touching =
      scene_of("\"none\"", disk("[0,0]", "[1,0]") + "," + disk("[2,0]", "[0,0]"));
  EXPECT_EQ(judged(touching, {}, "0").counts.horizon_events, 1);
  EXPECT_EQ(judged(kAcross, {}, "1.000002").verdict, Verdict::refuted);
  EXPECT_EQ(judged(kAcross, {kMeet}, "3").verdict, Verdict::invalid);
  Options strict;
  strict.strict = true;
  EXPECT_EQ(judged(kAcross, {kMeet}, "2", strict).verdict, Verdict::certified);
  EXPECT_EQ(judged(kAcross, {kMeet}, "1.5", strict).verdict, Verdict::refuted);
}

TEST(KernelBilliards, WallsThatMove) {
  const std::string scene =
      scene_of(R"({"walls":[{"normal":["3/5","4/5"],"offset":0,"speed":1,"restitution":"1/2"}]})",
               disk("[3,4]", "[-0.6,-0.8]", R"(,"growth":1)"));
  // The gap 5 - 1 - 3 t is 0 at 4/3: the speed along the normal is -1, and 1 + 1 + 1.5 after it.
  const std::string time = R"({"t":"4/3","collide":[-1,0],"v":[null,)";
  expect(Verdict::certified, scene, {time + R"(["21/10","28/10"]]})"});
  expect(Verdict::refuted, scene, {time + R"(["21/10","2.79999"]]})"}, 2);
  expect(Verdict::refuted, scene, {time + R"(["0.9","1.2"]]})"}, 2);
  expect(Verdict::refuted, scene, {}, 2);
}

TEST(KernelBilliards, InASphere) {
  const std::string scene = scene_of(
      R"({"center":[0,0,1],"radius":5,"restitution":"1/2"})",
      R"({"center":[0,0,1],"radius":1,"velocity":[0,3,0],"growth":"1/3"})", ",\"dimension\":3");
  // 3 t + 1 + t/3 = 5 at 6/5; the wall is reached with 3, and left with 10/3 * 3/2 - 3.
  const std::string time = R"({"t":"6/5","collide":[-1,0],"v":[null,)";
  expect(Verdict::certified, scene, {time + "[0,-2,0]]}"});
  expect(Verdict::refuted, scene, {time + "[0,-3,0]]}"}, 2);
  expect(Verdict::refuted, scene, {}, 2);
}

TEST(KernelBilliards, ImagesThatMove) {
  // The image of disk 1 above disk 0 moves with shear * side = 1: along with disk 0.
  const std::string scene =
      scene_of(R"({"periodic":[10,10],"shear":"1/10"})",
               disk("[0,8]", "[1,1]", ",\"mass\":3") + "," + disk("[0,1]", "[0,0]"));
  const std::string meet = R"({"t":1,"collide":[0,1],"image":[0,1],"v":[[1,0.5],[0,1.5]]})";
  expect(Verdict::certified, scene, {meet});
  expect(Verdict::certified, scene, {R"({"t":1,"collide":[0,1]})"});
  expect(Verdict::refuted, scene, {R"({"t":1,"collide":[0,1],"v":[[1,0.5],[0.1,1.5]]})"}, 2);
  expect(Verdict::refuted, scene, {}, 2);
}

// An image that runs along a row of others hits one that it is far from at both ends of a time.
TEST(KernelBilliards, ImagesThatMoveFast) {
  const std::string scene = scene_of(R"({"periodic":[40,10],"shear":1})",
                                     disk("[10,8]", "[0,0]") + "," + disk("[0,-0.5]", "[0,0]"));
  expect(Verdict::refuted, scene, {}, 2);
  // The centres of the two are (-1.2, 1.6) apart.
  const std::string apart =
      scene_of(R"({"periodic":[40,10],"shear":1})",
               disk("[10,8]", "[0,0]") + "," + disk("[0,\"-2/5\"]", "[0,0]"), "", "1");
  const std::string meet =
      R"({"t":"22/25","collide":[0,1],"image":[0,1],"v":[["18/5","-24/5"],["-18/5","24/5"]]})";
  EXPECT_EQ(judged(apart, {meet}, "1").verdict, Verdict::certified);
}

TEST(KernelBilliards, DisksThatGrow) {
  const std::string scene = scene_of(
      "\"none\"",
      disk("[0,0]", "[0,0]", ",\"growth\":1") + "," + disk("[5,0]", "[0,0]", ",\"growth\":1"), "",
      "1.75");
  const std::string meet = R"({"t":1.5,"collide":[0,1],"v":[[-2,0],[2,0]]})";
  EXPECT_EQ(judged(scene, {meet}, "1.75").verdict, Verdict::certified);
  EXPECT_EQ(judged(scene, {}, "1.75").verdict, Verdict::refuted);
  const std::string still = R"({"t":1.5,"collide":[0,1],"v":[[0,0],[0,0]]})";
  EXPECT_EQ(judged(scene, {still}, "1.75").verdict, Verdict::refuted);
}

// Without restitution the two stay in touch.
TEST(KernelBilliards, WithoutRestitution) {
  const std::string scene = scene_of(
      "\"none\"", disk("[0,0]", "[2,0]") + "," + disk("[4,0]", "[0,0]"), ",\"restitution\":0");
  const auto meet = [](const std::string& t, const std::string& v) {
    return "{\"t\":" + t + ",\"collide\":[0,1],\"v\":[[1,0],[" + v + ",0]]}";
  };
  expect(Verdict::certified, scene, {meet("1", "1")});
  // Claimed late they stay in each other.
  expect(Verdict::refuted, scene, {meet("1.0000005", "1")}, 2);
  // Roundings make no second collision.
  const std::string slower = "0.9999999999999999";
  expect(Verdict::certified, scene, {meet("1", slower)});
  expect(Verdict::refuted, scene, {meet("1", slower), meet("1.0000005", slower)}, 3);
}

TEST(KernelBilliards, GravityAndAFixedDisk) {
  // Falling 4 from rest takes the time 2.
  const std::string scene =
      scene_of("\"none\"", disk("[0,6]", "[0,0]") + R"(,{"center":[0,0],"radius":1,"fixed":true})",
               R"(,"gravity":[0,-2],"restitution":"1/2")", "3");
  const std::string meet = R"({"t":2,"collide":[0,1],"v":[[0,2],null],"p":[[0,2],[0,0]]})";
  EXPECT_EQ(judged(scene, {meet}, "3").verdict, Verdict::certified);
  EXPECT_EQ(judged(scene, {}, "3").verdict, Verdict::refuted);
  EXPECT_EQ(judged(scene, {}, "1.9").verdict, Verdict::certified);
  EXPECT_EQ(judged(scene, {R"({"t":2,"collide":[0,1],"v":[[0,4],null]})"}, "3").verdict,
            Verdict::refuted);
  const std::string early = R"({"t":1.9,"collide":[0,1],"v":[[0,1.9],null]})";
  EXPECT_EQ(judged(scene, {early}, "3").line, 2);
  // At the top of a parabola, far from both its ends.
  const std::string thrown = scene_of(
      "\"none\"", disk("[-4,0]", "[4,8]") + R"(,{"center":[0,5.5],"radius":1,"fixed":true})",
      R"(,"gravity":[0,-8])");
  expect(Verdict::refuted, thrown, {}, 2);
}

TEST(KernelBilliards, Maneuvers) {
  const std::string scene = scene_of("\"none\"", disk("[0,0]", "[1,0]"),
                                     R"(,"maneuvers":[{"t":1,"disk":0,"velocity":[0,1]}])");
  expect(Verdict::certified, scene, {R"({"t":1,"maneuver":0,"v":[0,1],"p":[1,0]})"});
  expect(Verdict::certified, scene, {R"({"t":1.0000005,"maneuver":0})"});
  expect(Verdict::refuted, scene, {R"({"t":1,"maneuver":0,"v":[0,1.00001]})"}, 2);
  expect(Verdict::refuted, scene, {R"({"t":1,"maneuver":0,"p":[1.0001,0]})"}, 2);
  expect(Verdict::refuted, scene, {R"({"t":1.1,"maneuver":0})"}, 2);
  expect(Verdict::refuted, scene, {});
}

// Claimed late, they are torn apart at once.
TEST(KernelBilliards, LateAnswers) {
  const auto scene = [](const std::string& t) {
    return scene_of("\"none\"", disk("[0,0]", "[2,0]") + "," + disk("[4,0]", "[0,0]"),
                    ",\"maneuvers\":[{\"t\":" + t + ",\"disk\":1,\"velocity\":[1000,0]}]");
  };
  expect(Verdict::certified, scene("1.0000005"),
         {R"({"t":1.0000001,"collide":[0,1]})", R"({"t":1.0000005,"maneuver":1})"});
  expect(Verdict::refuted, scene("1.0000105"),
         {R"({"t":1.00001,"collide":[0,1]})", R"({"t":1.0000105,"maneuver":1})"}, 2);
}

TEST(KernelBilliards, RoundingsAndGrazes) {
  // They pass each other at the distance 2, or a little less or more.
  const auto passing = [](const std::string& y) {
    return scene_of("\"none\"", disk("[-1,0]", "[1,0]") + "," + disk("[0," + y + "]", "[0,0]"));
  };
  const std::string graze = R"({"t":1,"collide":[0,1],"v":[[1,0],[0,0]]})";
  const std::string touching = passing("2"), above = passing("2.0000000000000004");
  for (const std::string& scene : {touching, above}) {
    expect(Verdict::certified, scene, {});
    const Result r = judged(scene, {graze});
    EXPECT_EQ(r.verdict, Verdict::certified) << r.reason;
    EXPECT_EQ(r.counts.grazes, 1);
  }
  expect(Verdict::refuted, passing("2.0001"), {graze}, 2);
  const Result shallow = judged(passing("1.9999999999999998"), {});
  EXPECT_EQ(shallow.verdict, Verdict::certified) << shallow.reason;
  EXPECT_EQ(shallow.counts.rounding_overlaps, 1);
  expect(Verdict::refuted, passing("1.99999"), {}, 2);
}

TEST(KernelBilliards, UndecidedByName) {
  Options exact;
  exact.truth = Truth::exact;
  EXPECT_EQ(judged(kAcross, {kMeet}, "2", exact).verdict, Verdict::undecided);
  const std::string fixed = scene_of(R"({"walls":[{"normal":[1,0],"offset":0,"speed":1}]})",
                                     R"({"center":[2,0],"radius":1,"fixed":true})");
  expect(Verdict::undecided, fixed, {}, 2);
  EXPECT_EQ(judged(fixed, {}, "1").verdict, Verdict::undecided);
  EXPECT_EQ(judged(fixed, {}, "0.5").verdict, Verdict::certified);
  const std::string between =
      scene_of(R"({"periodic":[4,null]})", disk("[0,0]", "[0,1]") + "," + disk("[2,4]", "[0,0]"));
  expect(Verdict::undecided, between, {R"({"t":1,"collide":[0,1]})"}, 2);
  std::string world = kAcross;
  world.replace(world.find("bounce"), 6, "pass");
  EXPECT_EQ(check(world, history_of(world, {}), {}).reason, "the kernel does not know worlds");
}

TEST(KernelBilliards, Invalid) {
  struct Change {
    const char *from, *to;
  };
  const Change changes[] = {
      {"\"version\":2", "\"version\":3"},
      {"\"contacts\":\"bounce\",", ""},
      {"\"horizon\":2", "\"horizon\":2,\"dimension\":3"},
      {"\"horizon\":2", "\"horizon\":2,\"gravity\":[0]"},
      {"[10,null]", "[10,10]"},
      {"[10,null]", "[2,null]"},
      {"[10,null]", "[10]"},
      {"[10,null]", "[0,null]"},
      {"[10,null]", "[10,null],\"shear\":1"},
      {"\"normal\":[0,1]", "\"normal\":[0,2]"},
      {"\"normal\":[0,1]", "\"restitution\":0,\"normal\":[0,1]"},
      {"\"fixed\":true", "\"fixed\":1"},
      {"\"fixed\":true", "\"fixed\":true,\"velocity\":[1,0]"},
      {"\"fixed\":true", "\"fixed\":false"},
      {"\"fixed\":true", "\"fixed\":true,\"growth\":-1"},
      {"[7,5]", "[9.5,5]"},
      {"[7,5]", "[7,9.5]"},
  };
  for (const Change& c : changes) {
    std::string scene = kAcross;
    scene.replace(scene.find(c.from), std::string(c.from).size(), c.to);
    EXPECT_EQ(check(scene, history_of(scene, {kMeet}), {}).verdict, Verdict::invalid)
        << c.from << " -> " << c.to;
  }
  for (const char* claim :
       {R"({"t":1,"collide":[0,1],"image":[-1,1]})", R"({"t":1,"collide":[0,1],"image":[-1]})",
        R"({"t":1,"collide":[-3,1]})", R"({"t":1,"collide":[-1,1],"image":[1,0]})",
        R"({"t":1,"collide":[0,1],"v":[null,[0,0]]})", R"({"t":1,"flip":[0,1,2,-1]})",
        R"({"t":1,"collide":[-1,1],"v":[[0,0],[0,0]]})", R"({"t":1,"maneuver":0,"image":[0,0]})"}) {
    EXPECT_EQ(judged(kAcross, {claim}).verdict, Verdict::invalid) << claim;
  }
}

}  // namespace
}  // namespace voroproof_kernel
