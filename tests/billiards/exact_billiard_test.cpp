// Histories of small billiards under the exact truth, derived by hand, and wrong ones.
#include "certify/billiards/exact_billiard.h"

#include <gtest/gtest.h>

#include "tests/billiards/billiard_cases.h"

namespace voroproof::internal::testing {
namespace {

BilliardCase exact(BilliardCase c) {
  c.truth = Truth::exact;
  return c;
}

TEST(ExactBilliard, HeadOn) {
  BilliardCase c = exact(head_on());
  expect_certified(c);
  for (const char* const t : {"2.0000005", "1.9999995"}) {
    c.events = {std::string(R"({"t":)") + t + R"(,"collide":[0,1],"v":[[0,0],[1,0]]})"};
    expect_certified(c);
  }
  for (const char* const t : {"2.000002", "1.999998"}) {
    c.events = {std::string(R"({"t":)") + t + R"(,"collide":[0,1],"v":[[0,0],[1,0]]})"};
    expect_refuted(c, Fault::wrong_time, 2);
  }
  c.events = {R"({"t":2,"collide":[0,1],"v":[[0,0],[1,0.001]]})"};
  expect_refuted(c, Fault::wrong_response, 2);
  c.events = {R"({"t":2,"collide":[0,1],"v":[[0,0],[1,0]],"p":[[2,0.1],[4,0]]})"};
  expect_refuted(c, Fault::wrong_response, 2);
  c.events = {R"({"t":2,"collide":[0,1]})"};
  expect_certified(c);
  EXPECT_EQ(c.judge().computed_velocities, 1);
  c.events.push_back(c.events.front());
  c.collisions = 2;
  expect_refuted(c, Fault::spurious_event, 3);
  c.events.clear();
  c.collisions = 0;
  expect_refuted(c, Fault::missing_event, 2);
}

// Times that are no fractions: the two touch at 4 - sqrt(2), which is 2.58578643762690495...
TEST(ExactBilliard, AtAnAngle) {
  BilliardCase c = exact({R"("frame":"none","disks":[
    {"center":[0,0],"radius":"1/2","velocity":[1,0],"mass":1},
    {"center":[4,1],"radius":"1/2","velocity":[0,0],"mass":1}])",
                          "5",
                          {},
                          0});
  // They come no nearer than 1: a graze, which is no contact.
  expect_certified(c);
  c.events = {R"({"t":4,"collide":[0,1]})"};
  c.collisions = 1;
  expect_refuted(c, Fault::spurious_event, 2);
  c.members = R"("frame":"none","disks":[
    {"center":[0,0],"radius":"1","velocity":[1,0],"mass":1},
    {"center":[4,"7/5"],"radius":"1","velocity":[0,0],"mass":1}])";
  // sqrt(4 - 49/25) = sqrt(51)/5, and n = (sqrt(51)/5, 7/5), n.n = 4: v_1 is 51/100 along the
  // first axis, and 7 sqrt(51)/100 along the second one.
  const std::string v = R"("v":[[0.49,-0.49989998999799943],[0.51,0.49989998999799943]]})";
  c.events = {R"({"t":2.5717143142854301,"collide":[0,1],)" + v};
  expect_certified(c);
  c.events = {R"({"t":2.5717163,"collide":[0,1],)" + v};
  expect_refuted(c, Fault::wrong_time, 2);
  c.events.clear();
  c.collisions = 0;
  expect_refuted(c, Fault::missing_event, 2);
}

// Where the recorded truth forgives a part in 10^9, the true motion is another after a while.
TEST(ExactBilliard, RoundingsThatGrow) {
  BilliardCase c = head_on();
  c.members.insert(c.members.size() - 1, R"(,{"center":[20006,0],"radius":1,"velocity":[0,0]})");
  c.horizon = "30000";
  c.events = {R"({"t":2,"collide":[0,1],"v":[[0,0],[1.0000000005,0]]})",
              R"({"t":20001.99999,"collide":[1,2],"v":[[0,0],[1.0000000005,0]]})"};
  c.collisions = 2;
  expect_certified(c);
  expect_refuted(exact(c), Fault::wrong_time, 3);
}

