// The engine of billiards: scenes whose events are known, ties in fractions, the same events
// whatever the bits.
#include "engine/billiard/billiard_run.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "filtered/billiards/line_boxes.h"
#include "history/billiard.h"
#include "history/json_text.h"

namespace voroproof::internal::testing {
namespace {

Billiard billiard(const std::string& horizon, const std::string& members) {
  return parse_billiard(
      R"({"format":"voroproof-scene","version":2,"contacts":"bounce","horizon":)" + horizon + "," +
          members + "}",
      "a.scene.json");
}

struct ToldRun {
  BilliardOutcome outcome;
  std::vector<BilliardEvent> events;

  // "2 0-1; 3 1-2": times and pairs.
  std::string text() const {
    std::string text;
    for (const BilliardEvent& e : events) {
      text += (text.empty() ? "" : "; ") + number_text(e.t.value()) + " ";
      if (const auto* c = std::get_if<BilliardCollision>(&e.what))
        text += std::to_string(c->a) + "-" + std::to_string(c->b);
      else
        text += "turn " + std::to_string(std::get<BilliardTurn>(e.what).disk);
    }
    return text;
  }
};

ToldRun run(const Billiard& billiard, int start_bits = 256, int max_bits = 4096) {
  EXPECT_FALSE(find_overlap_at_start(billiard).has_value());
  ToldRun run;
  BilliardOptions options;
  options.start_bits = start_bits;
  options.max_bits = max_bits;
  run.outcome = run_billiard(billiard, options,
                             [&](const BilliardEvent& event) { run.events.push_back(event); });
  return run;
}

// Two blocks and a wall, the far one 100^k times as heavy: the digits of pi (G. Galperin, Playing
// pool with pi, Regul. Chaotic Dyn. 8, 2003).
TEST(BilliardRun, DigitsOfPi) {
  const std::vector<std::size_t> digits{3, 31, 314};
  std::string mass = "1";
  for (const std::size_t count : digits) {
    const ToldRun found =
        run(billiard("1e9", R"("frame":{"walls":[{"normal":[1,0],"offset":0}]},"disks":[
          {"center":[5,0],"radius":1,"velocity":[0,0],"mass":1},
          {"center":[10,0],"radius":1,"velocity":[-1,0],"mass":)" +
                                mass + "}]"));
    EXPECT_EQ(found.outcome.kind, BilliardOutcome::Kind::complete) << found.outcome.reason;
    EXPECT_EQ(found.events.size(), count);
    mass += "00";
  }
}

// A row that touches: one in, one out, at one instant, and the same on the way back.
TEST(BilliardRun, Cradle) {
  const ToldRun found =
      run(billiard("30", R"("frame":{"walls":[{"normal":[-1,0],"offset":-20}]},"disks":[
      {"center":[0,0],"radius":1,"velocity":[1,0]},{"center":[4,0],"radius":1,"velocity":[0,0]},
      {"center":[6,0],"radius":1,"velocity":[0,0]},{"center":[8,0],"radius":1,"velocity":[0,0]}])"));
  EXPECT_EQ(found.text(), "2 0-1; 2 1-2; 2 2-3; 13 -1-3; 24 2-3; 24 1-2; 24 0-1");
  EXPECT_EQ(found.outcome.bits, 0);
}

TEST(BilliardRun, ACornerAndManeuvers) {
  const ToldRun found = run(billiard("9", R"("frame":{"walls":[
      {"normal":[-1,0],"offset":-10},{"normal":[0,-1],"offset":-10}]},
      "disks":[{"center":[5,5],"radius":1,"velocity":[1,1]}],
      "maneuvers":[{"t":4,"disk":0,"velocity":[2,0]},{"t":9,"disk":0,"velocity":[0,0]}])"));
  // Collisions come first, then the maneuver, which leads into the wall again.
  EXPECT_EQ(found.text(), "4 -2-0; 4 -1-0; 4 turn 0; 4 -1-0; 9 turn 0");
  // All maneuvers of an instant come before the collisions that they lead to.
  const ToldRun two = run(billiard("3", R"("frame":"none","disks":[
      {"center":[0,0],"radius":1,"velocity":[0,0]},{"center":[2,0],"radius":1,"velocity":[0,0]}],
      "maneuvers":[{"t":1,"disk":0,"velocity":[1,0]},{"t":1,"disk":1,"velocity":[3,0]}])"));
  EXPECT_EQ(two.text(), "1 turn 0; 1 turn 1");
}

TEST(BilliardRun, ImagesAreNamed) {
  const ToldRun found = run(billiard("5", R"("dimension":3,"frame":{"periodic":[8,8,8]},"disks":[
      {"center":[1,4,4],"radius":0.5,"velocity":[-1,0,0]},
      {"center":[6,4,4],"radius":0.5,"velocity":[1,0,0]}])"));
  ASSERT_EQ(found.text(), "1 0-1; 4 0-1");
  EXPECT_EQ(std::get<BilliardCollision>(found.events[0].what).image, (LatticeImage{-1, 0, 0}));
  EXPECT_EQ(std::get<BilliardCollision>(found.events[1].what).image, (LatticeImage{0, 0, 0}));
}

TEST(BilliardRun, GrowthGravityAndShear) {
  EXPECT_EQ(run(billiard("4", R"("frame":"none","disks":[
      {"center":[0,0],"radius":1,"velocity":[0,0],"growth":0.5,"mass":1},
      {"center":[4,0],"radius":1,"velocity":[0,0],"growth":0.5,"mass":1}])"))
                .text(),
            "2 0-1");
  EXPECT_EQ(run(billiard("7", R"("frame":{"walls":[{"normal":[0,1],"offset":0}]},"gravity":[0,-1],
      "disks":[{"center":[0,3],"radius":1,"velocity":[1,0]}])"))
                .text(),
            "2 -1-0; 6 -1-0");
  EXPECT_EQ(run(billiard("2.5", R"("frame":{"periodic":[16,4],"shear":"1/2"},"disks":[
      {"center":[4,1],"radius":0.5,"velocity":[0,0]},{"center":[0,-3],"radius":0.5,"velocity":[0,0]}])"))
                .text(),
            "1.5 0-1");
}

// A gas: no root is a fraction. More bits, or fewer to begin with, change nothing.
TEST(BilliardRun, BitsChangeNothing) {
  std::string disks;
  for (int i = 0; i < 9; ++i) {
    disks += (i ? "," : "") + (R"({"center":[)" + number_text(1.5 + 3 * (i % 3))) + "," +
             number_text(1.5 + 3 * (i / 3)) + R"(],"radius":1,"velocity":[)" +
             number_text((i * 7 % 5 - 2) / 4.0) + "," + number_text((i * 3 % 7 - 3) / 8.0) + "]}";
  }
  const Billiard gas =
      billiard("40", R"("frame":{"periodic":[9,9]},"restitution":1,"disks":[)" + disks + "]");
  const ToldRun few = run(gas, 64), many = run(gas, 2048);
  EXPECT_EQ(few.outcome.kind, BilliardOutcome::Kind::complete) << few.outcome.reason;
  EXPECT_GT(few.events.size(), 60U);
  EXPECT_GT(few.outcome.bits, 64);
  EXPECT_EQ(few.text(), many.text());
}

TEST(BilliardRun, StopsWithAReason) {
  const ToldRun pillar = run(billiard("7", R"("frame":"none","gravity":[0,-1],"disks":[
      {"center":[0,4],"radius":1,"velocity":[0,0]},{"center":[0,0],"radius":1,"fixed":true}])"));
  EXPECT_EQ(pillar.outcome.kind, BilliardOutcome::Kind::stopped);
  EXPECT_NE(pillar.outcome.reason.find("is not simulated"), std::string::npos);
  // It comes to rest on the floor.
  const ToldRun rest =
      run(billiard("7", R"("frame":{"walls":[{"normal":[0,1],"offset":0,"restitution":"1/2"}]},
      "gravity":[0,-1],"disks":[{"center":[0,1],"radius":1,"velocity":[0,0]}])"));
  EXPECT_EQ(rest.outcome.kind, BilliardOutcome::Kind::stopped);
  EXPECT_NE(rest.outcome.reason.find("pressed together"), std::string::npos);
  const auto reason = [](const std::string& members) {
    const ToldRun stopped = run(billiard("4", members));
    return stopped.outcome.kind == BilliardOutcome::Kind::stopped ? stopped.outcome.reason : "";
  };
  const std::string walls = R"("frame":{"walls":[{"normal":[1,0],"offset":0},
      {"normal":[-1,0],"offset":-4}]},"disks":[{"center":[2,0],"radius":1,"growth":"1/2",)";
  EXPECT_EQ(reason(walls + R"("velocity":[0,0]}])"),
            "disk 0 and wall -2 collide more than 100000 times at one instant: they are pressed "
            "together");
  EXPECT_EQ(reason(walls + R"("fixed":true}])"), "disk 0 and wall -2 touch, and cannot move");
  EXPECT_EQ(find_overlap_at_start(billiard("7", R"("frame":{"periodic":[8,8]},"disks":[
      {"center":[0.5,1],"radius":1,"velocity":[0,0]},{"center":[7.75,1],"radius":1,"velocity":[0,0]}])")),
            (BilliardPair{0, 1, {-1, 0, 0}}));
}

// Collisions that have no end: of three in a row, on a floor, between walls that close in.
TEST(BilliardRun, CollapsesAreSeen) {
  const auto expect_stop = [](const std::string& members, double before, std::size_t most) {
    const ToldRun stopped = run(billiard("20", members));
    EXPECT_EQ(stopped.outcome.kind, BilliardOutcome::Kind::stopped) << members;
    EXPECT_EQ(stopped.outcome.reason.rfind("collapse, as it seems: disk ", 0), 0U)
        << stopped.outcome.reason;
    EXPECT_LE(stopped.outcome.t, before);
    EXPECT_GT(stopped.outcome.t, before - 1e-3);
    EXPECT_LT(stopped.events.size(), most);
  };
  expect_stop(R"("restitution":"1/100","frame":"none","disks":[
    {"center":[0,0],"radius":1,"velocity":[1,0]},{"center":[3,0],"radius":1,"velocity":[0,0]},
    {"center":[5,0],"radius":1,"velocity":[-1,0]}])",
              0.674, 20);
  expect_stop(
      R"("gravity":[0,-1],"frame":{"walls":[{"normal":[0,1],"offset":0,"restitution":"1/2"}]},
    "disks":[{"center":[3,3],"radius":1,"velocity":[3,0]}])",
      6, 50);
  expect_stop(R"("frame":{"walls":[{"normal":[1,0],"offset":0,"speed":1},
    {"normal":[-1,0],"offset":-6,"speed":1}]},"disks":[{"center":[3,0],"radius":1,"velocity":[3,0]}])",
              2, 1'200'000);
}

