// Histories that err once, in the diagram, and go on consistently in their own world.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "tests/certify/claimed_history.h"
#include "tests/certify/handmade_history.h"

namespace voroproof::internal::testing {
namespace {

// Two flips of several with their ends exchanged, in a file that could have told.
TEST(ConsistentFaults, SomeQuadrupletsMirrored) {
  const Scene scene = scene_of(30, 40,
                               {disk(-9, 3, 2, 1, 0.25), disk(8, -2, 3, -1, 0.5),
                                disk(1, 11, 1, 0.125, -1), disk(-3, -9, 2, 0.5, 0.75)});
  const History right = claimed_history(scene, run(scene));
  expect_certified(scene, right);
  std::vector<std::size_t> flips;
  for (std::size_t k = 0; k < right.events.size(); ++k) {
    if (std::holds_alternative<FlipEvent>(right.events[k])) flips.push_back(k);
  }
  ASSERT_GE(flips.size(), 3u);
  for (std::size_t mirrored = 1; mirrored <= flips.size(); mirrored += 2) {
    History h = right;
    for (std::size_t k = 0; k < mirrored; ++k) {
      Quad& q = std::get<FlipEvent>(h.events[flips[k]]).quad;
      std::swap(q.s, q.e);
      q = canonical(q);
    }
    expect_refuted(scene, h);
    CertifyOptions options;
    options.unoriented = true;
    expect(Verdict::certified, scene, h, Truth::exact, options);
    expect(Verdict::certified, scene, h, Truth::recorded, options);
  }
}

// Four cocircular disks at rest, of which one is hit at t = 0 by a fifth. The diagram at 0+ depends
// on that blow. Claimed a little later, behind the diagram of before it and a flip that never is.
TEST(ConsistentFaults, DiagramBeforeACollisionAtStart) {
  const std::vector<DiskInput> disks{disk(3, 0, 0.5, 0, 0), disk(0, 3, 0.5, 0, 0),
                                     disk(-3, 0, 0.5, 0, 0), disk(0, -3, 0.5, 0, 0)};
  int changed = 0;
  for (int target = 0; target < 4; ++target) {
    const double x = disks[target].x.value().get_d(), y = disks[target].y.value().get_d();
    for (const int inwards : {1, -1}) {
      std::vector<DiskInput> with = disks;
      // Beside the target, on the side from which the blow comes.
      with.push_back(disk(x * (1 + inwards / 3.0), y * (1 + inwards / 3.0), 0.5, -inwards * x / 3,
                          -inwards * y / 3));
      const Scene scene = scene_of(20, 1, with);
      if (!is_acceptable(scene)) continue;
      const History right = claimed_history(scene, run(scene));
      expect_certified(scene, right);
      std::vector<DiskInput> before = with;
      before.back().vx = 0;
      before.back().vy = 0;
      const auto old = run(scene_of(20, 1, before)).initial;
      if (old == *right.header.initial) continue;
      ++changed;
      std::vector<Quad> gone, come;
      for (const Quad& q : old) {
        if (std::find(right.header.initial->begin(), right.header.initial->end(), q) ==
            right.header.initial->end()) {
          gone.push_back(q);
        }
      }
      // The one flip that leads from the old diagram to the right one.
      for (const Quad& q : gone) {
        History wrong = right;
        wrong.header.initial = old;
        std::get<CollideEvent>(wrong.events.front()).t = 5e-7;
        std::get<CollideEvent>(wrong.events.front()).p = {};
        wrong.events.insert(wrong.events.begin(), FlipEvent{2e-7, q, {}});
        wrong.count();
        expect(Verdict::refuted, scene, wrong, Truth::exact);
      }
    }
  }
  EXPECT_GT(changed, 0);
}

// A swarm so fast that it flips many edges within the tolerance, beside two disks that touch and
// approach at t = 0.
Scene swarm() {
  std::mt19937_64 random(1);
  const auto between = [&random](double lo, double hi) {
    return lo + (hi - lo) * 0x1p-64 * static_cast<double>(random());
  };
  std::vector<DiskInput> disks{disk(16, 0, 0.5, 1, 0), disk(17, 0, 0.5, -1, 0)};
  for (int k = 0; k < 120; ++k) {
    disks.push_back(
        disk(between(-12, 12), between(-12, 12), 0x1p-20, between(-3e6, 3e6), between(-3e6, 3e6)));
  }
  return scene_of(20, 0x1p-20, disks);
}

// The history with its k-th event told behind so many others, at the time of the last of them.
History told_late(const History& history, std::size_t k, std::size_t passed) {
  History late = history;
  internal::Event event = history.events[k];
  const double t = time(history.events[k + passed]);
  std::visit(
      [t](auto& e) {
        e.t = t;
        if constexpr (!std::is_same_v<decltype(e), FlipEvent&>) e.p = {};
      },
      event);
  const auto from = late.events.begin() + static_cast<std::ptrdiff_t>(k);
  late.events.erase(from);
  late.events.insert(late.events.begin() + static_cast<std::ptrdiff_t>(k + passed), event);
  return late;
}

// A collision at t = 0 that is claimed within the tolerance, but behind more claims than are looked
// at together: the first diagram was judged without it.
TEST(ConsistentFaults, ATurnAtStartBehindManyClaims) {
  const Scene scene = swarm();
  const History right = claimed_history(scene, run(scene));
  expect(Verdict::certified, scene, right, Truth::exact);
  ASSERT_TRUE(std::holds_alternative<CollideEvent>(right.events.front()));
  ASSERT_EQ(time(right.events.front()), 0);
  ASSERT_GT(right.events.size(), 100u);
  expect(Verdict::certified, scene, told_late(right, 0, 100), Truth::exact);
  CertifyOptions options;
  options.most_near = 64;
  expect(Verdict::certified, scene, told_late(right, 0, 10), Truth::exact, options);
  expect(Verdict::undecided, scene, told_late(right, 0, 100), Truth::exact, options);
}

// A flip behind so many others: whoever depends on it comes without it, and is not refuted.
TEST(ConsistentFaults, AFlipBehindManyClaims) {
  const Scene scene = swarm();
  const History right = claimed_history(scene, run(scene));
  int certified = 0;
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    for (std::size_t k = 1; k < 20; ++k) {
      const History late = told_late(right, k, 100);
      CertifyOptions options;
      options.truth = truth;
      // Not all flips may be told out of order: some name edges that others lead to.
      if (certify(scene, late, options).verdict != Verdict::certified) continue;
      ++certified;
      options.most_near = 64;
      expect(Verdict::undecided, scene, late, truth, options);
    }
  }
  EXPECT_GT(certified, 5);
}

// Five disks in the order of the corners of a pentagram, and one in their middle: a first diagram
// in which all circles exist and all edges are legal, and that covers the container twice. In the
// order of the corners of a pentagon it is the diagram. One of the two pentagons has a vertex on
// the x axis, so that doubles do not decide how it winds.
TEST(ConsistentFaults, CellsThatWindTwice) {
  const double corners[2][5][2] = {{{10, 0}, {3, 9.5}, {-8, 6}, {-8, -6}, {3, -9.5}},
                                   {{9.8, 1.7}, {1.4, 9.9}, {-9, 4.4}, {-7, -7.2}, {4.7, -8.8}}};
  for (const auto& corner : corners) {
    for (const int step : {1, 2}) {
      std::vector<DiskInput> disks;
      std::vector<Quad> initial;
      for (int k = 0; k < 5; ++k) {
        const auto& [x, y] = corner[k * step % 5];
        disks.push_back(disk(x, y, 1, 0, 0));
        const int before = (k + 4) % 5, after = (k + 1) % 5;
        initial.push_back({5, k, before, after});
        initial.push_back({k, after, -1, 5});
        initial.push_back({-1, k, after, before});
      }
      disks.push_back(disk(0, 0, 1, 0, 0));
      const Scene scene = scene_of(100, 3, disks);
      const History h = history_of(scene, initial, {});
      if (step == 1) {
        expect_certified(scene, h);
      } else {
        expect_refuted(scene, h);
      }
    }
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