TEST(ExactBilliard, TheHorizon) {
  BilliardCase c = exact(head_on());
  c.horizon = "2";
  expect_certified(c);
  c.events.clear();
  c.collisions = 0;
  expect_refuted(c, Fault::missing_event, 2);
  c.horizon = "1.9999999";
  expect_certified(c);
  c.events = {R"({"t":1.9999999,"collide":[0,1]})"};
  c.collisions = 1;
  expect_refuted(c, Fault::spurious_event, 2);
}

// Three in a row touch at one instant, the second pair as the first one makes it.
TEST(ExactBilliard, Cradle) {
  for (const char* const horizon : {"5", "2"}) {
    BilliardCase c = exact({R"("frame":"none","disks":[
      {"center":[0,0],"radius":1,"velocity":[1,0]},
      {"center":[4,0],"radius":1,"velocity":[0,0]},
      {"center":[6,0],"radius":1,"velocity":[0,0]}])",
                            horizon,
                            {R"({"t":2,"collide":[0,1],"v":[[0,0],[1,0]]})",
                             R"({"t":2,"collide":[1,2],"v":[[0,0],[1,0]]})"},
                            2});
    expect_certified(c);
    std::swap(c.events[0], c.events[1]);
    EXPECT_EQ(c.judge().verdict, Verdict::refuted);
    c.events = {R"({"t":2,"collide":[0,1],"v":[[0,0],[1,0]]})"};
    c.collisions = 1;
    expect_refuted(c, Fault::missing_event, 3);
  }
}

// Two meet a third one at one instant from both sides: the smallest pair collides first.
TEST(ExactBilliard, FromBothSides) {
  BilliardCase c = exact({R"("frame":"none","disks":[
    {"center":[-4,0],"radius":1,"velocity":[1,0]},
    {"center":[0,0],"radius":1,"velocity":[0,0]},
    {"center":[4,0],"radius":1,"velocity":[-1,0]}])",
                          "5",
                          {R"({"t":2,"collide":[0,1],"v":[[0,0],[1,0]]})",
                           R"({"t":2,"collide":[1,2],"v":[[-1,0],[1,0]]})",
                           R"({"t":2,"collide":[0,1],"v":[[-1,0],[0,0]]})"},
                          3});
  expect_certified(c);
  c.events = {R"({"t":2,"collide":[1,2],"v":[[-1,0],[0,0]]})",
              R"({"t":2,"collide":[0,1],"v":[[-1,0],[1,0]]})",
              R"({"t":2,"collide":[1,2],"v":[[0,0],[1,0]]})"};
  expect_refuted(c, Fault::wrong_order, 2);
  // At a time that is no fraction nobody tells that they touch at once.
  c.members = R"("frame":"none","gravity":[0,0],"disks":[
    {"center":[-4,1],"radius":1,"velocity":[1,0]},
    {"center":[0,0],"radius":1,"velocity":[0,0]},
    {"center":[4,1],"radius":1,"velocity":[-1,0]}])";
  c.events = {R"({"t":2.2679491924311228,"collide":[0,1]})",
              R"({"t":2.2679491924311228,"collide":[1,2]})"};
  c.collisions = 2;
  const Certificate certificate = c.judge();
  EXPECT_EQ(certificate.verdict, Verdict::undecided);
  EXPECT_NE(certificate.reason.find("2048 bits"), std::string::npos) << certificate.reason;
}

