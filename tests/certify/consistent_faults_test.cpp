// Histories that err once and go on consistently in their own world: small ones, made by hand, each
// wrong at one rule of docs/claim.md and right everywhere else, with neighbours that are right.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "certify/report.h"
#include "tests/certify/claimed_history.h"

namespace voroproof::internal::testing {
namespace {

using History = ClaimedHistory;

// Two disks have one diagram, which never flips.
const std::vector<Quad> kTwo{{-1, 0, 1, 1}, {-1, 1, 0, 0}, {0, 1, -1, -1}};

History history_of(const Scene& scene, const std::vector<Quad>& initial,
                   std::vector<voroproof::internal::Event> events) {
  History h;
  h.header.horizon = scene.horizon;
  h.header.initial = initial;
  h.events = std::move(events);
  h.count();
  return h;
}

CollideEvent collision(double t, GenId i, GenId j, std::optional<Vec2> v_i, Vec2 v_j) {
  return {.t = t, .i = i, .j = j, .v = {v_i, v_j}};
}

void expect(Verdict verdict, const Scene& scene, const History& h, Truth truth,
            CertifyOptions options = {}) {
  options.truth = truth;
  const Certificate c = certify(scene, h, options);
  EXPECT_EQ(c.verdict, verdict) << (truth == Truth::exact ? "exact" : "recorded") << ": "
                                << reason_line(c) << "\n"
                                << text(scene) << text(h);
}

void expect_refuted(const Scene& scene, const History& h) {
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    for (const bool strict : {false, true}) {
      CertifyOptions options;
      options.strict = strict;
      expect(Verdict::refuted, scene, h, truth, options);
    }
  }
}

void expect_certified(const Scene& scene, const History& h) {
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    expect(Verdict::certified, scene, h, truth);
  }
}

// Two that touch and approach at 0, head-on and aslant, and pass through each other.
TEST(ConsistentFaults, TouchingAtStartAndPassingThrough) {
  for (const double vy : {0.0, 0.5}) {
    const Scene scene = scene_of(50, 10, {disk(-1, 0, 1, 1, vy), disk(1, 0, 1, -1, 0)});
    expect_refuted(scene, history_of(scene, kTwo, {}));
    const History right = claimed_history(scene, run(scene));
    expect_certified(scene, right);
    // Claimed late, within the tolerance and beyond it.
    for (const double late : {9e-7, 2e-6}) {
      History h = right;
      std::get<CollideEvent>(h.events.front()).t = late;
      std::get<CollideEvent>(h.events.front()).p = {};
      expect(late < 1e-6 ? Verdict::certified : Verdict::refuted, scene, h, Truth::exact);
    }
  }
}

// The same from a maneuver on, and with a third disk that goes on meanwhile.
TEST(ConsistentFaults, TouchingFromAManeuverOn) {
  Scene scene = scene_of(50, 4, {disk(-1, 0, 1, 0, 0), disk(1, 0, 1, 0, 0)});
  scene.maneuvers.push_back({2, 0, 1, 0});
  const ManeuverEvent turn{2, 0, Vec2{1, 0}, Vec2{-1, 0}, {}};
  expect_refuted(scene, history_of(scene, kTwo, {turn}));
  expect_certified(scene, claimed_history(scene, run(scene)));
}

// Of disks smaller than their way in the tolerance, two that pass through each other.
TEST(ConsistentFaults, TinyDisksPassThroughEachOther) {
  for (const auto& [radius, speed] : {std::pair(1e-7, 1.0), {4e-7, 1.0}, {0.1, 1e7}, {1e-3, 1e5}}) {
    const double start = 0.25 * speed;
    const Scene scene =
        scene_of(Rational(100 * speed), 1,
                 {disk(-start, 0, radius, speed, 0), disk(start, 0, radius, -speed, 0)});
    expect_refuted(scene, history_of(scene, kTwo, {}));
    expect_certified(scene, claimed_history(scene, run(scene)));
  }
}

