// A history taken at its word: who has turned, where the disks are, and which maneuver is next.
#include "certify/replay.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <vector>

#include "history/scene_motion.h"
#include "tests/certify/begun_replay.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
namespace {

bool contains(const DoubleBall& b, const Rational& x) {
  return abs(Rational(x - to_rational(b.mid))) <= to_rational(b.rad);
}
bool contains(const BallVec2& b, const ExactVec2& x) {
  return contains(b[0], x[0]) && contains(b[1], x[1]);
}

// ---- Who has turned ----

TEST(Replay, RemembersWhoTurnedLast) {
  const Scene scene =
      scene_of(10, 9, {disk(-4, 0, 1, 0, 0), disk(0, 0, 1, 0, 0), disk(4, 0, 1, 0, 0)});
  const CertifyOptions options = recorded();
  Replay replay(scene, options);
  for (GenId g = container_id; g < 3; ++g) {
    EXPECT_FALSE(replay.moved(g));
    EXPECT_EQ(replay.turns(g), 0);
    EXPECT_TRUE(replay.unchanged_since(g, 0));
  }
  EXPECT_EQ(replay.changes(), 0);
  EXPECT_FALSE(replay.partners(0, 1));  // both are new, and have not met
  EXPECT_FALSE(replay.partners(container_id, 1));
  EXPECT_FALSE(replay.hit_container(0));

  replay.note_collision(collision(1, 0, 1, {1, 2}, {3, 4}), {});
  EXPECT_EQ(replay.changes(), 1);
  EXPECT_TRUE(replay.moved(0) && replay.moved(1) && !replay.moved(2));
  EXPECT_TRUE(replay.partners(0, 1));
  EXPECT_TRUE(replay.partners(1, 0));
  EXPECT_FALSE(replay.partners(0, 2));
  EXPECT_FALSE(replay.unchanged_since(0, 0));
  EXPECT_TRUE(replay.unchanged_since(0, 1));
  EXPECT_TRUE(replay.unchanged_since(2, 0));
  EXPECT_EQ(replay.velocity(1).value(), (ExactVec2{3, 4}));

  replay.note_collision(collision(2, container_id, 0, {}, {5, 6}), {});
  EXPECT_TRUE(replay.hit_container(0));
  EXPECT_FALSE(replay.hit_container(1));
  EXPECT_FALSE(replay.partners(0, 1));
  EXPECT_FALSE(replay.partners(container_id, 0));
  EXPECT_FALSE(replay.moved(container_id));
  EXPECT_EQ(replay.turns(container_id), 0);
  EXPECT_EQ(replay.turns(0), 2);
  EXPECT_EQ(replay.turns(1), 1);
  EXPECT_FALSE(replay.unchanged_since(0, 1));
  EXPECT_TRUE(replay.unchanged_since(1, 1));

  replay.note_collision(collision(3, 0, 2, {0, 0}, {7, 8}), {});
  EXPECT_FALSE(replay.hit_container(0));  // was not the last
  EXPECT_TRUE(replay.partners(0, 2));
  EXPECT_EQ(replay.changes(), 3);
}

// Velocities that a line gives as strings are exact, and those it does not give are the computed.
TEST(Replay, VelocitiesAreThoseClaimedOrComputed) {
  const Scene scene = scene_of(10, 9, {disk(-4, 0, 1, Rational(1, 3), 0), disk(4, 0, 1, 0, 0)});
  const CertifyOptions options = recorded();
  Replay replay(scene, options);
  EXPECT_EQ(replay.velocities(0, 1), (ExactPair{ExactVec2{Rational(1, 3), 0}, ExactVec2{0, 0}}));
  EXPECT_EQ(replay.velocities(container_id, 0)[0], (ExactVec2{0, 0}));
  EXPECT_EQ(replay.velocities(container_id, 0)[1], (ExactVec2{Rational(1, 3), 0}));
  replay.note_collision(exact_collision(1, 0, {Rational(2, 7), 1}), {});
  EXPECT_EQ(replay.velocity(0).value(), (ExactVec2{Rational(2, 7), 1}));
  const ExactPair computed{ExactVec2{Rational(1, 9), 2}, ExactVec2{3, 4}};
  replay.note_collision({.t = 2, .i = 0, .j = 1}, computed);
  EXPECT_EQ(replay.velocities(0, 1), computed);
  // What is claimed goes before what is computed.
  replay.note_collision(collision(3, 0, 1, {5, 5}, {6, 6}), computed);
  EXPECT_EQ(replay.velocities(0, 1), (ExactPair{ExactVec2{5, 5}, ExactVec2{6, 6}}));
}

// ---- Where the disks are ----

TEST(Replay, PathsAreExactAfterTurns) {
  Begun b(scene_of(1000, 100, {disk(Rational(1, 3), 0, 1, 1, 2), disk(20, 0, 1, 0, 0)}));
  Replay& replay = b.replay;
  EXPECT_EQ(replay.path(0).at(Rational(1, 2)), (ExactVec2{Rational(5, 6), 1}));
  // Binary64 times and velocities are what they are, not the decimals they were written as.
  const Rational tenth = to_rational(0.1), fifth = to_rational(0.2), third(1, 3);
  ASSERT_FALSE(replay.take(collision(0.1, container_id, 0, {}, {0.2, -1})).is_none());
  const ExactVec2 first{third + tenth, 2 * tenth};
  EXPECT_EQ(replay.path(0).at(tenth), first);
  EXPECT_EQ(replay.path(0).since(), tenth);
  const Rational t = tenth + Rational(5, 7);
  EXPECT_EQ(replay.path(0).at(t),
            (ExactVec2{first[0] + fifth * Rational(5, 7), first[1] - Rational(5, 7)}));
  // A time and a velocity written as strings.
  ASSERT_FALSE(replay.take(exact_collision(t, 0, {third, Rational(-1, 9)})).is_none());
  const ExactVec2 second{first[0] + fifth * Rational(5, 7), first[1] - Rational(5, 7)};
  EXPECT_EQ(replay.path(0).at(t + 9), (ExactVec2{second[0] + 3, second[1] - 1}));
  // Twice at one instant: the disk is where it was.
  ASSERT_FALSE(replay.take(exact_collision(t, 0, {0, 0})).is_none());
  EXPECT_EQ(replay.path(0).at(t + 50), second);
  EXPECT_EQ(replay.positions(0, 1, t + 50), (ExactPair{second, ExactVec2{20, 0}}));
  EXPECT_EQ(replay.positions(container_id, 1, t), (ExactPair{ExactVec2{0, 0}, ExactVec2{20, 0}}));
}

// Enclosures hold the exact values, however long the paths and whatever the numbers.
RC_GTEST_PROP(Replay, EnclosuresHoldTheExactValues, (unsigned seed)) {
  Random random(seed);
  const auto number = [&](double size) {
    const double x = uniform(random, -size, size);
    return random() % 4 == 0 ? Rational(to_rational(x) / 3) : to_rational(x);
  };
  Scene scene = scene_of(1'000'000, 1'000'000, {});
  for (int k = 0; k < 2; ++k) {
    scene.disks.push_back(disk(number(100), number(100), 1, number(3), number(3)));
  }
  const CertifyOptions options = recorded();
  Replay replay(scene, options);
  double t = 0;
  for (int k = 0; k < 12; ++k) {
    t += random() % 5 == 0 ? 0 : uniform(random, 0, 10);
    CollideEvent claim = collision(t, 0, 1, {uniform(random, -3, 3), uniform(random, -3, 3)},
                                   {uniform(random, -3, 3), 0});
    if (random() % 4 == 0)
      claim = exact_collision(to_rational(t) + Rational(1, 7000), 1, {number(3), number(3)});
    const Rational at = exact_time(Claim(claim));
    const ExactPair p = replay.positions(claim.i, claim.j, at);
    const BallPair near = replay.near_positions(claim);
    if (claim.i != container_id) RC_ASSERT(contains(near[0], p[0]));
    RC_ASSERT(contains(near[1], p[1]));
    // And they are of use.
    RC_ASSERT(near[1][0].rad < 1e-9);
    RC_ASSERT(!replay.take(Claim(claim)).is_none());
    const ExactPair v = replay.velocities(0, 1);
    const BallPair near_v = replay.near_velocities(0, 1);
    RC_ASSERT(contains(near_v[0], v[0]) && contains(near_v[1], v[1]));
    t = round_up(at);
  }
}

// The motion that is given the paths knows them, and is asked for exact states where they are none
// of doubles.
TEST(Replay, GivesTheMotionItsPaths) {
  Begun b(scene_of(1000, 100, {disk(0, 0, 1, 1, 2), disk(20, 0, 1, 0, 0), disk(0, 30, 1, 0, 1)}));
  ASSERT_FALSE(b.replay.take(collision(0.1, container_id, 0, {}, {0.2, -1})).is_none());
  ASSERT_FALSE(b.replay.take(exact_collision(Rational(1, 3), 1, {Rational(1, 3), 1})).is_none());
  GivenMotion motion(motion_input(b.scene), {});
  b.replay.move(motion);
  const Rational t(5, 2);
  for (GenId g = 0; g < 3; ++g) {
    const ExactVec2 p = b.replay.path(g).at(t);
    const Site<DoubleBall> site = motion.site(g, DoubleBall(2.5));
    EXPECT_TRUE(contains(site.x, p[0]) && contains(site.y, p[1])) << g;
    EXPECT_LT(site.x.rad, 1e-9);
  }
  DiskInput state = b.scene.disks[0];
  b.replay.state(0, state);
  EXPECT_EQ(Rational(state.x), to_rational(0.1));
  EXPECT_EQ(Rational(state.y), 2 * to_rational(0.1));
  EXPECT_EQ(Rational(state.vx), to_rational(0.2));
  EXPECT_EQ(Rational(state.vy), -1);
  EXPECT_EQ(Rational(state.radius), 1);
}

// ---- Claims without velocities ----

TEST(Replay, ComputesTheVelocitiesThatAreNotClaimed) {
  Begun b(scene_of(100, 9, {disk(0, 0, 1, 1, 0, 1), disk(5, 0, 1, 0, 0, 2)}));
  // The paths meet at t = 3, with the normal along the x axis; thirds are rounded to binary64.
  const CollideEvent bare{.t = 3, .i = 0, .j = 1};
  const ExactPair on_paths = b.replay.positions(0, 1, 3);
  const Rational minus_third = to_rational(round_nearest(Rational(-1, 3))),
                 two_thirds = to_rational(round_nearest(Rational(2, 3)));
  EXPECT_EQ(b.replay.computed_velocities(bare, on_paths),
            (ExactPair{ExactVec2{minus_third, 0}, ExactVec2{two_thirds, 0}}));
  // With centres claimed these make the normal, here the diagonal.
  CollideEvent with_centres = bare;
  with_centres.p = {Vec2{0, 0}, Vec2{1, 1}};
  EXPECT_EQ(Replay::recorded_centers(with_centres, on_paths),
            (ExactPair{ExactVec2{0, 0}, ExactVec2{1, 1}}));
  EXPECT_EQ(Replay::recorded_centers(bare, on_paths), on_paths);
  EXPECT_EQ(b.replay.computed_velocities(with_centres, on_paths),
            (ExactPair{ExactVec2{to_rational(round_nearest(Rational(1, 3))), -two_thirds},
                       ExactVec2{to_rational(round_nearest(Rational(1, 3))),
                                 to_rational(round_nearest(Rational(1, 3)))}}));
  ASSERT_FALSE(b.replay.take(bare).is_none());
  EXPECT_EQ(b.replay.velocity(1).value(), (ExactVec2{two_thirds, 0}));
  EXPECT_EQ(b.replay.path(1).at(6), (ExactVec2{5 + 3 * two_thirds, 0}));
}

// ---- Maneuvers ----

Scene with_maneuvers() {
  Scene scene = scene_of(100, 9, {disk(0, 0, 1, 0, 0), disk(5, 0, 1, 0, 0), disk(0, 5, 1, 0, 0)});
  scene.maneuvers = {
      {1, 0, 1, 0}, {1, 1, 2, 0}, {1, 2, 3, Rational(1, 3)}, {2, 0, 4, 0}, {3, 1, 5, 0}};
  return scene;
}

TEST(Replay, ManeuversOfOneInstantInAnyOrder) {
  std::vector<GenId> order{0, 1, 2};
  do {
    Begun b(with_maneuvers());
    std::set<std::size_t> done;
    for (const GenId g : order) {
      const ManeuverEvent claim{1, g};
      EXPECT_EQ(b.replay.scheduled(claim, 1), static_cast<std::size_t>(g));
      const auto place = b.replay.take(claim);
      ASSERT_FALSE(place.is_none());
      EXPECT_EQ(place.turns, g);
      EXPECT_EQ(b.replay.diagram().org(place.half), g);
      done.insert(g);
      for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(b.replay.maneuver_done(k), done.contains(k));
      std::size_t first = 0;
      while (done.contains(first)) ++first;
      EXPECT_EQ(b.replay.next_maneuver(), first);
    }
    EXPECT_EQ(b.replay.velocity(1).value(), (ExactVec2{2, 0}));
    // A claim without a velocity has that of the scene, exactly.
    EXPECT_EQ(b.replay.path(2).at(2), (ExactVec2{3, 5 + Rational(1, 3)}));
    EXPECT_FALSE(b.replay.partners(0, 1));
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Replay, ManeuversOfOtherInstantsWait) {
  Begun b(with_maneuvers());
  for (const GenId g : {2, 0, 1}) ASSERT_FALSE(b.replay.take(ManeuverEvent{1, g}).is_none());
  const Rational tolerance = b.options.tolerance;
  // Disk 1 has its turn at 3, after that of disk 0 at 2: it may come first only where both are
  // within the tolerance.
  EXPECT_EQ(b.replay.scheduled(ManeuverEvent{2, 1}, 2), 4u);
  EXPECT_EQ(b.replay.scheduled(ManeuverEvent{1, 1}, 2 - tolerance), 4u);
  EXPECT_EQ(b.replay.scheduled(ManeuverEvent{1, 1}, 2 - Rational(3, 2) * tolerance), std::nullopt);
  EXPECT_EQ(b.replay.scheduled(ManeuverEvent{2, 2}, 2), std::nullopt);
  ASSERT_FALSE(b.replay.take(ManeuverEvent{.t = 2, .disk = 0, .v = Vec2{0.5, 0.25}}).is_none());
  EXPECT_EQ(b.replay.velocity(0).value(), (ExactVec2{Rational(1, 2), Rational(1, 4)}));
  EXPECT_EQ(b.replay.next_maneuver(), 4u);
  ASSERT_FALSE(b.replay.take(ManeuverEvent{3, 1}).is_none());
  EXPECT_EQ(b.replay.next_maneuver(), 5u);
  EXPECT_TRUE(b.replay.take(ManeuverEvent{3, 1}).is_none());
}

// A maneuver after a blow by the container is what happened last.
TEST(Replay, AManeuverIsNoBlow) {
  Begun b(with_maneuvers());
  ASSERT_FALSE(b.replay.take(collision(0.5, container_id, 0, {}, {1, 1})).is_none());
  EXPECT_TRUE(b.replay.hit_container(0));
  ASSERT_FALSE(b.replay.take(ManeuverEvent{1, 0}).is_none());
  EXPECT_FALSE(b.replay.hit_container(0));
  EXPECT_EQ(b.replay.turns(0), 2);
}

// ---- Copies ----

TEST(Replay, CopiesAreIndependent) {
  Begun b(with_maneuvers());
  const Replay before = b.replay;
  const Diagram diagram = before.diagram();
  HalfEdge h = 0;
  while (diagram.quad(h).s == diagram.quad(h).e) ++h;
  ASSERT_FALSE(b.replay.take(FlipEvent{0.5, diagram.quad(h)}).is_none());
  ASSERT_FALSE(b.replay.take(collision(0.75, container_id, 0, {}, {7, 7})).is_none());
  ASSERT_FALSE(b.replay.take(ManeuverEvent{1, 1}).is_none());
  EXPECT_EQ(before.diagram(), diagram);
  EXPECT_NE(b.replay.diagram(), diagram);
  EXPECT_EQ(before.changes(), 0);
  EXPECT_EQ(b.replay.changes(), 2);
  EXPECT_FALSE(before.maneuver_done(1));
  EXPECT_TRUE(b.replay.maneuver_done(1));
  EXPECT_FALSE(before.moved(0));
  EXPECT_EQ(before.path(0).at(8), (ExactVec2{0, 0}));
  EXPECT_EQ(before.velocity(0).value(), (ExactVec2{0, 0}));
  // And the copy goes on from where it was taken.
  Replay other = before;
  ASSERT_FALSE(other.take(collision(0.25, container_id, 0, {}, {1, 0})).is_none());
  EXPECT_EQ(other.path(0).at(1), (ExactVec2{Rational(3, 4), 0}));
  EXPECT_EQ(b.replay.path(0).at(1), (ExactVec2{Rational(7, 4), Rational(7, 4)}));
}

}  // namespace
}  // namespace voroproof::internal::testing