// Two pairs that have nothing to do with each other, at one time or nearly so, come in any order.
TEST(ExactBilliard, PairsApart) {
  BilliardCase c = exact({R"("frame":"none","disks":[
    {"center":[0,0],"radius":1,"velocity":[1,0]},{"center":[4,1],"radius":1,"velocity":[0,0]},
    {"center":[0,9],"radius":1,"velocity":[1,0]},{"center":[4,10],"radius":1,"velocity":[0,0]}])",
                          "3",
                          {R"({"t":2.2679491924311228,"collide":[2,3]})",
                           R"({"t":2.2679491924311228,"collide":[0,1]})"},
                          2});
  expect_certified(c);
  EXPECT_EQ(c.judge().swaps, 0);
  c.members = R"("frame":"none","disks":[
    {"center":[0,0],"radius":1,"velocity":[1,0]},{"center":[4,0],"radius":1,"velocity":[0,0]},
    {"center":[0,9],"radius":1,"velocity":[1,0]},{"center":[4.0000005,9],"radius":1,"velocity":[0,0]}])";
  c.events = {R"({"t":2,"collide":[2,3]})", R"({"t":2,"collide":[0,1]})"};
  expect_certified(c);
  EXPECT_EQ(c.judge().swaps, 1);
}

TEST(ExactBilliard, Frames) {
  expect_certified(exact({R"("dimension":3,"frame":{"center":[1,0,0],"radius":10},
    "disks":[{"center":[1,0,0],"radius":1,"velocity":[1,2,2]}])",
                          "5",
                          {R"({"t":3,"collide":[-1,0],"v":[null,[-1,-2,-2]]})"},
                          1}));
  BilliardCase corner = exact({R"("frame":{"walls":[
    {"normal":[1,0],"offset":0},{"normal":[0,1],"offset":0},
    {"normal":[-1,0],"offset":-10},{"normal":[0,-1],"offset":-10}]},
    "disks":[{"center":[5,5],"radius":1,"velocity":[1,1]}])",
                               "6",
                               {R"({"t":4,"collide":[-4,0],"v":[null,[1,-1]]})",
                                R"({"t":4,"collide":[-3,0],"v":[null,[-1,-1]]})"},
                               2});
  expect_certified(corner);
  corner.events.pop_back();
  corner.collisions = 1;
  expect_refuted(corner, Fault::missing_event, 3);
  BilliardCase wrong = exact({R"("frame":{"periodic":[8,8]},"disks":[
    {"center":[1,4],"radius":0.5,"velocity":[-1,0]},{"center":[6,4],"radius":0.5,"velocity":[1,0]}])",
                              "2",
                              {R"({"t":1,"collide":[0,1],"image":[1,0],"v":[[1,0],[-1,0]]})"},
                              1});
  expect_refuted(wrong, Fault::wrong_image, 2);
  wrong.events = {R"({"t":1,"collide":[0,1],"v":[[1,0],[-1,0]]})"};
  expect_certified(wrong);
}

// On top of a fixed disk: gaps of degree 4. Pressed onto a floor, nothing is told.
TEST(ExactBilliard, UnderGravity) {
  BilliardCase pillar = exact({R"("frame":"none","gravity":[0,-1],"disks":[
    {"center":[0,4],"radius":1,"velocity":[0,0]},{"center":[0,0],"radius":1,"fixed":true}])",
                               "7",
                               {R"({"t":2,"collide":[0,1],"v":[[0,2],null]})",
                                R"({"t":6,"collide":[0,1],"v":[[0,2],[0,0]]})"},
                               2});
  expect_certified(pillar);
  pillar.events.pop_back();
  pillar.collisions = 1;
  expect_refuted(pillar, Fault::missing_event, 3);
  BilliardCase floor = exact({R"("frame":{"walls":[{"normal":[0,1],"offset":0}]},"gravity":[0,-1],
    "disks":[{"center":[0,1],"radius":1,"velocity":[1,0]}])",
                              "7",
                              {}});
  EXPECT_EQ(floor.judge().verdict, Verdict::undecided);
}