// Two that pass through each other sideways, on the lines that they are on from 0 to the end, and
// are neighbours no more when the history ends: the flip that parts them has to tell. Of equal
// radii the diagram depends on R + r alone, so that a history of smaller disks is that of these.
TEST(ConsistentFaults, PassingThroughAndPartedByAFlip) {
  const auto scene = [](const Rational& radius) {
    return scene_of(51 - radius, 25,
                    {disk(-10, 1.875, radius, 1, 0), disk(0, 0, radius, 0, 0),
                     disk(8, 6, radius, 0, 0), disk(8, -5, radius, 0, 0)});
  };
  const Scene small = scene(Rational(1, 2)), large = scene(1);
  const History right = claimed_history(small, run(small));
  expect_certified(small, right);
  EXPECT_TRUE(std::any_of(right.events.begin(), right.events.end(), [](const auto& event) {
    const auto* f = std::get_if<FlipEvent>(&event);
    return f != nullptr && std::min(f->quad.l, f->quad.r) == 0 &&
           std::max(f->quad.l, f->quad.r) == 1;
  }));
  expect_refuted(large, right);
}

// Disks smaller than the rounding, that lose nearly all of their speed: claimed late within the
// tolerance they stay in each other for long after it, which no rounding excuses.
TEST(ConsistentFaults, TinyDisksThatStayInEachOther) {
  for (const auto& [restitution, late] :
       {std::pair(Rational(1), 5e-7), {Rational(1, 1000), 0.0}, {Rational(1, 1000), 5e-7}}) {
    Scene scene =
        scene_of(100, 1, {disk(-3e-15, 0, 1e-15, 5e-11, 0), disk(3e-15, 0, 1e-15, -5e-11, 0)});
    scene.restitution = restitution;
    const double v = 5e-11 * restitution.get_d();
    const History h =
        history_of(scene, kTwo, {collision(4e-5 + late, 0, 1, Vec2{-v, 0}, Vec2{v, 0})});
    const bool stay = restitution < 1 && late > 0;
    expect(stay ? Verdict::refuted : Verdict::certified, scene, h, Truth::recorded);
  }
}

// A disk that passes through another, turns, and comes back, all within the tolerance: a collision
// claimed a little before it is back answers that entry, and not the first one.
TEST(ConsistentFaults, PassedThroughBeforeTheNextEntry) {
  const double v = 1e5, t = 1 + 1e-7;
  for (const bool through : {true, false}) {
    const Rational way = Rational(v) * Rational(t), near(1, 125);
    Scene scene = scene_of(1'000'000, Rational(3, 2),
                           {through ? disk(near - way, 0, Rational(1, 1000), v, 0)
                                    : disk(near, -way, Rational(1, 1000), 0, v),
                            disk(0, 0, Rational(1, 1000), 0, 0)});
    scene.maneuvers.push_back({Rational(t), 0, Rational(-v), 0});
    const ManeuverEvent turn{t, 0, Vec2{-v, 0}, {}, {}};
    const History h =
        history_of(scene, kTwo, {turn, collision(t + 5e-8, 0, 1, Vec2{0, 0}, Vec2{-v, 0})});
    expect(through ? Verdict::refuted : Verdict::certified, scene, h, Truth::recorded);
  }
}

// A collision that never happens: disks that pass each other closely; claimed when they are
// nearest, before and after. The velocities obey the law.
TEST(ConsistentFaults, NearMissTakenForAHit) {
  for (const double gap : {1e-5, 1e-7, 1e-9}) {
    for (const double when : {0.0, -1e-6, 1e-6, -1e-4}) {
      const double speed = 1000;
      const Scene scene =
          scene_of(2000, 1, {disk(0, 0, 1, 0, 0), disk(-250, 2 + gap, 1, speed, 0)});
      const double t = 0.25 + when;
      const double x = -250 + speed * t, y = 2 + gap, n2 = x * x + y * y;
      const double q = speed * x / n2;  // (w.n) / n.n, equal masses
      const CollideEvent hit = collision(t, 0, 1, Vec2{q * x, q * y}, Vec2{speed - q * x, -q * y});
      History h = history_of(scene, kTwo, {hit});
      expect(Verdict::refuted, scene, h, Truth::recorded);
      expect(Verdict::refuted, scene, h, Truth::exact);
      h = history_of(scene, kTwo, {});
      expect_certified(scene, h);
    }
  }
}

