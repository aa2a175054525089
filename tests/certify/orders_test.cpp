// The order of what one instant changes: exchanged claims that are right, other orders by their
// right name, and what is missing of two at one instant.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>

#include "certify/report.h"
#include "tests/certify/claimed_history.h"

namespace voroproof::internal::testing {
namespace {

namespace fs = std::filesystem;
using Events = std::vector<voroproof::internal::Event>;

const CollideEvent* collision_at(const Events& events, std::size_t k) {
  return k < events.size() ? std::get_if<CollideEvent>(&events[k]) : nullptr;
}

// Reverses each run of collisions of one time that share no disk. How many runs there are of more
// than one.
int reverse_simultaneous(Events& events) {
  int reversed = 0;
  for (std::size_t k = 0; k < events.size();) {
    std::size_t end = k;
    std::set<GenId> disks;
    while (const auto* c = collision_at(events, end)) {
      const bool shares = disks.contains(c->j) || (c->i != container_id && disks.contains(c->i));
      if (shares || c->t != time(events[k])) break;
      disks.insert({c->i, c->j});
      ++end;
    }
    if (end > k + 1) {
      std::reverse(events.begin() + static_cast<std::ptrdiff_t>(k),
                   events.begin() + static_cast<std::ptrdiff_t>(end));
      ++reversed;
    }
    k = std::max(end, k + 1);
  }
  return reversed;
}

TEST(Orders, SimultaneousCollisionsOfTheCorpusMayBeExchanged) {
  int histories = 0, runs = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(VOROPROOF_CASES)) {
    if (entry.path().filename() != "exact.history.jsonl") continue;
    const Scene scene = read_scene((entry.path().parent_path() / "scene.scene.json").string());
    auto h = read_claimed_history(entry.path().string(), scene);
    if (!h) continue;
    const int reversed = reverse_simultaneous(h->events);
    if (reversed == 0) continue;
    ++histories;
    runs += reversed;
    const Certificate c = certify(scene, *h);
    EXPECT_EQ(c.verdict, Verdict::certified) << entry.path() << "\n" << reason_line(c);
  }
  EXPECT_GE(histories, 51);
  EXPECT_GE(runs, 100);
}

CollideEvent collision(double t, GenId i, GenId j, double vi, double vj) {
  CollideEvent e;
  e.t = t;
  e.i = i;
  e.j = j;
  if (i != container_id) e.v[0] = Vec2{vi, 0};
  e.v[1] = Vec2{vj, 0};
  return e;
}

Certificate judged(const Scene& scene, Events events, CertifyOptions options = {}) {
  ClaimedHistory h = claimed_history(scene, run(scene));
  h.events = std::move(events);
  h.count();
  return certify(scene, h, options);
}

CertifyOptions any_order() {
  CertifyOptions options;
  options.any_order = true;
  return options;
}

// One runs into each end of a row of three, of masses 1, 2, 1: whether the left or the right blow
// comes first decides what comes of them.
Scene hit_from_both_sides(int t) {
  return scene_of(60, t + Rational(1, 2),
                  {disk(-2 - t, 0, 1, 1, 0), disk(0, 0, 1, 0, 0, 2), disk(2 + t, 0, 1, -1, 0)});
}
Events left_first(double t) {
  return {collision(t, 0, 1, -1.0 / 3, 2.0 / 3), collision(t, 1, 2, -4.0 / 9, 11.0 / 9),
          collision(t, 0, 1, -13.0 / 27, -10.0 / 27)};
}
Events right_first(double t) {
  return {collision(t, 1, 2, -2.0 / 3, 1.0 / 3), collision(t, 0, 1, -11.0 / 9, 4.0 / 9),
          collision(t, 1, 2, 10.0 / 27, 13.0 / 27)};
}

TEST(Orders, AnotherOrderHasANameAndIsAcceptedWhereItIsAskedFor) {
  for (const int t : {0, 1}) {
    const Scene scene = hit_from_both_sides(t);
    EXPECT_EQ(judged(scene, left_first(t)).verdict, Verdict::certified);
    EXPECT_EQ(judged(scene, left_first(t), any_order()).other_orders, 0);
    const Certificate other = judged(scene, right_first(t));
    ASSERT_TRUE(other.divergence);
    EXPECT_EQ(other.divergence->fault, Fault::other_order) << reason_line(other);
    const Certificate accepted = judged(scene, right_first(t), any_order());
    EXPECT_EQ(accepted.verdict, Verdict::certified) << reason_line(accepted);
    EXPECT_EQ(accepted.other_orders, 1);
    CertifyOptions strict = any_order();
    strict.strict = true;
    EXPECT_EQ(judged(scene, right_first(t), strict).verdict, Verdict::refuted);
  }
}

// What is left due is missing, by whatever order.
TEST(Orders, ACollisionThatIsLeftDueIsMissing) {
  for (const int t : {0, 1}) {
    for (const CertifyOptions& options : {CertifyOptions{}, any_order()}) {
      Events events = right_first(t);
      events.pop_back();
      const Certificate c = judged(hit_from_both_sides(t), events, options);
      ASSERT_TRUE(c.divergence);
      EXPECT_EQ(c.divergence->fault, Fault::missing_event) << reason_line(c);
      EXPECT_EQ(c.divergence->true_contact, std::pair(1, 2));
    }
  }
}

// A collision of two that touch and part is none in any order.
TEST(Orders, TwoThatPartDoNotCollideInAnyOrder) {
  Events events = right_first(1);
  events.push_back(collision(1, 0, 1, -11.0 / 9, 4.0 / 9));
  const Certificate c = judged(hit_from_both_sides(1), events, any_order());
  ASSERT_TRUE(c.divergence);
  EXPECT_EQ(c.divergence->fault, Fault::spurious_event);
  EXPECT_NE(reason_line(c).find("touch at t = 1, and part at a speed of 1.59259"),
            std::string::npos)
      << reason_line(c);
}

// A maneuver may come before a collision that it averts.
TEST(Orders, AManeuverThatAvertsACollision) {
  Scene scene = scene_of(60, 2, {disk(-2, 0, 1, 1, 0), disk(1, 0, 1, 0, 0)});
  scene.maneuvers.push_back({1, 1, 2, 0});
  ManeuverEvent turn;
  turn.t = 1;
  turn.disk = 1;
  EXPECT_EQ(judged(scene, {turn}).divergence->fault, Fault::missing_event);
  const Certificate accepted = judged(scene, {turn}, any_order());
  EXPECT_EQ(accepted.verdict, Verdict::certified) << reason_line(accepted);
  EXPECT_EQ(accepted.other_orders, 1);
}

// A disk at the wall is hit from behind at the same instant: without its first collision with the
// wall that is missing, though the wall is hit again. Of a cradle the blow that begins it.
TEST(Orders, OfTwoAtOneInstantTheMissingOneIsBlamed) {
  const Scene corner = scene_of(10, 3, {disk(7, 0, 1, 1, 0), disk(3, 0, 1, 2, 0)});
  const Events right{collision(2, container_id, 0, 0, -1), collision(2, 0, 1, 2, -1),
                     collision(2, container_id, 0, 0, -2), collision(2, 0, 1, -1, -2)};
  ASSERT_EQ(judged(corner, right).verdict, Verdict::certified);
  const Certificate wall = judged(corner, {right.begin() + 1, right.end()});
  ASSERT_TRUE(wall.divergence);
  EXPECT_EQ(wall.divergence->fault, Fault::missing_event) << reason_line(wall);
  EXPECT_EQ(wall.divergence->true_contact, std::pair(container_id, 0));
  EXPECT_EQ(wall.divergence->line, 2);
  const Certificate again = judged(corner, {right[0], right[1], right[3]});
  EXPECT_EQ(again.divergence->fault, Fault::missing_event) << reason_line(again);
  EXPECT_EQ(again.divergence->true_contact, std::pair(container_id, 0));

  const Scene cradle =
      scene_of(60, 2, {disk(-3, 0, 1, 1, 0), disk(0, 0, 1, 0, 0), disk(2, 0, 1, 0, 0)});
  const Certificate blow = judged(cradle, {collision(1, 1, 2, 0, 1)});
  ASSERT_TRUE(blow.divergence);
  EXPECT_EQ(blow.divergence->fault, Fault::missing_event) << reason_line(blow);
  EXPECT_EQ(blow.divergence->true_contact, std::pair(0, 1));
}

// What is said of two that are claimed to collide, and do not.
TEST(Orders, HowTwoThatDoNotCollideStand) {
  const Scene scene = scene_of(
      30, 3,
      {disk(-1, 0, 1, 0, 1), disk(1, 0, 1, 0, 1), disk(8, 0, 1, 0, 0), disk(8, 5, 1, 0, -1)});
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    CertifyOptions options;
    options.truth = truth;
    options.events = EventKinds::collisions;
    const auto said = [&](GenId i, GenId j) {
      const Certificate c = judged(scene, {collision(0, i, j, 0, 0)}, options);
      return c.divergence ? c.divergence->truth : "";
    };
    EXPECT_EQ(said(0, 1),
              "generators [0,1] touch at t = 0, and are at rest relative to each other");
    EXPECT_EQ(said(1, 2), "generators [1,2] do not touch: at t = 0 they are 5 apart");
    EXPECT_EQ(said(container_id, 2), "generators [-1,2] do not touch: at t = 0 they are 21 apart");
  }
}

// A disk that slides along the wall has no motion in this model, from the horizon on, too.
TEST(Orders, ASlideIsUndecided) {
  for (const int t : {1, 2}) {
    Scene scene = scene_of(10, 2, {disk(0, -9, 1, 0, 0), disk(0, 5, Rational(1, 2), 0, 0)});
    scene.maneuvers.push_back({t, 0, 1, 0});
    ClaimedHistory h;
    h.header.horizon = 2;
    h.header.initial = std::vector<Quad>{{-1, 0, 1, 1}, {-1, 1, 0, 0}, {0, 1, -1, -1}};
    ManeuverEvent turn;
    turn.t = t;
    turn.v = Vec2{1, 0};
    h.events = {turn};
    h.count();
    for (const Truth truth : {Truth::exact, Truth::recorded}) {
      CertifyOptions options;
      options.truth = truth;
      EXPECT_EQ(certify(scene, h, options).verdict, Verdict::undecided);
    }
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