// A flight that passes the frame by so little that fractions are asked, in windows after that of
// the collision with which it began.
TEST(ExactBilliard, AnInstantIsJudgedOnce) {
  expect_certified(exact(
      {R"("gravity":[0,-1],"frame":{"center":[0,0],"radius":5},"disks":[
    {"center":["12/5","-16/5"],"radius":1,"velocity":[
      "90333601231993891221/28823037615171174400","-4112711630778374757/7205759403792793600"]}])",
       R"("2287/500")",
       {R"({"t":0,"collide":[-1,0],"v":[null,["380023827310773219/1152921504606846976","913264942091859153/288230376151711744"]]})"},
       1}));
}

// Times of degree 4 that are fractions are found to be so, at the horizon and at a maneuver.
TEST(ExactBilliard, FractionsAmongRootsOfDegreeFour) {
  BilliardCase c = exact({R"("frame":"none","gravity":[0,-18],"disks":[
    {"center":[0,0],"radius":1,"fixed":true},{"center":[0,3],"radius":1,"velocity":[0,0]}])",
                          "1",
                          {R"({"t":0.3333333333333333,"collide":[0,1],"v":[null,[0,6]]})",
                           R"({"t":1,"collide":[0,1],"v":[null,[0,6]],"p":[null,[0,2]]})"},
                          2});
  expect_certified(c);
  c.events.pop_back();
  c.collisions = 1;
  expect_refuted(c, Fault::missing_event, 3);
  BilliardCase turned = exact({R"("frame":"none","gravity":[0,-8],"disks":[
    {"center":[0,0],"radius":1,"fixed":true},{"center":[0,3],"radius":1,"velocity":[0,0]}],
    "maneuvers":[{"t":0.5,"disk":1,"velocity":[5,0]}])",
                               "0.75",
                               {R"({"t":0.5,"collide":[0,1],"v":[null,[0,4]]})",
                                R"({"t":0.5,"maneuver":1,"v":[5,0],"p":[0,2]})"},
                               1,
                               1});
  expect_certified(turned);
}

// A claim that cannot be told does not make others wrong: the last one, of two disks far away, is
// within less than 2^-300 of its tolerance.
TEST(ExactBilliard, WhatCannotBeToldRefutesNothing) {
  BilliardCase c = exact(
      {R"("frame":"none","gravity":[0,-18],"disks":[
    {"center":[0,0],"radius":1,"fixed":true},{"center":[0,3],"radius":1,"velocity":[0,0]},
    {"center":[100,0],"radius":1,"velocity":[1,0]},
    {"center":["1028319/10000",0],"radius":1,"velocity":[0,0]},
    {"center":[0,11],"radius":1,"velocity":[0,0]},
    {"center":[200,0],"radius":1,"velocity":[1,0]},
    {"center":["506410127/2500000",1],"radius":1,"velocity":[0,0]}])",
       R"("5/6")",
       {R"({"t":"997/3000","collide":[0,1]})", R"({"t":"2497/3000","collide":[1,4]})",
        R"({"t":"333/400","collide":[2,3]})",
        R"({"t":"83299999243112270647255365849412763305719474618961937194419202054806698309119996291885381324275142432437385858459329697/100000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000","collide":[5,6]})"},
       4});
  c.tolerance = Rational(1, 1000);
  EXPECT_NE(c.judge().verdict, Verdict::refuted) << c.judge().divergence->truth;
}

