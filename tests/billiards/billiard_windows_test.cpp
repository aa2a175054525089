// Windows of time, by which pairs are found, change no verdict: few or many claims in one, things
// that happen far away or never, all scales.
#include <gtest/gtest.h>

#include "history/json_text.h"
#include "tests/billiards/billiard_cases.h"

namespace voroproof::internal::testing {
namespace {

// What touches at the horizon is counted where all is over at the start, or one has just turned.
TEST(BilliardWindows, ContactsAtTheHorizonAlone) {
  BilliardCase start = head_on();
  start.members = R"("frame":"none","disks":[
    {"center":[0,0],"radius":1,"velocity":[1,0]},{"center":[2,0],"radius":1,"velocity":[0,0]}])";
  start.horizon = "0";
  start.events.clear();
  start.collisions = 0;
  expect_certified(start);
  EXPECT_EQ(start.judge().left_out, 1);
  BilliardCase cradle = head_on();
  cradle.members.insert(cradle.members.size() - 1,
                        R"(,{"center":[6,0],"radius":1,"velocity":[0,0]})");
  cradle.horizon = "2";
  expect_certified(cradle);
  EXPECT_EQ(cradle.judge().left_out, 1);
}

TEST(BilliardWindows, LateClaimsAtTheEndOfAWindow) {
  for (int others = 250; others <= 262; ++others) {
    BilliardCase c{R"("frame":"none","disks":[
      {"center":[0,0],"radius":1,"velocity":[1e-9,0]},{"center":[2.00000001,0],"radius":1,"velocity":[0,0]},
      {"center":[134217728,8],"radius":1,"velocity":[0,0]}],"maneuvers":[)",
                   "64",
                   {},
                   1,
                   others};
    for (int k = 0; k < others; ++k) {
      const std::string t = std::to_string(k) + "e-3";
      c.members += (k ? "," : "") + (R"({"t":)" + t) + R"(,"disk":2,"velocity":[0,0]})";
      c.events.push_back(R"({"t":)" + t + R"(,"maneuver":2})");
    }
    c.members += "]";
    c.events.push_back(R"({"t":32,"collide":[0,1],"v":[[0,0],[1e-9,0]]})");
    EXPECT_EQ(c.judge().verdict, Verdict::refuted) << others;
    c.events.back() = R"({"t":10.0000000,"collide":[0,1],"v":[[0,0],[1e-9,0]]})";
    EXPECT_EQ(c.judge().verdict, Verdict::certified) << others;
  }
}

TEST(BilliardWindows, Bystanders) {
  for (const char* const other : {R"({"center":[1e6,0],"radius":1,"velocity":[1e3,0]})",
                                  R"({"center":[0,1e3],"radius":100,"velocity":[0,1e-3]})",
                                  R"({"center":[0,50],"radius":1e-9,"velocity":[0,1e9]})"}) {
    BilliardCase c = head_on();
    c.members.insert(c.members.size() - 1, std::string(",") + other);
    expect_certified(c);
    c.events.clear();
    c.collisions = 0;
    EXPECT_EQ(c.judge().verdict, Verdict::refuted) << other;
  }
}

TEST(BilliardWindows, ThreeTouchLate) {
  expect_certified(
      {R"("frame":"none","disks":[
    {"center":[0,0],"radius":"13/2","velocity":[0,0],"mass":1},
    {"center":["40/3",0],"radius":"13/2","velocity":[0,0],"mass":1000000},
    {"center":["16/3",12],"radius":"13/2","velocity":[0,0],"mass":1}],
    "maneuvers":[{"t":1e9,"disk":0,"velocity":[1,0]}])",
       "1000000003",
       {R"({"t":1e9,"maneuver":0,"v":[1,0]})",
        R"({"t":1000000000.3333334,"collide":[0,1],"v":[["-999999/1000001",0],["2/1000001",0]]})"},
       1,
       1});
}

TEST(BilliardWindows, ManyBouncesBesideSomethingFarAway) {
  for (const char* const other : {"", R"(,{"center":[134217728,9],"radius":1,"fixed":true})"}) {
    BilliardCase c{std::string(R"("frame":{"walls":[{"normal":[0,1],"offset":0}]},"gravity":[0,-8],
      "disks":[{"center":[0,1],"radius":1,"velocity":[0.1,"4.1"]})") +
                       other + "]",
                   "700.5",
                   {}};
    for (int k = 1; k <= 600; ++k) {
      c.events.push_back(R"({"t":)" + number_text(k * 1.025) +
                         R"(,"collide":[-1,0],"v":[null,[0.1,4.1]]})");
    }
    c.collisions = 600;
    c.horizon = "615.5";
    const Certificate certificate = c.judge();
    EXPECT_EQ(certificate.verdict, Verdict::certified)
        << (certificate.divergence ? certificate.divergence->truth : certificate.reason);
  }
}

TEST(BilliardWindows, ExtremeScales) {
  BilliardCase c{R"("frame":"none","disks":[
    {"center":[-1e100,0],"radius":1,"velocity":[1e100,0]},{"center":[0,0],"radius":1,"velocity":[0,0]}])",
                 "1e100",
                 {}};
  EXPECT_EQ(c.judge().verdict, Verdict::refuted);
}

