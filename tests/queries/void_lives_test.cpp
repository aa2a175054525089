// Voids over time against those of many instants.
#include "library/queries/void_lives.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "library/queries/free_space.h"
#include "library/true_moment.h"
#include "tests/queries/watched.h"
#include "tests/support/formation_scene.h"

namespace voroproof::internal::testing {
namespace {

std::vector<Void> voids_at(const Watched& w, const Rational& t, const Rational& probe) {
  TrueMoment moment = true_moment(w.run.scene, w.run.history, t, {});
  TierCounts counts;
  Clearance clearance(moment.motion, t, moment.diagram, probe, counts);
  return FreeSpace(clearance).voids();
}

std::size_t living(const std::vector<VoidLife>& lives, double t) {
  return static_cast<std::size_t>(std::count_if(
      lives.begin(), lives.end(), [&](const VoidLife& v) { return v.from.lo < t && t < v.to.hi; }));
}

// Compares at many instants, and on both sides of every change, and expects that the lives fit
// together.
int expect_lives(Watched& w, const Rational& probe, const Window& window) {
  const std::vector<VoidLife> lives = void_lives(w.paths, w.cursor, probe, window);
  const double start = window.from.get_d(), end = window.to.get_d();
  std::vector<double> times, changes{start, end};
  for (const VoidLife& v : lives) {
    EXPECT_LE(v.from.hi, v.to.lo);
    for (const Enclosure& e : {v.from, v.to}) {
      EXPECT_LE(e.hi - e.lo, 1e-14 * (1 + e.hi));
      changes.push_back(e.lo);
    }
  }
  constexpr double hair = 1e-7;
  for (const double t : changes) {
    times.push_back(t - hair);
    times.push_back(t + hair);
  }
  for (int k = 0; k < 24; ++k) times.push_back(start + (end - start) * (2 * k + 1) / 48);
  for (const double t : times) {
    const bool near_a_change = std::any_of(changes.begin(), changes.end(),
                                           [&](double c) { return std::fabs(t - c) < 0.5 * hair; });
    if (t <= start || t >= end || near_a_change) continue;
    EXPECT_EQ(living(lives, t), voids_at(w, to_rational(t), probe).size())
        << "t = " << t << ", probe " << probe;
  }
  int inner = 0;
  for (std::size_t k = 0; k < lives.size(); ++k) {
    const VoidLife& v = lives[k];
    inner += v.from.lo > start;
    EXPECT_TRUE(v.from.lo > start || v.before.empty());
    EXPECT_TRUE(v.to.hi < end || v.after.empty());
    for (const std::size_t next : v.after) {
      EXPECT_EQ(lives[next].from.lo, v.to.lo);
      const auto& back = lives[next].before;
      EXPECT_NE(std::find(back.begin(), back.end(), k), back.end());
    }
    for (const std::size_t last : v.before) {
      EXPECT_LT(last, k);
      const auto& forth = lives[last].after;
      EXPECT_NE(std::find(forth.begin(), forth.end(), k), forth.end());
    }
    // What goes on as one place is one life.
    EXPECT_TRUE(v.after.size() != 1 || lives[v.after[0]].before.size() > 1);
    // Just after it has come about the node is in one of the voids.
    const double t = v.from.lo + hair;
    const bool soon_over = std::any_of(changes.begin(), changes.end(), [&](double c) {
      return c > v.from.hi && c < v.from.hi + 2 * hair;
    });
    if (soon_over || !v.at || v.at->kind != ClearanceNode::Kind::vertex) continue;
    bool found = false;
    for (const Void& there : voids_at(w, to_rational(t), probe)) {
      found |= std::count(there.vertices.begin(), there.vertices.end(), v.at->generators) > 0;
    }
    EXPECT_TRUE(found) << "t = " << t << ", probe " << probe;
  }
  return inner;
}

TEST(VoidLives, AreThoseOfEveryInstant) {
  int inner = 0;
  for (const unsigned seed : {4u, 5u, 6u}) {
    for (const int n : {2, 6, 12}) {
      Watched w(crowd(n, seed));
      for (const Rational& probe : {Rational(2), Rational(8), Rational(20)}) {
        inner += expect_lives(w, probe, {1, 9});
      }
    }
  }
  EXPECT_GT(inner, 60);
}

// A column of three parts the container while the upper one is within sqrt 13 of it: then its gap
// with the middle one is less than 2.
TEST(VoidLives, PartAndJoin) {
  const Rational r(5, 2);
  Watched w(scene_of(
      10, 9, {disk(0, 0, r, 0, 0), disk(0, -6, r, 0, 0), disk(Rational(44, 10), 6, r, -1, 0)}));
  ASSERT_TRUE(w.run.complete);
  const auto lives = void_lives(w.paths, w.cursor, 1, {0, Rational(78, 10)});
  ASSERT_EQ(lives.size(), 3u);
  EXPECT_EQ(lives[0].after, (std::vector<std::size_t>{1, 2}));
  EXPECT_NEAR(lives[0].to.lo, 4.4 - std::sqrt(13), 1e-14);
  for (const std::size_t k : {1u, 2u}) {
    EXPECT_EQ(lives[k].before, (std::vector<std::size_t>{0}));
    EXPECT_TRUE(lives[k].after.empty());
  }
  const auto all = void_lives(w.paths, w.cursor, 1, {0, Rational(85, 10)});
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all[3].before, (std::vector<std::size_t>{1, 2}));
  EXPECT_NEAR(all[3].from.lo, 4.4 + std::sqrt(13), 1e-14);
}

// The pocket between four disks keeps none of its vertices when they become cotangent at t = 1.
TEST(VoidLives, GoOnThroughFlips) {
  const Rational y(39, 10), v(1, 10);
  Watched w(scene_of(
      30, 2,
      {disk(4, 0, 2, 0, 0), disk(0, y, 2, 0, v), disk(-4, 0, 2, 0, 0), disk(0, -y, 2, 0, -v)}));
  ASSERT_EQ(w.cursor.size(), 1u);
  const auto lives = void_lives(w.paths, w.cursor, Rational(18, 10), {0, 2});
  ASSERT_EQ(lives.size(), 2u);  // the pocket, and all around
  for (const VoidLife& life : lives) EXPECT_EQ(life.to.lo, 2);
}

// The far point of a lone disk has the clearance (8 + d) / 2 at the distance d from the centre.
TEST(VoidLives, OfALoneDisk) {
  Watched w(scene_of(10, 8, {disk(-4, 0, 2, 1, 0)}));
  const auto lives = void_lives(w.paths, w.cursor, 5, {0, 8});
  ASSERT_EQ(lives.size(), 2u);
  EXPECT_EQ(lives[0].to.lo, 2);
  EXPECT_EQ(lives[1].from.lo, 6);
  EXPECT_EQ(lives[1].at, far_node(0));
  EXPECT_TRUE(lives[1].before.empty());
  EXPECT_TRUE(lives[0].after.empty());
}

TEST(VoidLives, OfNothing) {
  Watched w(scene_of(10, 8, {}));
  EXPECT_EQ(void_lives(w.paths, w.cursor, 10, {1, 8}).size(), 1u);
  EXPECT_TRUE(void_lives(w.paths, w.cursor, 11, {1, 8}).empty());
}

// Many changes at one instant, cotangent generators, a lattice.
TEST(VoidLives, InFormations) {
  for (const auto& flight : {std::vector<std::string>{"square", "circle"}, {"circle", "square"}}) {
    Watched w(scene_of(FormationScene{9, flight}));
    ASSERT_TRUE(w.run.complete);
    const Rational end = w.run.scene.horizon;
    for (const Rational& probe : {Rational(1), Rational(3, 2)}) expect_lives(w, probe, {0, end});
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
