// Rules of docs/certificate.md that no other test fails without, one test each.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/certify/claimed_history.h"
#include "tests/certify/handmade_history.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
namespace {

using Claims = std::vector<voroproof::internal::Event>;

Certificate judged(const Scene& scene, const ClaimedHistory& h, Truth truth) {
  CertifyOptions options;
  options.truth = truth;
  return certify(scene, h, options);
}

std::string told(const Scene& scene, const ClaimedHistory& h, const Certificate& c) {
  return reason_line(c) + "\n" + text(scene) + text(h);
}

// A scene whose first event is a flip, and what the engine says of it up to soon after.
struct FirstFlip {
  Scene scene;
  ClaimedHistory history;  // the flip is its only event
  double t;
};
std::vector<FirstFlip> first_flips(int count) {
  std::vector<FirstFlip> all;
  Random random(7);
  while (static_cast<int>(all.size()) < count) {
    Scene scene = random_scene({.n = 8, .rmin = 1, .rmax = 9}, random);
    scene.horizon = 5;
    const ClaimedHistory whole = claimed_history(scene, run(scene));
    if (whole.events.size() < 2 || !std::holds_alternative<FlipEvent>(whole.events[0])) continue;
    const double t = time(whole.events[0]);
    if (t < 0.01 || time(whole.events[1]) < t + 1e-5) continue;
    ClaimedHistory h = whole;
    h.events.resize(1);
    h.count();
    all.push_back({scene, h, t});
  }
  return all;
}

// With another horizon, and the flip at it at the latest or left out.
ClaimedHistory ending_at(const FirstFlip& f, double horizon, bool with_flip) {
  ClaimedHistory h = f.history;
  h.header.horizon = to_rational(horizon);
  if (with_flip) {
    std::get<FlipEvent>(h.events[0]).t = std::min(f.t, horizon);
  } else {
    h.events.clear();
  }
  h.count();
  return h;
}

// Judges histories that end `later` than a flip of theirs, or before it where that is negative,
// with the flip claimed and without. Under the exact truth it must be claimed if it is an event.
// Under the recorded one both are right, and the certificate counts under `leniency` what is not
// so.
void judge_at_the_horizon(double later, bool is_event, std::int64_t Certificate::*leniency) {
  for (const FirstFlip& f : first_flips(6)) {
    Scene scene = f.scene;
    const double horizon = f.t + later;
    scene.horizon = to_rational(horizon);
    for (const bool claimed : {true, false}) {
      const ClaimedHistory h = ending_at(f, horizon, claimed);
      const Certificate exact = judged(scene, h, Truth::exact);
      EXPECT_EQ(exact.verdict, claimed == is_event ? Verdict::certified : Verdict::refuted)
          << told(scene, h, exact);
      const Certificate recorded = judged(scene, h, Truth::recorded);
      EXPECT_EQ(recorded.verdict, Verdict::certified) << told(scene, h, recorded);
      EXPECT_EQ(recorded.*leniency, claimed == is_event ? 0 : 1);
    }
  }
}

// Rule 3.14: a flip within the tolerance after the horizon is no event. Under the recorded truth it
// may be claimed, which is counted.
TEST(Rules, FlipsAfterTheHorizon) { judge_at_the_horizon(-1e-7, false, &Certificate::at_horizon); }

// The same rule for a flip within the tolerance before the horizon: it is an event, and under the
// recorded truth it may be left out, which is counted.
TEST(Rules, FlipsBeforeTheHorizonLeftOut) {
  judge_at_the_horizon(1e-7, true, &Certificate::left_out);
}

// Rule 3.15: two edges far from each other flip one shortly after the other, both within the
// tolerance of the horizon. From a flip that is left out on the claimed diagram is another than the
// true one, so that a later flip is not proved.
TEST(Rules, NoFlipAfterOneThatIsLeftOut) {
  std::vector<DiskInput> disks;
  for (const auto& [x, y] : {std::pair(-20.0, -4.0), std::pair(20.5, -3.9999999)}) {
    for (const DiskInput& d : {disk(x, 5, 1, 0, 0, 1), disk(x + 5, 0, 1, 0, 0, 1),
                               disk(x - 5, 0, 1, 0, 0, 1), disk(x, y, 1, 0, -1, 1)}) {
      disks.push_back(d);
    }
  }
  const Scene scene = scene_of(50, 1.0000005, disks);
  const ClaimedHistory whole = claimed_history(scene, run(scene));
  const std::size_t n = whole.events.size();
  ASSERT_GE(n, 2u);
  ASSERT_GT(time(whole.events[n - 2]), 0.99999999);
  // Of the last two flips, which are claimed.
  for (const auto& [first, second] : {std::pair(true, true), std::pair(true, false),
                                      std::pair(false, false), std::pair(false, true)}) {
    ClaimedHistory h = whole;
    if (!second) h.events.pop_back();
    if (!first) h.events.erase(h.events.begin() + static_cast<std::ptrdiff_t>(n) - 2);
    h.count();
    const Certificate c = judged(scene, h, Truth::recorded);
    EXPECT_EQ(c.verdict, second && !first ? Verdict::undecided : Verdict::certified)
        << told(scene, h, c);
    EXPECT_EQ(c.left_out, (first ? 0 : 1) + (second ? 0 : 1));
  }
}

// Rule 3.4: a disk is hit from both sides, one after the other, within the tolerance. Whoever
// reads the lines in another order takes another velocity for its last one.
TEST(Rules, TurnsOfOneDiskAreNotExchanged) {
  const Scene scene = scene_of(
      20, 2, {disk(-3, 0, 1, 1, 0, 1), disk(0, 0, 1, 0, 0, 1), disk(3 + 2e-7, 0, 1, -1, 0, 1)});
  ClaimedHistory h = claimed_history(scene, run(scene));
  std::size_t first = 0;
  while (!std::holds_alternative<CollideEvent>(h.events.at(first))) ++first;
  auto& a = std::get<CollideEvent>(h.events[first]);
  auto& b = std::get<CollideEvent>(h.events[first + 1]);
  ASSERT_EQ(std::pair(a.i, a.j), std::pair(0, 1));
  ASSERT_EQ(std::pair(b.i, b.j), std::pair(1, 2));
  ASSERT_LT(b.t, a.t + 1e-6);
  EXPECT_EQ(judged(scene, h, Truth::exact).verdict, Verdict::certified);
  std::swap(a.t, b.t);
  std::swap(h.events[first], h.events[first + 1]);
  const Certificate c = judged(scene, h, Truth::exact);
  ASSERT_EQ(c.verdict, Verdict::refuted) << told(scene, h, c);
  EXPECT_EQ(c.divergence->fault, Fault::wrong_order);
}

// Rule 2.8: those that collide are neighbours. The outer two of three in a row are not.
TEST(Rules, WhoIsNoNeighbourDoesNotCollide) {
  const Scene scene =
      scene_of(20, 1, {disk(-8, 0, 3, 1, 0, 1), disk(0, 0, 3, 0, 0, 1), disk(8, 0, 3, -1, 0, 1)});
  ClaimedHistory h = claimed_history(scene, run(scene));
  CollideEvent claim{.t = 0.5, .i = 0, .j = 2};
  claim.v = {Vec2{-1, 0}, Vec2{1, 0}};
  h.events.insert(h.events.begin(), claim);
  h.count();
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    const Certificate c = judged(scene, h, truth);
    ASSERT_EQ(c.verdict, Verdict::refuted) << told(scene, h, c);
    EXPECT_EQ(c.divergence->fault, Fault::wrong_pair);
  }
}