TEST(BilliardWindows, PastManyImages) {
  BilliardCase c{R"("frame":{"periodic":[1,1]},"disks":[
    {"center":[0,0],"radius":0.125,"velocity":[1e-6,0]},{"center":[0,0.5],"radius":0.125,"velocity":[0,0]}],
    "maneuvers":[{"t":1,"disk":0,"velocity":[1e5,0]}])",
                 "2",
                 {R"({"t":1,"maneuver":0})"},
                 0,
                 1};
  expect_certified(c);
}

// 10^99 images in a unit of time: no time is enough to look at all.
TEST(BilliardWindows, PastTooManyImages) {
  BilliardCase c{R"("frame":{"periodic":[1,null]},"disks":[
    {"center":[0,0],"radius":"1/10","velocity":["1e99",0]},
    {"center":[0,"1/4"],"radius":"1/10","velocity":[0,0]}])",
                 "1",
                 {}};
  for (const Truth truth : {Truth::recorded, Truth::exact}) {
    c.truth = truth;
    EXPECT_EQ(c.judge().verdict, Verdict::undecided);
  }
}

TEST(BilliardWindows, LongWaits) {
  expect_certified(
      {R"("frame":"none","disks":[{"center":[0,0],"radius":1e-6,"velocity":[1,0]}])", "1e12", {}});
  expect_certified({R"("frame":{"periodic":[8,8]},"disks":[
    {"center":[0,0],"radius":1e-3,"velocity":[1,0]},{"center":[0,4],"radius":1e-3,"velocity":[1,0]}])",
                    "1e6",
                    {}});
  expect_certified({R"("frame":{"periodic":[1,1]},"gravity":[1,1],"disks":[
    {"center":[0,0],"radius":0.1,"velocity":[0,0]},{"center":[0.5,0.5],"radius":0.1,"velocity":[0,0]}])",
                    "1000",
                    {}});
}

// Rows of disks around a box: each bounces between its neighbours, all at once.
BilliardCase rows_of_beads(int side) {
  BilliardCase c{"", "1", {}};
  const auto text = [](int x) { return std::to_string(x); };
  for (int k = 0; k < side * side; ++k) {
    c.members += (k ? "," : "") + (R"({"center":[)" + text(k % side) + "," + text(k / side)) +
                 R"(],"radius":0.25,"velocity":[)" + text(k % 2 ? -1 : 1) + ",0]}";
  }
  c.members = R"("frame":{"periodic":[)" + text(side) + "," + text(side) + R"(]},"disks":[)" +
              c.members + "]";
  for (const bool first : {true, false}) {
    for (int k = first ? 0 : 1; k < side * side; k += 2) {
      const bool last = k % side == side - 1;  // it meets the first of its row beyond the border
      const int left = last ? k - side + 1 : k, right = last ? k : k + 1;
      c.events.push_back(R"({"t":)" + std::string(first ? "0.25" : "0.75") + R"(,"collide":[)" +
                         text(left) + "," + text(right) + R"(],"image":[)" + text(last ? -1 : 0) +
                         R"(,0],"v":[[)" + text(last ? 1 : -1) + R"(,0],[)" + text(last ? -1 : 1) +
                         ",0]]}");
      ++c.collisions;
    }
  }
  return c;
}

TEST(BilliardWindows, ThreadsChangeNothing) {
  constexpr int side = 40;
  const BilliardCase right = rows_of_beads(side);
  std::vector<BilliardCase> cases{right};
  for (const int left_out : {0, 500, 1000, 1599}) {
    BilliardCase wrong = right;
    wrong.events.erase(wrong.events.begin() + left_out);
    if (left_out == 1000) wrong.events.erase(wrong.events.begin() + 100);
    cases.push_back(std::move(wrong));
  }
  for (BilliardCase& c : cases) {
    const Certificate one = c.judge();
    EXPECT_EQ(one.verdict, &c == cases.data() ? Verdict::certified : Verdict::refuted);
    c.threads = 3;
    const Certificate several = c.judge();
    EXPECT_EQ(several.verdict, one.verdict);
    EXPECT_EQ(several.pair_lives, one.pair_lives);
    if (!one.divergence || !several.divergence) continue;
    EXPECT_EQ(several.divergence->line, one.divergence->line);
    EXPECT_EQ(several.divergence->truth, one.divergence->truth);
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
