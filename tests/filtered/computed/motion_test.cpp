// The states of the disks at every precision against the exact ones, through collisions and
// maneuvers.
#include "filtered/computed/computed_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/static_diagram.h"
#include "filtered/search/contact.h"
#include "library/maneuver_input.h"
#include "tests/support/compact_arithmetic.h"
#include "tests/support/random_scenes.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {
namespace {

bool within(const Tower& x, const Rational& center, double radius) {
  const Rational r = to_rational(radius);
  return x >= Tower(Rational(center - r)) && x <= Tower(Rational(center + r));
}
bool contains(const DoubleBall& b, const Tower& x) { return within(x, to_rational(b.mid), b.rad); }
bool contains(const DdBall& b, const Tower& x) {
  return within(x, to_rational(b.hi) + to_rational(b.lo), b.rad);
}
bool contains(const Ball& b, const Tower& x) {
  double lo = 0, hi = 0;
  b.to_interval(lo, hi);
  return x >= Tower(to_rational(lo)) && x <= Tower(to_rational(hi));
}

template <class B>
void expect_contains(const MovingSite<B>& s, const MovingSite<Tower>& truth) {
  EXPECT_TRUE(contains(s.x, truth.x));
  EXPECT_TRUE(contains(s.y, truth.y));
  EXPECT_TRUE(contains(s.vx, truth.vx));
  EXPECT_TRUE(contains(s.vy, truth.vy));
  EXPECT_TRUE(contains(s.r, truth.r));
}

// All generators at the reference time of their states and at another time.
void expect_enclosed(const Motion& motion) {
  ExactMotion exact(motion);
  for (GenId g = container_id; g < motion.size(); ++g) {
    const DoubleMotion& m = motion.doubles(g);
    EXPECT_EQ(to_rational(m.t), exact.state(g).t_ref);
    const auto truth = exact.moving_site(g, to_rational(m.t));
    expect_contains(
        MovingSite<DoubleBall>{{m.x, m.ex}, {m.y, m.ex}, {m.vx, m.ev}, {m.vy, m.ev}, {m.r, m.ex}},
        truth);
    EXPECT_LE(m.ex, 1e-13);
    for (const double t : {m.t + 0.7, m.t - 0.3}) {
      const auto at = exact.moving_site(g, to_rational(t));
      expect_contains(motion.moving_site(g, DoubleBall(t)), at);
      expect_contains(motion.moving_site(g, DdBall(t)), at);
      expect_contains(motion.moving_site(g, Ball(t, 200)), at);
      EXPECT_LE(motion.site(g, DdBall(t)).x.rad, 1e-26);  // of some use, too
    }
  }
}

// Rounded outputs of an impact against the exact states.
void expect_rounded(const Motion& motion, const Impact& impact, GenId i, GenId j) {
  ExactMotion exact(motion);
  const Tower time = exact.start(motion.state_id(j), j);
  EXPECT_EQ(impact.t, round_nearest(time));
  EXPECT_TRUE(contains(impact.time, time));
  EXPECT_TRUE(contains(impact.time_dd, time));
  for (const GenId g : {i, j}) {
    if (g == container_id) continue;
    const RoundedState& s = g == i ? impact.first : impact.second;
    const Site<Tower> at = exact.site(g, time);
    const auto& origin = motion.input().origin;
    EXPECT_EQ(s.px, round_nearest(at.x + Tower(origin[0])));
    EXPECT_EQ(s.py, round_nearest(at.y + Tower(origin[1])));
    EXPECT_EQ(s.vx, round_nearest(exact.state(g).vx));
    EXPECT_EQ(s.vy, round_nearest(exact.state(g).vy));
  }
}

struct Contact2 {
  NextContact when;
  GenId i, j;
};

// The first contact of all pairs after `now`.
Contact2 first_contact(Motion& motion, const Moment& now) {
  TierCounts unused;
  ContactSearch search(motion, unused);
  Contact2 first{{NextContact::Kind::none, 1e300, 1e300}, 0, 0};
  for (GenId i = container_id; i < motion.size(); ++i) {
    for (GenId j = std::max(i + 1, 0); j < motion.size(); ++j) {
      const NextContact c = search.from(i, j, now, 1e3);
      if (c.kind == NextContact::Kind::at && c.lo < first.when.lo) first = {c, i, j};
    }
  }
  return first;
}

// Runs `count` collisions; returns what is written of each.
std::vector<Impact> collide(ComputedMotion& motion, int count, bool check) {
  std::vector<Impact> impacts;
  Moment now = Moment::at(0);
  for (int k = 0; k < count; ++k) {
    const Contact2 c = first_contact(motion, now);
    if (c.when.kind != NextContact::Kind::at) break;
    const Impact impact = motion.collide(c.i, c.j, c.when.lo);
    impacts.push_back(impact);
    if (check) {
      expect_rounded(motion, impact, c.i, c.j);
      expect_enclosed(motion);
    }
    now.lo = std::nextafter(impact.t, 0);
    now.hi = std::nextafter(impact.t, 1e300);
    now.dd = impact.time_dd;
    now.collided(c.i, c.j, motion.state_id(c.j));
  }
  return impacts;
}

Scene thirds(Scene scene) {
  for (DiskInput& d : scene.disks) {
    d.x += Rational(1, 3000000);
    d.radius -= Rational(1, 3000000);
    d.vy += Rational(1, 7);
  }
  return scene;
}

TEST(Motion, InitialStates) {
  Random random(1);
  for (int k = 0; k < 10; ++k) {
    Scene scene = random_scene({.n = 6}, random);
    expect_enclosed(ComputedMotion(motion_input(scene), {}));
    expect_enclosed(ComputedMotion(motion_input(thirds(scene)), {}));
    // What a double holds has no error.
    scene.cx = scene.cy = 0;
    EXPECT_EQ(ComputedMotion(motion_input(scene), {}).doubles(0).ex, 0);
  }
}

TEST(Motion, CollisionsOfEveryLaw) {
  Random random(2);
  for (int k = 0; k < 12; ++k) {
    Scene scene = random_scene({.n = 4, .rmin = 10, .rmax = 20}, random);
    if (k % 2 == 0) scene = thirds(scene);
    if (k % 3 != 0) scene.restitution = Rational(2, 3);
    if (k % 3 != 0) scene.container_restitution = Rational(1, 3);
    if (k % 3 == 2) scene.law = ContainerLaw::whole;
    ComputedMotion motion(motion_input(scene), {});
    EXPECT_EQ(collide(motion, 3, true).size(), 3u);
  }
}

// A collision of tiny disks loses bits that the supply per time does not replace so late.
TEST(Motion, ACollisionJustBeforeTheHorizon) {
  Scene scene;
  scene.container_radius = 32;
  const auto number = [](const char* text) { return *parse_rational(text); };
  const auto add = [&](const char* x, const char* y, double r, double vx, double vy) {
    DiskInput d;
    d.x = number(x);
    d.y = number(y);
    d.radius = to_rational(r);
    d.vx = to_rational(vx);
    d.vy = to_rational(vy);
    d.mass = d.radius * d.radius;
    scene.disks.push_back(d);
  };
  add("-131709752686286198280195/9133444159495441743872",
      "-8153460880579621814225/285420129984232554496", 1.1709383462843448e-17, 0.125, 1.125);
  add("-16463719085785774786335/1141680519936930217984",
      "-32613843522318487230571/1141680519936930217984", 1.0408340855860843e-17, 0.5, -0.71875);
  for (const double later : {1.0, 1.001, 2.0}) {
    scene.horizon = to_rational(5.230558031948902e-19 * later);  // an ulp after the collision
    const RecordedRun r = run(scene);
    EXPECT_TRUE(r.complete()) << r.outcome.reason;
    EXPECT_EQ(r.count(Event::Kind::collision), 1u);
  }
}

// What is written does not depend on the precision that was used inside.
TEST(Motion, OutputsDoNotDependOnThePrecision) {
  Random random(3);
  for (int k = 0; k < 5; ++k) {
    const Scene scene = thirds(random_scene({.n = 5, .rmin = 10, .rmax = 20}, random));
    MotionOptions generous;
    generous.start_bits = 2000;
    ComputedMotion few(motion_input(scene), {}), many(motion_input(scene), generous);
    const auto a = collide(few, 8, false), b = collide(many, 8, false);
    ASSERT_EQ(a.size(), 8u);
    ASSERT_EQ(b.size(), 8u);
    for (std::size_t n = 0; n < 8; ++n) {
      EXPECT_EQ(a[n].t, b[n].t);
      EXPECT_EQ(a[n].second.px, b[n].second.px);
      EXPECT_EQ(a[n].second.vy, b[n].second.vy);
    }
  }
}

TEST(Motion, RaisingThePrecisionKeepsTheStates) {
  Random random(4);
  MotionOptions options;
  options.max_bits = 1024;
  ComputedMotion motion(
      motion_input(thirds(random_scene({.n = 3, .rmin = 15, .rmax = 20}, random))), options);
  collide(motion, 2, false);
  motion.maneuver(0, Rational(1000, 3), Rational(1, 3), 0);
  std::vector<DoubleMotion> before;
  for (GenId g = 0; g < 3; ++g) before.push_back(motion.doubles(g));
  int raised = 0;
  for (int goal = motion.goal_bits(); motion.raise_precision(); goal = motion.goal_bits()) {
    ++raised;
    EXPECT_GT(motion.goal_bits(), goal);
    EXPECT_EQ(motion.replays(), static_cast<std::uint64_t>(raised));
    for (GenId g = 0; g < 3; ++g) {
      EXPECT_EQ(motion.doubles(g).t, before[g].t);
      EXPECT_EQ(motion.doubles(g).x, before[g].x);
      EXPECT_EQ(motion.doubles(g).vy, before[g].vy);
    }
  }
  EXPECT_GT(raised, 1);
  EXPECT_LE(motion.highest_bits(), 1024);
}

// The width of the enclosure of a disk's x, of all disks the most.
Rational widest(const Motion& motion, Ball::Precision bits) {
  Rational most = 0;
  for (GenId g = 0; g < motion.size(); ++g) {
    const auto [lo, hi] =
        motion.moving_site(g, Ball(motion.doubles(g).t, bits)).x.rational_interval();
    most = std::max(most, Rational(hi - lo));
  }
  return most;
}

// Whoever follows a snapshot that lasts has the bits that its owner needed later.
TEST(Motion, SnapshotsThatLastAreAsAccurateAsTheirOwner) {
  Random random(5);
  const Scene scene = thirds(random_scene({.n = 4, .rmin = 10, .rmax = 20}, random));
  ComputedMotion motion(motion_input(scene), {});
  std::vector<MotionSnapshot> then;
  std::vector<std::shared_ptr<MotionStates::LastingSnapshot>> lasting;
  collide(motion, 3, false);
  for (int k = 0; k < 3; ++k) {
    motion.maneuver(k, Rational(1000 + k, 3), Rational(1, 3), k);
    then.push_back(motion.snapshot());
    lasting.push_back(motion.lasting_states());
  }
  lasting[1].reset();
  const int goal = motion.goal_bits();
  ASSERT_TRUE(motion.raise_precision());
  for (const std::size_t k : {std::size_t{0}, std::size_t{2}}) {
    for (const bool lasts : {false, true}) {
      ComputedMotion follower(motion.input(), motion.options(), motion.log());
      MotionSnapshot start = then[k];
      if (lasts) start.full = lasting[k]->get();
      follower.follow(start);
      EXPECT_EQ(follower.records(), static_cast<int>(4 + k));
      EXPECT_EQ(follower.goal_bits(), lasts ? motion.goal_bits() : goal);
      EXPECT_EQ(
          widest(follower, motion.highest_bits()) < to_rational(std::ldexp(1, -2 * goal + 32)),
          lasts);
      EXPECT_EQ(follower.replays(), 0u);
    }
  }
}

TEST(Motion, Maneuver) {
  ComputedMotion motion(motion_input(scene_of(100, 50, {disk(0, 0, 1, 1, 2), disk(9, 0, 1, 0, 1)})),
                        {});
  EXPECT_FALSE(motion.same_velocity(0, 1));
  const RoundedState s = motion.maneuver(0, Rational(1, 3), 0, 1);
  EXPECT_EQ(s.px, 1.0 / 3);
  EXPECT_EQ(s.py, 2.0 / 3);
  EXPECT_EQ(s.vx, 0);
  EXPECT_EQ(s.vy, 1);
  EXPECT_TRUE(motion.same_velocity(0, 1));
  EXPECT_TRUE(motion.is_rational(0));
  expect_enclosed(motion);
  ExactMotion exact(motion);
  EXPECT_EQ(exact.site(0, Tower(3)).y, Tower(Rational(2, 3) + Rational(8, 3)));
  // A second one follows the first; then a collision makes the state irrational.
  motion.maneuver(0, Rational(2, 3), 3, Rational(1, 7));
  expect_enclosed(motion);
  EXPECT_EQ(ExactMotion(motion).site(0, Tower(1)).x, Tower(Rational(4, 3)));
  ASSERT_EQ(collide(motion, 1, false).size(), 1u);
  expect_enclosed(motion);
}

}  // namespace
}  // namespace voroproof::internal::testing