// Rule 2.2: lives begin when all has turned that turns at an instant. A point hits a disk without
// restitution and would rest on it, but for a maneuver at that instant, by which it leaves.
TEST(Rules, NothingIsJudgedBetweenTwoTurnsOfAnInstant) {
  Scene scene = scene_of(30, 4, {disk(5, 0, 0, -1, 0, 1), disk(0, 0, 3, 0, 0, 1)});
  scene.restitution = 0;
  scene.maneuvers = {{2, 0, 1, 0}};
  expect_certified(scene, claimed_history(scene, run(scene)));
  scene.maneuvers = {{2, 0, Rational(-1, 2), 0}};
  const ClaimedHistory rests =
      history_of(scene, kTwo,
                 {collision(2, 0, 1, Vec2{-0.5, 0}, {-0.5, 0}), ManeuverEvent{.t = 2, .disk = 0}});
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    expect(Verdict::undecided, scene, rests, truth);
  }
}

// Rule 5.9: a turn at the very instant of a collapse, which the life before does not prove to be
// none. After it the edge has to flip.
TEST(Rules, AnEdgeThatCollapsesAtATurnFlips) {
  Scene scene = scene_of(10, Rational(5, 4),
                         {disk(Rational(-1, 2), Rational(1, 4), Rational(1, 8), 0, 0),
                          disk(Rational(3, 2), Rational(1, 4), Rational(1, 8), 0, 0),
                          disk(Rational(1, 2), Rational(-3, 4), Rational(1, 8), 0, 0),
                          disk(Rational(1, 2), Rational(9, 4), Rational(1, 8), 0, -1)});
  scene.maneuvers = {{1, 3, 0, Rational(-1, 2)}};
  const ClaimedHistory whole = claimed_history(scene, run(scene));
  expect_certified(scene, whole);
  ClaimedHistory h = whole;
  std::erase_if(h.events, [](const auto& e) { return std::holds_alternative<FlipEvent>(e); });
  ASSERT_EQ(h.events.size() + 1, whole.events.size());
  h.count();
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    const Certificate c = judged(scene, h, truth);
    ASSERT_EQ(c.verdict, Verdict::refuted) << told(scene, h, c);
    EXPECT_EQ(c.divergence->fault, Fault::missing_event);
  }
}

