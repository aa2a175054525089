// Histories of small worlds, derived by hand, and wrong ones: jumps, few visible disks, hosts.
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/certify/world_cases.h"

namespace voroproof::internal {
namespace {

using Case = WorldCase;

// ---- Jumps -----------------------------------------------------------------------------

// One between three others goes out and in again, a little further on.
Case jumping() {
  Case c;
  c.world = plane(4, {disk(-6, -4, 1), disk(6, -4, 1), disk(0, 8, 1), disk(0, 0, 1)});
  c.world.maneuvers.push_back({2, 3, Point2{1, 0}, std::nullopt, std::nullopt, std::nullopt});
  c.initial = edges_of({{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, -1}, {2, 1, -1}, {0, 2, -1}});
  Jump jump;
  jump.g = 3;
  jump.out = std::vector<Step>{Quad{0, 3, 1, 2}, Hide{3, 1}};
  jump.in = std::vector<Step>{Appear{3, 1, Quad{1, 2, -1, 0}}, Quad{1, 2, 3, 0}};
  jump.center = Point2{1, 0};
  c.events = {{2, jump}};
  return c;
}

TEST(WorldJumps, AJumpOutAndIn) {
  const Case right = jumping();
  expect_right(right);
  expect_no_fault_certified(right);
  const auto jump = [](Case& c) -> Jump& { return std::get<Jump>(c.events[0].what); };
  expect_wrong(
      right, [&](Case& c) { jump(c).in->pop_back(); }, "is not there");
  expect_wrong(
      right, [&](Case& c) { jump(c).in->clear(); }, "is visible");
  expect_wrong(
      right,
      [&](Case& c) {
        jump(c).in->front() = Appear{3, 1, Quad{1, 2, 0, -1}};
      },
      "not possible");
  expect_wrong(
      right, [&](Case& c) { jump(c).out->pop_back(); }, "its cell stays");
  expect_wrong(
      right,
      [&](Case& c) {
        jump(c).center = Point2{0, 1};
      },
      "another");
  expect_wrong(
      right, [&](Case& c) { jump(c).g = 2; }, "does not jump");
  // Into another edge: an edge is not legal, or a cell does not wind once.
  expect_wrong(
      right,
      [&](Case& c) {
        jump(c).in = std::vector<Step>{Appear{3, 1, Quad{1, 2, -1, 0}}, Quad{1, 2, -1, 3}};
      },
      "");
  // To where another one hides it.
  Case hidden = right;
  hidden.world.maneuvers[0].center = Point2{6, -4};
  hidden.world.maneuvers[0].radius = Rational(1, 2);
  jump(hidden).center = Point2{6, -4};
  jump(hidden).in->clear();
  expect_right(hidden);
  expect_no_fault_certified(hidden);
  expect_wrong(
      hidden, [&](Case& c) { jump(c).in = std::get<Jump>(right.events[0].what).in; }, "");
}

// Two disks, and a third that comes above them, and goes.
Case coming() {
  Case c;
  c.world = plane(6, {disk(-4, 0, 1), disk(4, 0, 1), disk(0, 3, 1)});
  c.world.disks[2].enter = 2;
  c.world.disks[2].leave = 4;
  c.initial = edges_of_two(0, 1);
  Jump in, out;
  in.g = out.g = 2;
  in.in = std::vector<Step>{Appear{2, 0, Quad{0, 1, -1, -1}}, Quad{0, 1, 2, -1}};
  out.out = std::vector<Step>{Quad{-1, 2, 0, 1}, Hide{2, 0}};
  c.events = {{2, in}, {4, out}};
  return c;
}

TEST(WorldJumps, ADiskComesAndGoes) {
  const Case right = coming();
  expect_right(right);
  expect_no_fault_certified(right);
  Case at_horizon = right;
  at_horizon.world.horizon = 4;
  expect_right(at_horizon);
  expect_no_fault_certified(at_horizon);
  expect_wrong(
      right, [](Case& c) { std::get<Jump>(c.events[0].what).in->pop_back(); }, "not there");
  // Below instead of above.
  expect_wrong(
      right,
      [](Case& c) {
        auto& in = *std::get<Jump>(c.events[0].what).in;
        in[1] = Quad{0, 1, -1, 2};
      },
      "");
  expect_wrong(
      right, [](Case& c) { std::get<Jump>(c.events[0].what).out = std::vector<Step>{}; },
      "was not there");
  expect_wrong(
      right, [](Case& c) { std::get<Jump>(c.events[1].what).in = std::vector<Step>{}; },
      "is not there afterwards");
}

// ---- Few visible disks -----------------------------------------------------------------

TEST(WorldJumps, OneAndNoVisibleDisk) {
  const Case right{circle(10, 20, {disk(20, 0, 1, -2)}),
                   {},
                   {{{9, 2}, Appear{0, -1, std::nullopt}}, {{31, 2}, Hide{0, -1}}}};
  expect_right(right);
  expect_no_fault_certified(right);
  expect_wrong(
      right, [](Case& c) { c.events[0].t = 4; }, "no such event");
  expect_wrong(
      right, [](Case& c) { c.events.clear(); }, "is visible");
  expect_wrong(
      right, [](Case& c) { c.events.pop_back(); }, "outside of the frame");
  expect_right({circle(10, 20, {}), {}, {}});
  expect_right({plane(20, {disk(20, 0, 1, -2)}), {}, {}});
}

TEST(WorldJumps, ComesAndGoesBesideOneAndNone) {
  Case c;
  c.world = plane(8, {disk(0, 0, 1), disk(5, 0, 1)});
  c.world.disks[0].enter = 1;
  c.world.disks[0].leave = 6;
  c.world.disks[1].enter = 2;
  c.world.disks[1].leave = 7;
  const auto in = [](GenId g) {
    Jump jump;
    jump.g = g;
    jump.in = std::vector<Step>{Appear{g, -1, std::nullopt}};
    return jump;
  };
  const auto out = [](GenId g, std::vector<Step> steps) {
    Jump jump;
    jump.g = g;
    jump.out = std::move(steps);
    return jump;
  };
  c.events = {{1, in(0)}, {2, in(1)}, {6, out(0, {Hide{0, 1}})}, {7, out(1, {})}};
  expect_right(c);
  expect_no_fault_certified(c);
  Case untold = c;  // of how one goes beside one visible disk nothing need be told
  untold.events[2].what = out(0, {});
  expect_right(untold);
  expect_wrong(
      c,
      [&](Case& w) {
        w.events[2].what = out(0, {Hide{1, 0}});
      },
      "");
  std::get<Jump>(c.events[3].what).out = std::vector<Step>{Hide{1, -1}};
  expect_right(c);
}

TEST(WorldJumps, HostsChangeWithoutAnEvent) {
  // The small one goes from one large disk to another, which overlap.
  const Case right{circle(40, 15, {disk(0, 0, 5), disk(6, 0, 5), disk(0, 0, 1, 1)}),
                   edges_of_two(0, 1),
                   {{10, Appear{2, 1, Quad{1, -1, 0, 0}}}}};
  const WorldVerdict v = judge(right);
  EXPECT_EQ(v.kind, Verdict::certified) << v.t << " " << v.reason;
  expect_wrong(
      right,
      [](Case& c) {
        c.events[0].what = Appear{2, 0, Quad{0, -1, 1, 1}};
      },
      "does not leave");
  expect_wrong(
      right,
      [](Case& c) {
        c.events[0].what = Appear{2, 1, Quad{1, 0, -1, -1}};
      },
      "");
  expect_wrong(
      right, [](Case& c) { c.events[0].t = 4; }, "no such event");
}

TEST(WorldJumps, TouchingFromInsideForAWhileIsHidden) {
  // It stops where it touches the circle of the other from inside, and goes back outwards.
  Case c{circle(40, 10, {disk(0, 0, 5), disk(10, 0, 1, -2)}), edges_of_two(0, 1), {}};
  c.world.maneuvers.push_back({3, 1, std::nullopt, Point2{0, 0}, std::nullopt, std::nullopt});
  c.world.maneuvers.push_back({5, 1, std::nullopt, Point2{1, 0}, std::nullopt, std::nullopt});
  PathTurn stop, go;
  stop.g = go.g = 1;
  stop.velocity = Point2{0, 0};
  go.velocity = Point2{1, 0};
  c.events = {{3, stop}, {3, Hide{1, 0}}, {5, go}, {5, Appear{1, 0, std::nullopt}}};
  expect_right(c);
  expect_no_fault_certified(c);
  expect_wrong(
      c,
      [](Case& w) {
        std::get<PathTurn>(w.events[0].what).velocity = Point2{0, 1};
      },
      "another");
}

}  // namespace
}  // namespace voroproof::internal
