// Wrong histories that go on consistently in their own world, each of two or three disks.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "tests/kernel/histories.h"

namespace voroproof_kernel {
namespace {

const std::string kMeet = R"({"t":0,"collide":[0,1],"v":[[0,0],[1,0]],"p":[[-1,0],[1,0]]})";

TEST(KernelFaults, F1TouchAndApproachAtTheStart) {
  const std::string scene =
      scene_of(disk("-1", "0", "1", "1", "0") + "," + disk("1", "0", "1", "0", "0"));
  for (const Truth truth : {Truth::recorded, Truth::exact}) {
    EXPECT_EQ(verdict(scene, {kMeet}, truth), Verdict::certified);
    EXPECT_EQ(verdict(scene, {}, truth), Verdict::refuted);
    EXPECT_EQ(verdict(scene, {R"({"t":0.5,"collide":[0,1],"v":[[0,0],[1,0]]})"}, truth),
              Verdict::refuted);
  }
}

TEST(KernelFaults, F1TouchAndApproachFromAManeuverOn) {
  const std::string scene =
      scene_of(disk("-1", "0", "1", "0", "0") + "," + disk("1", "0", "1", "0", "0"), "3",
               R"(,"maneuvers":[{"t":1,"disk":0,"velocity":[1,0]}])");
  const std::string turn = R"({"t":1,"maneuver":0,"v":[1,0],"p":[-1,0]})";
  for (const Truth truth : {Truth::recorded, Truth::exact}) {
    EXPECT_EQ(verdict(scene, {turn, R"({"t":1,"collide":[0,1],"v":[[0,0],[1,0]]})"}, truth),
              Verdict::certified);
    EXPECT_EQ(verdict(scene, {turn}, truth), Verdict::refuted);
    EXPECT_EQ(verdict(scene, {}, truth), Verdict::refuted);
  }
}

TEST(KernelFaults, F2TinyDisksPassThroughEachOther) {
  const std::string scene =
      scene_of(disk("-1", "0", "1e-7", "1", "0") + "," + disk("1", "0", "4e-7", "0", "0"));
  const std::string right = R"({"t":1.9999995,"collide":[0,1],"v":[[0,0],[1,0]]})";
  EXPECT_EQ(verdict(scene, {right}, Truth::recorded), Verdict::certified);
  EXPECT_EQ(verdict(scene, {}, Truth::recorded), Verdict::refuted);
  // Claimed when they have passed: they turn back into each other.
  EXPECT_EQ(
      verdict(scene, {R"({"t":2.000001,"collide":[0,1],"v":[[0,0],[1,0]]})"}, Truth::recorded),
      Verdict::refuted);
}

TEST(KernelFaults, F3ANearMissIsNoCollision) {
  const std::string scene = scene_of(
      disk("-2", "0", "1", "1000", "0") + "," + disk("0", "2.00001", "1", "0", "0"), "0.01");
  EXPECT_EQ(verdict(scene, {}, Truth::recorded, "0.01"), Verdict::certified);
  EXPECT_EQ(verdict(scene, {R"({"t":0.002,"collide":[0,1],"v":[[1000,0],[0,0]]})"}, Truth::recorded,
                    "0.01"),
            Verdict::refuted);
  // Parting, too.
  EXPECT_EQ(verdict(scene, {R"({"t":0.0020001,"collide":[0,1],"v":[[1000,0],[0,0]]})"},
                    Truth::recorded, "0.01"),
            Verdict::refuted);
}

std::string file(const std::string& name) {
  std::ifstream in(std::string(VOROPROOF_CORPUS) + "/" + name, std::ios::binary);
  EXPECT_TRUE(in) << name;
  return std::string(std::istreambuf_iterator<char>(in), {});
}

TEST(KernelFaults, F4MirroredQuadrupletsNeedTheirOption) {
  const std::string scene = file("scenes/disks.scene.json");
  const std::string right = file("certified/disks.history.jsonl");
  for (const int faults : {1, 2, 7}) {
    std::istringstream lines(right);
    std::string wrong, line;
    int left = faults;
    while (std::getline(lines, line)) {
      const std::size_t at = line.find("\"flip\":[");
      if (at != std::string::npos && left > 0) {
        int l, r, s, e;
        ASSERT_EQ(std::sscanf(line.c_str() + at, "\"flip\":[%d,%d,%d,%d]", &l, &r, &s, &e), 4);
        std::ostringstream flip;
        flip << line.substr(0, at) << "\"flip\":[" << l << ',' << r << ',' << e << ',' << s << "]}";
        line = flip.str();
        --left;
      }
      wrong += line + "\n";
    }
    ASSERT_EQ(left, 0);
    Options options;
    EXPECT_EQ(check(scene, right, options).verdict, Verdict::certified);
    EXPECT_EQ(check(scene, wrong, options).verdict, Verdict::refuted);
    options.unoriented = true;
    const Result r = check(scene, wrong, options);
    EXPECT_EQ(r.verdict, Verdict::certified) << r.reason;
    EXPECT_EQ(r.counts.unoriented, faults);
  }
}

TEST(KernelFaults, F5VelocitiesOfTheTwoThatMeetOnly) {
  // Disk 1 was fast once; the collision of two slow disks is not judged by that.
  const std::string scene =
      scene_of(disk("-1", "0", "1", "1", "0") + "," + disk("1", "0", "1", "0", "0"), "3",
               R"(,"maneuvers":[{"t":1,"disk":1,"velocity":[1e6,0]},)"
               R"({"t":1.000001,"disk":1,"velocity":[1,0]}])");
  const std::vector<std::string> fast = {R"({"t":1,"maneuver":1,"v":[1e6,0]})",
                                         R"({"t":1.000001,"maneuver":1,"v":[1,0]})"};
  for (const Truth truth : {Truth::recorded, Truth::exact}) {
    EXPECT_EQ(verdict(scene, {kMeet, fast[0], fast[1]}, truth), Verdict::certified);
    EXPECT_EQ(
        verdict(scene, {R"({"t":0,"collide":[0,1],"v":[[0,0.1],[1,0]]})", fast[0], fast[1]}, truth),
        Verdict::refuted);
  }
}

TEST(KernelFaults, F6ACollisionOfTheStartClaimedLater) {
  const std::string scene =
      scene_of(disk("-1", "0", "1", "1", "0") + "," + disk("1", "0", "1", "0", "0"));
  const std::string late = R"({"t":5e-7,"collide":[0,1],"v":[[0,0],[1,0]]})";
  EXPECT_EQ(verdict(scene, {late}, Truth::exact), Verdict::certified);
}

TEST(KernelFaults, F7AfterTheHorizon) {
  // They touch at 3 + 1e-8, exactly.
  const std::string scene =
      scene_of(disk("\"-4.00000001\"", "0", "1", "1", "0") + "," + disk("1", "0", "1", "0", "0"));
  const std::string claim = R"({"t":3,"collide":[0,1],"v":[[0,0],[1,0]]})";
  EXPECT_EQ(verdict(scene, {}, Truth::exact), Verdict::certified);
  EXPECT_EQ(verdict(scene, {claim}, Truth::exact), Verdict::refuted);
  // At the horizon it is due under the exact truth.
  const std::string at =
      scene_of(disk("-4", "0", "1", "1", "0") + "," + disk("1", "0", "1", "0", "0"));
  EXPECT_EQ(verdict(at, {claim}, Truth::exact), Verdict::certified);
  EXPECT_EQ(verdict(at, {}, Truth::exact), Verdict::refuted);
  EXPECT_EQ(verdict(at, {}, Truth::recorded), Verdict::certified);
}

TEST(KernelFaults, F8ALineTwice) {
  const std::string scene =
      scene_of(disk("-1", "0", "1", "1", "0") + "," + disk("1", "0", "1", "0", "0"), "3",
               ",\"restitution\":0");
  const std::string once = R"({"t":0,"collide":[0,1],"v":[[0.5,0],[0.5,0]]})";
  for (const Truth truth : {Truth::recorded, Truth::exact}) {
    EXPECT_EQ(verdict(scene, {once}, truth), Verdict::certified);
    EXPECT_EQ(verdict(scene, {once, once}, truth), Verdict::refuted);
  }
  // A graze has no effect, and one line is one too many under the exact truth.
  const std::string graze =
      scene_of(disk("-2", "0", "1", "1", "0") + "," + disk("0", "2", "1", "0", "0"));
  const std::string hit = R"({"t":2,"collide":[0,1],"v":[[1,0],[0,0]]})";
  EXPECT_EQ(verdict(graze, {hit}, Truth::recorded), Verdict::certified);
  EXPECT_EQ(verdict(graze, {hit, hit}, Truth::recorded), Verdict::refuted);
  EXPECT_EQ(verdict(graze, {hit}, Truth::exact), Verdict::refuted);
}

// Disk 2 flies through between the others: with nothing claimed the first diagram turns inside out.
TEST(KernelFaults, CellsThatTurnInsideOut) {
  const std::string scene =
      scene_of(disk("-5", "0", "1", "0", "0") + "," + disk("5", "0", "1", "0", "0") + "," +
               disk("0", "5", "1", "0", "-10"));
  const std::string initial = "[[-1,0,1,2],[-1,1,2,0],[-1,2,0,1],[0,1,-1,2],[0,2,1,-1],[1,2,-1,0]]";
  Problem p;
  p.scene = read_scene(scene);
  p.history = read_history(history_of(scene, {}, "3", initial), p.scene);
  Counts counts;
  trace_paths(p, counts);
  const Walk walk(p);
  int wrong = 0;
  for (int g = container; g < 3; ++g) {
    EXPECT_NO_THROW(check_cell(walk, g, 0));
    try {
      check_cell(walk, g, 1);
    } catch (const Stop& stop) {
      wrong += stop.verdict == Verdict::refuted;
    }
  }
  EXPECT_GT(wrong, 0);
  EXPECT_EQ(check(scene, history_of(scene, {}, "3", initial), {}).verdict, Verdict::refuted);
}

TEST(KernelFaults, UndecidedSaysWhy) {
  const auto reason = [](const std::string& scene, const std::vector<std::string>& claims,
                         Truth truth) {
    Options options;
    options.truth = truth;
    const Result r = check(scene, history_of(scene, claims), options);
    EXPECT_EQ(r.verdict, Verdict::undecided) << r.reason;
    return r.reason;
  };
  const std::string slide =
      scene_of(disk("49", "0", "1", "0", "0") + "," + disk("1", "0", "1", "0", "0"), "3",
               R"(,"maneuvers":[{"t":1,"disk":0,"velocity":[0,1]}])");
  EXPECT_EQ(reason(slide, {R"({"t":1,"maneuver":0,"v":[0,1]})"}, Truth::recorded),
            "disk 0 slides along the container");
  const std::string points =
      scene_of(disk("-1", "0", "0", "1", "0") + "," + disk("1", "0", "0", "0", "0"));
  EXPECT_EQ(reason(points, {R"({"t":2,"collide":[0,1],"v":[[0,0],[1,0]]})"}, Truth::recorded),
            "two points that meet");
  const std::string oblique =
      scene_of(disk("-4", "1", "1", "1", "0") + "," + disk("1", "0", "1", "0", "0"));
  EXPECT_EQ(reason(oblique, {R"({"t":3,"collide":[0,1],"v":[[0,0],[1,0]]})"}, Truth::exact),
            "the collision time of 0 and 1 is irrational");
}

TEST(KernelFaults, ManeuversWhenTheSceneHasThem) {
  const std::string scene =
      scene_of(disk("-9", "0", "1", "0", "0") + "," + disk("9", "0", "1", "0", "0"), "3",
               R"(,"maneuvers":[{"t":1,"disk":0,"velocity":[1,0]}])");
  for (const Truth truth : {Truth::recorded, Truth::exact}) {
    EXPECT_EQ(verdict(scene, {R"({"t":1,"maneuver":0,"v":[1,0]})"}, truth), Verdict::certified);
    EXPECT_EQ(verdict(scene, {R"({"t":1.00001,"maneuver":0,"v":[1,0]})"}, truth), Verdict::refuted);
    EXPECT_EQ(verdict(scene, {R"({"t":1,"maneuver":0,"v":[1,0],"p":[-9.00001,0]})"}, truth),
              Verdict::refuted);
  }
}

TEST(KernelFaults, TheContainerIsHitOnTheFarSide) {
  const std::string scene =
      scene_of(disk("20", "0", "1", "1", "0") + "," + disk("0", "9", "1", "0", "0"), "30");
  for (const Truth truth : {Truth::recorded, Truth::exact}) {
    const std::string hit = R"({"t":29,"collide":[-1,0],"v":[null,[-1,0]]})";
    EXPECT_EQ(verdict(scene, {hit}, truth, "30"), Verdict::certified);
  }
}

// What the tolerance of times allows of velocities, the centres that the file gives do not.
TEST(KernelFaults, VelocitiesByTheCentresOfTheFile) {
  const std::string scene =
      scene_of(disk("-1", "0", "1", "1", "0") + "," + disk("1", "0", "1", "0", "0"));
  const std::string off = R"({"t":0,"collide":[0,1],"v":[[0,1e-7],[1,0]])";
  EXPECT_EQ(verdict(scene, {off + "}"}, Truth::exact), Verdict::certified);
  EXPECT_EQ(verdict(scene, {off + ",\"p\":[[-1,0],[1,0]]}"}, Truth::exact), Verdict::refuted);
}

// Where the rounding of centres hides the normal, energy and momentum are kept nevertheless.
TEST(KernelFaults, EnergyAndMomentumOfTinyDisks) {
  const std::string scene =
      scene_of(disk("-1", "0", "1e-7", "1", "0") + "," + disk("1", "0", "4e-7", "0", "0"));
  const auto hit = [&](const std::string& vx) {
    return verdict(scene, {R"({"t":1.9999995,"collide":[0,1],"v":[[0,0],[)" + vx + ",0]]}"},
                   Truth::recorded);
  };
  EXPECT_EQ(hit("1.000000001"), Verdict::certified);
  EXPECT_EQ(hit("1.000000007"), Verdict::refuted);  // the momentum
  EXPECT_EQ(hit("1.00000001"), Verdict::refuted);
  // Both are turned alike, so that the momentum is kept, and the energy is not.
  EXPECT_EQ(verdict(scene, {R"({"t":1.9999995,"collide":[0,1],"v":[[-1e-8,0],[1.00000001,0]]})"},
                    Truth::recorded),
            Verdict::refuted);
}

// Disks so small that their centres tell no normal, one hardly faster than the other: what some
// normal explains within the tolerance is right, what is off by ten tolerances is not, however slow
// the approach.
TEST(KernelFaults, SomeNormalOfASlowApproach) {
  struct Case {
    std::string before;  // of the faster, "1" plus the approach; the other has 1
    std::string from, t;
    std::vector<std::string> right, off;  // velocities after
  };
  for (const Case& c :
       {Case{"2",
             "-1",
             "0.999999999999998",
             {"[0.9999999981,0],[2.0000000019,0]"},
             {"[0.99999997,0],[2.00000003,0]"}},
        Case{"1.001",
             "-0.001",
             "0.999999999998",
             {"[0.9999999981,0],[1.0010000019,0]", "[1.0005,-0.0005],[1.0005,0.0005]"},
             {"[0.99999998,0],[1.00100002,0]", "[0.99999,0],[1.00101,0]"}}}) {
    const std::string scene = scene_of(disk(c.from, "0", "1e-15", c.before, "0") + "," +
                                       disk("0", "0", "1e-15", "1", "0"));
    const auto hit = [&](const std::string& v) {
      return verdict(scene, {"{\"t\":" + c.t + ",\"collide\":[0,1],\"v\":[" + v + "]}"},
                     Truth::recorded);
    };
    for (const std::string& v : c.right) EXPECT_EQ(hit(v), Verdict::certified) << v;
    for (const std::string& v : c.off) EXPECT_EQ(hit(v), Verdict::refuted) << v;
  }
}

// Two come between two others, and all four touch one circle at t = 2, exactly.
TEST(KernelFaults, WhenAFlipMayBeClaimed) {
  const auto scene = [](const std::string& horizon, const std::string& y = "5") {
    return scene_of(disk("-3", "0", "0.5", "0", "0") + "," + disk("3", "0", "0.5", "0", "0") + "," +
                        disk("0", y, "0.5", "0", "-1") + "," + disk("0", "-" + y, "0.5", "0", "1"),
                    horizon);
  };
  const std::string initial =
      "[[-1,0,3,2],[-1,1,2,3],[-1,2,0,1],[-1,3,1,0],[0,1,3,2],[0,2,1,-1],[0,3,-1,1],[1,2,-1,0],[1,"
      "3,0,-1]]";
  const auto flip = [](const std::string& t) { return "{\"t\":" + t + ",\"flip\":[0,1,3,2]}"; };
  for (const Truth truth : {Truth::recorded, Truth::exact}) {
    const bool exact = truth == Truth::exact;
    const auto right = [](bool is) { return is ? Verdict::certified : Verdict::refuted; };
    for (const std::string t : {"1.5", "1.99999", "1.9999995", "2", "2.0000005", "2.00001"}) {
      EXPECT_EQ(verdict(scene("2.25"), {flip(t)}, truth, "2.25", initial),
                right(t == "1.9999995" || t == "2" || t == "2.0000005"));
    }
    EXPECT_EQ(verdict(scene("2.25"), {}, truth, "2.25", initial), Verdict::refuted);
    // At the horizon, and just after it.
    EXPECT_EQ(verdict(scene("2"), {flip("2")}, truth, "2", initial), Verdict::certified);
    EXPECT_EQ(verdict(scene("2"), {}, truth, "2", initial), right(!exact));
    EXPECT_EQ(verdict(scene("1.9999995"), {flip("1.9999995")}, truth, "1.9999995", initial),
              right(!exact));
    EXPECT_EQ(verdict(scene("1.9999995"), {}, truth, "1.9999995", initial), Verdict::certified);
    // The first diagram is that after all flips at 0.
    EXPECT_EQ(verdict(scene("0.25", "3"), {flip("0")}, truth, "0.25", initial), Verdict::refuted);
  }
}

TEST(KernelFaults, AForeignHorizonIsSaid) {
  const std::string scene =
      scene_of(disk("-4", "9", "1", "1", "0") + "," + disk("1", "0", "1", "0", "0"));
  Options options;
  const std::string history = history_of(scene, {}, "2");
  const Result r = check(scene, history, options);
  EXPECT_EQ(r.verdict, Verdict::certified);
  EXPECT_EQ(r.horizon_note, "horizon 2 of the scene's 3");
  options.strict = true;
  EXPECT_EQ(check(scene, history, options).verdict, Verdict::refuted);
}

}  // namespace
}  // namespace voroproof_kernel