// Two that touch without overlapping: a collision when they do is right and counted as a graze, at
// another time it is wrong, though it obeys the law.
TEST(ConsistentFaults, GrazeClaimedAtAnotherTime) {
  const Scene scene = scene_of(50, 8, {disk(0, 0, 1, 0, 0), disk(-4, 2, 1, 1, 0)});
  for (const double when : {0.0, -0x1p-21, 0x1p-21, -0x1p-10}) {
    const double q = when / (when * when + 4);  // (w.n) / n.n, equal masses
    const CollideEvent hit =
        collision(4 + when, 0, 1, Vec2{q * when, 2 * q}, Vec2{1 - q * when, -2 * q});
    const History h = history_of(scene, kTwo, {hit});
    const bool right = std::fabs(when) < 1e-6;
    expect(right ? Verdict::certified : Verdict::refuted, scene, h, Truth::recorded);
    CertifyOptions options;
    options.truth = Truth::recorded;
    EXPECT_EQ(certify(scene, h, options).grazes, right ? 1 : 0);
  }
}

// Two that come into each other so slowly that the overlap stays a rounding: a collision answers it
// within the tolerance of its beginning only.
TEST(ConsistentFaults, ClaimedLongAfterAShallowEntry) {
  const double e = 0x1p-46;
  const Scene scene = scene_of(50, 3, {disk(-1 - e, 0, 1, e, 0), disk(1 + e, 0, 1, -e, 0)});
  for (const double late : {0.0, 5e-7, 2e-6, 0.25}) {
    const History h = history_of(scene, kTwo, {collision(1 + late, 0, 1, Vec2{-e, 0}, Vec2{e, 0})});
    expect(late < 1e-6 ? Verdict::certified : Verdict::refuted, scene, h, Truth::recorded);
  }
}

// A collision after the horizon.
TEST(ConsistentFaults, CollisionAfterTheHorizon) {
  const Scene scene = scene_of(50, 2, {disk(-3, 0, 1, 1, 0), disk(3.0000000002, 0, 1, -1, 0)});
  const CollideEvent hit = collision(2, 0, 1, Vec2{-1, 0}, Vec2{1, 0});
  const History with = history_of(scene, kTwo, {hit}), without = history_of(scene, kTwo, {});
  expect(Verdict::refuted, scene, with, Truth::exact);
  expect(Verdict::certified, scene, without, Truth::exact);
  // The recorded truth may have it or not, and says so.
  for (const History& h : {with, without}) expect(Verdict::certified, scene, h, Truth::recorded);
  CertifyOptions options;
  options.truth = Truth::recorded;
  EXPECT_EQ(certify(scene, with, options).at_horizon, 1);
}

// A collision line twice: without restitution the second changes nothing; of tiny disks it is near.
TEST(ConsistentFaults, CollisionLineTwice) {
  for (const double radius : {1.0, 1e-7}) {
    for (const int restitution : {0, 1}) {
      Scene scene = scene_of(50, 10, {disk(-3, 0, radius, 1, 0, 1), disk(3, 0, radius, -1, 0, 1)});
      scene.restitution = restitution;
      History h = claimed_history(scene, run(scene));
      ASSERT_FALSE(h.events.empty());
      expect_certified(scene, h);
      const auto first = std::get<CollideEvent>(h.events.front());
      for (const double later : {0.0, 5e-7}) {
        History twice = h;
        CollideEvent again = first;
        again.t += later;
        again.p = {};
        twice.events.insert(twice.events.begin() + 1, again);
        twice.count();
        expect_refuted(scene, twice);
      }
    }
  }
}