// Rule 3.16: a point enters a disk, is claimed to have hit it while it is inside, and leaves it on
// the side from which it came. Meanwhile a maneuver drives a third disk there. The point has
// another neighbour then, by no flip: with the third disk where it was the diagram is right, but it
// is not there any more.
TEST(Rules, NothingHappensWhileAPointMayBeHidden) {
  for (const bool meanwhile : {false, true}) {
    Scene scene = scene_of(
        10, 1, {disk(0, 0, 1, 0, 0, 1e12), disk(-1.05, 0, 0, 2, 0, 1), disk(3, 7, 0.5, 0, 0, 1)});
    const RecordedRun before = run(scene);
    CollideEvent hit = collision(0.3, 0, 1, {}, {});
    hit.v = {};
    ClaimedHistory h = history_of(scene, before.initial, {hit});
    if (meanwhile) {
      scene.maneuvers = {{Rational(0.375), 2, -40, -40}, {Rational(0.59375), 2, 0, 0}};
      h.events.emplace_back(ManeuverEvent{.t = 0.375, .disk = 2});
      h.events.emplace_back(ManeuverEvent{.t = 0.59375, .disk = 2});
      h.count();
    }
    CertifyOptions options;
    options.tolerance = Rational(3, 10);
    expect(meanwhile ? Verdict::undecided : Verdict::certified, scene, h, Truth::recorded, options);
  }
}

// Two disks that pass each other closely, and a small one that is or comes between them, so that
// the two share two edges. `smaller`: all disks, and the container larger, which leaves the diagram
// as it is.
Scene narrow_pass(double nearest, double y, const Rational& smaller, const DiskInput& small) {
  return scene_of(50 + smaller, Rational(13, 10),
                  {disk(-1, 0, 1 - smaller, 0, 0), disk(nearest - 1, y, 1 - smaller, 0, 1), small});
}

// Rule 5.13: the two have overlapped before the second edge comes. What is known of the pair since
// then does not tell.
TEST(Rules, TheOldestEdgeOfAPairStandsForIt) {
  const auto scene = [](const Rational& smaller) {
    return narrow_pass(1.99, -1, smaller, disk(0.1, -6, Rational(1, 20) - smaller, 0, 4.25));
  };
  const Scene small = scene(Rational(1, 50)), large = scene(0);
  const ClaimedHistory right = claimed_history(small, run(small));
  EXPECT_TRUE(std::any_of(right.events.begin(), right.events.end(), [](const auto& event) {
    const auto* f = std::get_if<FlipEvent>(&event);
    return f != nullptr && std::minmax({f->quad.s, f->quad.e}) == std::pair(0, 1);
  }));
  expect_certified(small, right);
  expect_refuted(large, right);
}

// Rule 5.13: an overlap by a rounding is one, along how many edges the two may be neighbours.
TEST(Rules, AnOverlapIsCountedOnce) {
  Scene scene = narrow_pass(2 - 0x1p-48, -0.125, 0, disk(0.01, -0.75, 0.05, 0, 0));
  scene.horizon = Rational(1, 4);
  const ClaimedHistory h = history_of(scene, run(scene).initial, {});
  const auto& initial = *h.header.initial;
  EXPECT_EQ(std::count_if(initial.begin(), initial.end(),
                          [](const Quad& q) { return q.l == 0 && q.r == 1; }),
            2);
  const Certificate c = judged(scene, h, Truth::recorded);
  EXPECT_EQ(c.verdict, Verdict::certified) << told(scene, h, c);
  EXPECT_EQ(c.rounding_overlaps, 1);
}

}  // namespace
}  // namespace voroproof::internal::testing