// Many collisions are no collapse: at one instant, and in a time that is short beside the horizon
// alone. Something else takes energy, or gives it.
TEST(BilliardRun, ManyCollisionsAreNoCollapse) {
  std::string row;
  for (int k = 0; k < 60; ++k) {
    row += (k > 0 ? "," : "") + std::string(R"({"center":[)") +
           std::to_string(k < 30 ? 2 * k : 2 * k + 1) + R"(,0],"radius":1,"velocity":[)" +
           (k < 30 ? "1" : "0") + ",0]}";
  }
  const ToldRun cradle = run(billiard("3", R"("frame":"none","disks":[)" + row +
                                               R"(,{"center":[0,99],"radius":1,"velocity":[0,0],
                                                    "growth":1}])"));
  EXPECT_EQ(cradle.outcome.kind, BilliardOutcome::Kind::complete) << cradle.outcome.reason;
  EXPECT_EQ(cradle.events.size(), 900U);
  const ToldRun bounces = run(billiard("1e13", R"("frame":{"walls":[
      {"normal":[1,0],"offset":0},{"normal":[-1,0],"offset":-4},
      {"normal":[0,1],"offset":-9,"restitution":"1/2"}]},"disks":[
      {"center":[2,0],"radius":1,"velocity":[1,0]}],
      "maneuvers":[{"t":500,"disk":0,"velocity":[0,0]}])"));
  EXPECT_EQ(bounces.outcome.kind, BilliardOutcome::Kind::complete) << bounces.outcome.reason;
  EXPECT_EQ(bounces.events.size(), 251U);
}

// Two pairs collide at an irrational instant, the middle of whose enclosure is less than its
// rounding; then two ties are not told.
TEST(BilliardRun, StopsNoSoonerThanItsLastEvent) {
  const ToldRun stopped = run(billiard("20", R"("frame":"none","disks":[
      {"center":[0,0],"radius":1,"velocity":[1,0]},{"center":[8,1],"radius":1,"velocity":[0,0]},
      {"center":[8,-1],"radius":1,"velocity":[0,0]},
      {"center":[0,30],"radius":1,"velocity":[2,0]},{"center":[5,31],"radius":1,"velocity":[0,0]},
      {"center":[0,50],"radius":1,"velocity":[1,0]},{"center":[4,51],"radius":1,"velocity":[0,0]},
      {"center":[0,10],"radius":1,"velocity":[1,0]},{"center":[4,11],"radius":1,"velocity":[0,0]}])"));
  EXPECT_EQ(stopped.outcome.kind, BilliardOutcome::Kind::stopped);
  ASSERT_FALSE(stopped.events.empty());
  EXPECT_EQ(CompactRational(stopped.outcome.t), stopped.events.back().t) << stopped.text();
}

}  // namespace
}  // namespace voroproof::internal::testing