// Velocities that are not those of the collision, where another disk is fast for a moment: no
// stranger widens the bound.
TEST(ConsistentFaults, WrongVelocitiesBesideAFastStranger) {
  Scene scene =
      scene_of(1000, 10, {disk(-3, 0, 1, 1, 0), disk(3, 0, 1, -1, 0), disk(500, 500, 1, 0, 0)});
  scene.maneuvers.push_back({1, 2, Rational(-100000), 0});
  scene.maneuvers.push_back({Rational(1) + Rational(1, 1000), 2, 0, 0});
  const History right = claimed_history(scene, run(scene));
  expect_certified(scene, right);
  History wrong = right;
  for (auto& event : wrong.events) {
    auto* hit = std::get_if<CollideEvent>(&event);
    if (hit == nullptr) continue;
    hit->p = {};
    hit->v = {Vec2{-1, 0.01}, Vec2{1, 0.01}};
    break;
  }
  expect_refuted(scene, wrong);
}

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

// A history that sets its own horizon is certified up to that, and says so; not with --strict.
TEST(ConsistentFaults, AnotherHorizon) {
  const Scene scene = scene_of(50, 10, {disk(-3, 0, 1, 1, 0), disk(3, 0, 1, -1, 0)});
  History h = history_of(scene, kTwo, {});
  h.header.horizon = 1;
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    CertifyOptions options;
    options.truth = truth;
    const Certificate c = certify(scene, h, options);
    EXPECT_EQ(c.verdict, Verdict::certified);
    EXPECT_EQ(horizon_line(c), "horizon 1 of the scene's 10");
    options.strict = true;
    EXPECT_EQ(certify(scene, h, options).verdict, Verdict::refuted);
  }
}

// A point hits a disk and the wall, by rounding a little inside and outside: right, and what
// depends on the tangency is proved anew.
TEST(ConsistentFaults, PointsHitByARounding) {
  int anew = 0;
  for (int k = 0; k < 20; ++k) {
    const Scene scene = scene_of(
        10, 40,
        {disk(-3.1 + 0.01 * k, 0.3, 0, 1, 0.11 + 0.01 * k, 1), disk(3, 0.1 * k, 1, -1, 0.2),
         disk(0.3, -4, 0, 0.3, -0.7, 2), disk(1, 5, 1.5, 0.1, 0.3)});
    const History right = claimed_history(scene, run(scene));
    expect_certified(scene, right);
    CertifyOptions options;
    options.truth = Truth::recorded;
    anew += static_cast<int>(certify(scene, right, options).proved_anew);
  }
  EXPECT_GT(anew, 0);
}

