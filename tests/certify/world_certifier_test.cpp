// Histories of small worlds, derived by hand, and wrong ones.
#include <gtest/gtest.h>

#include <vector>

#include "tests/certify/world_cases.h"

namespace voroproof::internal {
namespace {

using Case = WorldCase;

// ---- One disk passes through another ---------------------------------------------------

Case passing() {
  return {circle(20, 20, {disk(0, 0, 5), disk(-10, 0, 1, 1)}),
          edges_of_two(0, 1),
          {{6, Hide{1, 0}}, {14, Appear{1, 0, std::nullopt}}}};
}

TEST(WorldCertifier, OneDiskPassesThroughAnother) {
  const Case right = passing();
  expect_right(right);
  expect_no_fault_certified(right);
  expect_wrong(
      right,
      [](Case& c) {
        c.events[0].what = Hide{0, 1};
      },
      "does not come into");
  expect_wrong(
      right,
      [](Case& c) {
        c.events[0].what = Hide{1, -1};
      },
      "does not come into");
  expect_wrong(
      right,
      [](Case& c) {
        c.events[1].what = Appear{1, -1, std::nullopt};
      },
      "does not leave");
  expect_wrong(
      right,
      [](Case& c) {
        c.events[1].what = Appear{0, 1, std::nullopt};
      },
      "is not hidden");
  expect_wrong(
      right,
      [](Case& c) {
        c.events[1].what = Appear{1, 0, Quad{0, 1, -1, -1}};
      },
      "no edge");
  expect_wrong(
      right, [](Case& c) { c.events.pop_back(); }, "is visible");
  expect_wrong(
      right, [](Case& c) { c.events.erase(c.events.begin()); }, "one is hidden");
  expect_wrong(
      right,
      [](Case& c) {
        c.events.push_back({15, Hide{1, 0}});
      },
      "no such event");
  expect_wrong(
      right, [](Case& c) { c.initial.clear(); }, "two disks are visible");
}

TEST(WorldCertifier, HiddenAtTheStartAndAtTheHorizon) {
  Case c = passing();
  c.world.disks[1].state.x = 0;
  c.world.horizon = 4;
  c.initial.clear();
  c.events = {{4, Appear{1, 0, std::nullopt}}};
  expect_right(c);
  expect_no_fault_certified(c);
  c.world.horizon = Rational(399999999, 100000000);
  expect_wrong(
      c, [](Case&) {}, "no such event");
}

TEST(WorldCertifier, ATouchFromInsideIsNoEvent) {
  // The path touches the circle of radius 4 around the larger one from outside.
  Case c{circle(20, 20, {disk(0, 0, 5), disk(-10, 4, 1, 1)}), edges_of_two(0, 1), {}};
  expect_right(c);
  expect_wrong(
      c,
      [](Case& w) {
        w.events = {{10, Hide{1, 0}}};
      },
      "does not come into");
}

TEST(WorldCertifier, GrowthSwallowsAndLeavesTheFrame) {
  // Radius 1 + t and distance 10: the one is in the other from t = 10 on.
  Case c{circle(30, 11, {disk(0, 0, 1, 0, 0, 1), disk(10, 0, 1)}),
         edges_of_two(0, 1),
         {{10, Hide{1, 0}}}};
  expect_right(c);
  expect_no_fault_certified(c);
}

// ---- Disks that change places ----------------------------------------------------------

TEST(WorldCertifier, TwoEqualDisksChangePlaces) {
  const Case right{circle(20, 10, {disk(-5, 0, 1, 1), disk(5, 0, 1, -1)}),
                   edges_of_two(0, 1),
                   {{5, Swap{0, 1}}}};
  expect_right(right);
  expect_no_fault_certified(right);
  expect_wrong(
      right,
      [](Case& c) {
        c.events[0].what = Hide{1, 0};
      },
      "does not come into");
}

TEST(WorldCertifier, ASwapExchangesNames) {
  // A third one above them: [0,1] left and right below it before, right and left afterwards.
  const Case right{plane(10, {disk(-5, 0, 1, 1), disk(5, 0, 1, -1), disk(0, 8, 1)}),
                   edges_of({{0, 1, 2}, {1, 0, -1}, {2, 1, -1}, {0, 2, -1}}),
                   {{5, Swap{0, 1}}}};
  expect_right(right);
  expect_no_fault_certified(right);
}

TEST(WorldCertifier, HiddenBeforeAndAfterASwap) {
  // Radii 2 - t and t at one place: the larger one changes at 1.
  const Case right{
      circle(20, 2, {disk(0, 0, 2, 0, 0, -1), disk(0, 0, 0, 0, 0, 1)}), {}, {{1, Swap{0, 1}}}};
  expect_right(right);
  expect_no_fault_certified(right);
  expect_wrong(
      right,
      [](Case& c) {
        c.events[0].what = Appear{1, 0, std::nullopt};
      },
      "does not leave");
}

TEST(WorldCertifier, ThreeThatCoincideAreUndecided) {
  Case c{circle(20, 10, {disk(-5, 0, 1, 1), disk(5, 0, 1, -1), disk(0, 5, 1, 0, -1)}),
         edges_of({{0, 1, 2}, {1, 0, -1}, {2, 1, -1}, {0, 2, -1}}),
         {{5, Swap{0, 1}}}};
  EXPECT_EQ(judge(c).kind, Verdict::undecided) << judge(c).reason;
}

TEST(WorldCertifier, IdenticalForEver) {
  Case c{circle(20, 10, {disk(-5, 0, 1, 1), disk(-5, 0, 1, 1)}), {}, {}};
  expect_right(c);
  expect_wrong(
      c, [](Case& w) { w.initial = edges_of_two(0, 1); }, "hidden");
}

// ---- A flip ----------------------------------------------------------------------------

// Of four disks on the axes those above and below the others go away.
Case four(bool in_plane) {
  std::vector<WorldDisk> disks{disk(-2, 0, {1, 2}), disk(2, 0, {1, 2}), disk(0, -1, {1, 2}, 0, -1),
                               disk(0, 1, {1, 2}, 0, 1)};
  return {in_plane ? plane(3, disks) : circle(100, 3, disks),
          edges_of({{0, 2, 3}, {1, 3, 2}, {2, 0, -1}, {1, 2, -1}, {3, 1, -1}, {0, 3, -1}}),
          {{1, Quad{2, 3, 1, 0}}}};
}

TEST(WorldCertifier, OneFlip) {
  for (const bool in_plane : {true, false}) {
    const Case right = four(in_plane);
    expect_right(right);
    expect_no_fault_certified(right);
    expect_wrong(
        right,
        [](Case& c) {
          c.events[0].what = Quad{2, 3, 0, 1};
        },
        "no edge");
    expect_wrong(
        right,
        [](Case& c) {
          c.events[0].what = Quad{0, 2, 3, -1};
        },
        "no edge");
    expect_wrong(
        right,
        [](Case& c) {
          c.events.push_back({2, Quad{1, 0, 3, 2}});
        },
        "no such event");
    // Back at the same instant, which changes nothing.
    expect_wrong(
        right,
        [](Case& c) {
          c.events.push_back({1, Quad{0, 1, 2, 3}});
        },
        "no such event");
    expect_wrong(
        right, [](Case& c) { c.world.horizon = Rational(999999, 1000000); }, "no such event");
    Case at_horizon = right;
    at_horizon.world.horizon = 1;
    expect_right(at_horizon);
    expect_no_fault_certified(at_horizon);
  }
}

TEST(WorldCertifier, CotangentForEverTheLargestIdDecides) {
  Case c = four(true);
  for (WorldDisk& d : c.world.disks) d.state.vy = 0;
  c.world.disks[2].state.y = -2;
  c.world.disks[3].state.y = 2;
  c.events.clear();
  expect_right(c);  // 2 and 3 are neighbours
  c.initial = edges_of({{0, 2, 1}, {0, 1, 3}, {2, 0, -1}, {1, 2, -1}, {3, 1, -1}, {0, 3, -1}});
  expect_wrong(
      c, [](Case&) {}, "is not there");
}

TEST(WorldCertifier, ADiagramThatIsAnotherAtTheStart) {
  Case c = four(true);
  c.initial = edges_of({{0, 2, 1}, {0, 1, 3}, {2, 0, -1}, {1, 2, -1}, {3, 1, -1}, {0, 3, -1}});
  expect_wrong(
      c, [](Case&) {}, "is not there");
  // Mirrored.
  c.initial = edges_of({{0, 3, 2}, {1, 2, 3}, {0, 2, -1}, {2, 1, -1}, {1, 3, -1}, {3, 0, -1}});
  EXPECT_EQ(judge(c).kind, Verdict::refuted);
}

TEST(WorldCertifier, Endings) {
  const Case right = passing();
  WorldCertifier counts(right.world, right.initial);
  for (const WorldEvent& e : right.events) counts.event(e, 2);
  EXPECT_EQ(counts.finish(WorldEnd{}, 4).kind, Verdict::refuted);
  WorldCertifier stops(right.world, right.initial);
  stops.event(right.events[0], 2);
  EXPECT_EQ(stops.finish(WorldStop{10, "tired"}, 3).kind, Verdict::undecided);
  WorldCertifier late(right.world, right.initial);
  late.event(right.events[0], 2);
  EXPECT_EQ(late.finish(WorldStop{15, "tired"}, 3).kind, Verdict::refuted);
}

}  // namespace
}  // namespace voroproof::internal