// Neither truth has a law for it, and another fault is one nevertheless.
TEST(ExactBilliard, TwoThatCannotMove) {
  for (const Truth truth : {Truth::recorded, Truth::exact}) {
    const auto scene = [](const std::string& x) {
      return R"("frame":{"walls":[{"normal":[1,0],"offset":0}]},"disks":[
        {"center":[2,0],"radius":1,"growth":"1/2","fixed":true},
        {"center":[)" +
             x + R"(,0],"radius":1,"velocity":[-1,0]}])";
    };
    BilliardCase c{scene("9"), "3", {}};
    c.truth = truth;
    EXPECT_EQ(c.judge().verdict, Verdict::undecided);
    c.horizon = "2";
    EXPECT_EQ(c.judge().verdict, Verdict::undecided);
    c.horizon = "3";
    c.events = {R"({"t":2,"collide":[-1,0]})"};
    c.collisions = 1;
    EXPECT_EQ(c.judge().verdict, Verdict::undecided);
    c.events = {R"({"t":1,"collide":[-1,0]})"};
    EXPECT_EQ(c.judge().verdict, Verdict::refuted);
    BilliardCase other{scene("6"), "3", {}};  // the second disk comes at t = 4/3
    other.truth = truth;
    expect_refuted(other, Fault::missing_event, 2);
  }
}

// Numbers near the end of the range are off, and said to be.
TEST(ExactBilliard, FarClaims) {
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    BilliardCase c = head_on();
    c.truth = truth;
    c.events = {R"({"t":2,"collide":[0,1],"v":[[1.7e308,1.7e308],[1.7e308,0]]})"};
    expect_refuted(c, Fault::wrong_response, 2);
    c.events = {R"({"t":2,"collide":[0,1],"v":[[0,0],[1,0]],"p":[[1.7e308,1.7e308],[4,0]]})"};
    expect_refuted(c, Fault::wrong_response, 2);
  }
}

TEST(ExactBilliard, Maneuvers) {
  BilliardCase c = exact({R"("frame":"none","disks":[
    {"center":[0,0],"radius":1,"velocity":[1,0]},{"center":[4,0],"radius":1,"velocity":[0,0]}],
    "maneuvers":[{"t":1,"disk":0,"velocity":[0,1]}])",
                          "5",
                          {R"({"t":1.0000001,"maneuver":0,"v":[0,1],"p":[1,0]})"},
                          0,
                          1});
  expect_certified(c);
  c.events.clear();
  c.maneuvers = 0;
  expect_refuted(c, Fault::missing_event, 2);
  // The maneuver comes a little before the collision that it would avert, and is told after it.
  c.members = R"("frame":"none","disks":[
    {"center":[0,0],"radius":1,"velocity":[1,0]},{"center":[4,0],"radius":1,"velocity":[0,0]}],
    "maneuvers":[{"t":1.9999995,"disk":0,"velocity":[0,1]}])";
  c.events = {R"({"t":2,"collide":[0,1]})", R"({"t":2,"maneuver":0})"};
  c.collisions = c.maneuvers = 1;
  expect_refuted(c, Fault::wrong_order, 3);
  BilliardCase later = c;
  later.members = R"("frame":"none","disks":[
    {"center":[0,0],"radius":1,"velocity":[1,0],"mass":1},
    {"center":[4,"7/5"],"radius":1,"velocity":[0,0],"mass":1}],
    "maneuvers":[{"t":2.571714,"disk":0,"velocity":[-1,0]}])";
  later.events = {R"({"t":2.5717143142854301,"collide":[0,1]})", R"({"t":2.5717144,"maneuver":0})"};
  expect_refuted(later, Fault::wrong_order, 3);
  // At one instant collisions come first.
  c.members.replace(c.members.find("1.9999995"), 9, "2");
  expect_certified(c);
  std::swap(c.events[0], c.events[1]);
  EXPECT_EQ(c.judge().verdict, Verdict::refuted);
}

TEST(ExactBilliard, HistoriesThatStop) {
  BilliardCase c = exact(head_on());
  c.members.insert(c.members.size() - 1, R"(,{"center":[8,0],"radius":1,"velocity":[0,0]})");
  c.horizon = "9";
  const auto verdict = [&](const std::string& t) {
    c.last = R"({"stopped":{"t":)" + t + R"(,"reason":"a limit"}})";
    return c.judge().verdict;
  };
  for (const char* const t : {"2", "3", "4", "4.0000005"})
    EXPECT_EQ(verdict(t), Verdict::undecided) << t;
  EXPECT_EQ(verdict("4.1"), Verdict::refuted);
}

}  // namespace
}  // namespace voroproof::internal::testing