// A point hits a disk, head-on and without restitution, and goes on with it: its cell has no area.
// A flip around it in that time is seen by nobody, and with it the diagram is wrong once the point
// leaves. Nobody certifies that, and the engine stops where the point begins to rest. With
// restitution the point leaves at once, and all is decided.
TEST(ConsistentFaults, APointThatRestsOnADisk) {
  Scene scene = scene_of(30, 34,
                         {disk(5, 0, 0, -1, 0, 1), disk(0, 0, 3, 0, 0), disk(14, -12, 1, 0, 1),
                          disk(-9, 12, 2, 0, 0)});
  scene.maneuvers = {{30, 0, 1, 0}};
  const std::vector<Quad> initial{{-1, 0, 1, 2}, {-1, 1, 2, 3}, {-1, 1, 3, 0},
                                  {-1, 2, 0, 1}, {-1, 3, 1, 1}, {0, 1, -1, 2},
                                  {0, 2, 1, -1}, {1, 2, -1, 0}, {1, 3, -1, -1}};
  scene.restitution = 0;
  CollideEvent hit = collision(2, 0, 1, Vec2{-0.1, 0}, {-0.1, 0});
  hit.p = {Vec2{3, 0}, Vec2{0, 0}};
  const History resting =
      history_of(scene, initial,
                 {FlipEvent{1.8709714839465492, {-1, 0, 1, 2}}, hit,
                  FlipEvent{14.169258536887346, {-1, 1, 3, 2}}, ManeuverEvent{.t = 30, .disk = 0},
                  FlipEvent{30.024300022225376, {1, 2, -1, 0}}});
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    expect(Verdict::undecided, scene, resting, truth);
  }
  const RecordedRun stopped = run(scene);
  EXPECT_EQ(stopped.outcome.kind, Outcome::Kind::stopped);
  EXPECT_NE(stopped.outcome.reason.find("point 0 may rest"), std::string::npos);
  scene.restitution = Rational(1, 2);
  const RecordedRun leaving = run(scene);
  EXPECT_EQ(leaving.outcome.kind, Outcome::Kind::complete);
  expect_certified(scene, claimed_history(scene, leaving));
}

// The same by a maneuver at the instant of an elastic collision, with the velocity that the disk
// has after it, and with nearly that.
TEST(ConsistentFaults, AManeuverMakesAPointRest) {
  for (const bool rests : {true, false}) {
    Scene scene = scene_of(30, 4, {disk(5, 0, 0, -1, 0, 1), disk(0, 0, 3, 0, 0, 7)});
    scene.maneuvers = {{2, 0, rests ? Rational(-1, 4) : Rational(-1, 8), 0}};
    const RecordedRun made = run(scene);
    EXPECT_EQ(made.outcome.kind, rests ? Outcome::Kind::stopped : Outcome::Kind::complete);
    const History h = history_of(
        scene, kTwo,
        {collision(2, 0, 1, Vec2{0.75, 0}, {-0.25, 0}), ManeuverEvent{.t = 2, .disk = 0}});
    for (const Truth truth : {Truth::exact, Truth::recorded}) {
      expect(rests ? Verdict::undecided : Verdict::certified, scene, h, truth);
    }
  }
}

// A point between two disks that meet there: it touches both at one instant.
TEST(ConsistentFaults, APointBetweenTwo) {
  const Scene scene =
      scene_of(30, 4, {disk(-3, 0, 1, 1, 0, 1), disk(3, 0, 1, -1, 0, 1), disk(0, 0, 0, 0, 0, 1)});
  const RecordedRun made = run(scene);
  EXPECT_EQ(made.outcome.kind, Outcome::Kind::stopped);
  EXPECT_NE(made.outcome.reason.find("two generators"), std::string::npos) << made.outcome.reason;
}

// A fast point enters a disk, is claimed to have hit it while it is inside, and leaves it
// elsewhere. With the third disk on the right the point comes from between the two and leaves
// towards the wall: its neighbours have changed while it had no cell, by no flip, and the diagram
// is wrong from then on. No in-circle function of it vanishes before the horizon: only the proof
// anew tells. With the third disk below the point has the same neighbours before and after.
TEST(ConsistentFaults, OtherNeighboursAfterAHiddenMoment) {
  for (const bool right : {true, false}) {
    const DiskInput third = right ? disk(5, 0, 1, 0, 0, 1) : disk(0, -8, 0.5, 0, 0, 1);
    const Scene scene =
        scene_of(10, Rational(4e-6),
                 {disk(0, 0, 1, 0, 0, 1e12), disk(1.81, 0.29, 0, -1087500, 65000, 1), third});
    History h = history_of(scene, run(scene).initial, {collision(1.6e-6, 0, 1, {}, {})});
    std::get<CollideEvent>(h.events.front()).v = {};
    expect(right ? Verdict::undecided : Verdict::certified, scene, h, Truth::recorded);
  }
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
