// The oracle of motion against cases worked out by hand and a simulation in doubles.
#include "tests/oracle/motion.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tests/oracle/brute_force.h"
#include "tests/oracle/cgal_apollonius.h"
#include "tests/oracle/scenes.h"

namespace voroproof::oracle {
namespace {

using Number = MotionOracle::Number;

MovingDisk moving(mpq_class x, mpq_class y, mpq_class vx, mpq_class vy, mpq_class r, mpq_class m) {
  return {std::move(x), std::move(y), std::move(vx), std::move(vy), std::move(r), std::move(m)};
}

TEST(Motion, CollisionByHand) {
  // Restitution 1/2, masses 1 and 2: velocities 3 and 0 become 0 and 3/2.
  MotionScene scene{kContainer, 1, WallLaw::normal, mpq_class(1, 2), {}};
  scene.disks = {moving(0, 0, 3, 0, 1, 1), moving(11, 0, 0, 0, 1, 2)};
  const MotionOracle motion(scene, {collision(1, 0)});
  EXPECT_EQ(motion.times()[0], 3);
  EXPECT_EQ(motion.nearest_double(0), 3.0);
  EXPECT_LT(abs(motion.velocity(0, 3)[0]), 1e-290);
  EXPECT_LT(abs(motion.velocity(1, 3)[0] - 1.5), 1e-290);
  EXPECT_EQ(motion.velocity(0, Number(2.5))[0], 3);
  EXPECT_LT(abs(motion.position(1, 5)[0] - 14), 1e-290);
}

// A glancing contact at an irrational time: (10 - t)^2 + 1 = 4.
TEST(Motion, IrrationalTime) {
  MotionScene scene{kContainer, 1, WallLaw::normal, 1, {}};
  scene.disks = {moving(0, 0, 1, 0, 1, 1), moving(10, 1, 0, 0, 1, 1)};
  const MotionOracle motion(scene, {collision(0, 1)});
  EXPECT_LT(abs(motion.times()[0] - (10 - sqrt(Number(3)))), 1e-290);
  // Equal masses exchange the components along n = (sqrt 3, 1) / 2.
  const auto v = motion.velocity(1, motion.times()[0]);
  EXPECT_LT(abs(v[0] - 0.75), 1e-290);
  EXPECT_LT(abs(v[1] - sqrt(Number(3)) / 4), 1e-290);
}

TEST(Motion, WallLaws) {
  // From (0, 3) along x in a circle of radius 5 + 1: contact at x = 4, n = (4, 3).
  MotionScene scene{{0, 0, 6}, mpq_class(1, 2), WallLaw::normal, 1, {moving(0, 3, 1, 0, 1, 1)}};
  const MotionOracle normal(scene, {collision(-1, 0)});
  EXPECT_EQ(normal.times()[0], 4);
  EXPECT_LT(abs(normal.velocity(0, 4)[0] - Number(1) / 25), 1e-290);   // 1 - 1.5 * 16/25
  EXPECT_LT(abs(normal.velocity(0, 4)[1] + Number(18) / 25), 1e-290);  // -1.5 * 12/25
  scene.wall_law = WallLaw::whole;
  const MotionOracle whole(scene, {collision(0, -1)});
  EXPECT_LT(abs(whole.velocity(0, 4)[0] + Number(7) / 50), 1e-290);   // (1 - 2 * 16/25) / 2
  EXPECT_LT(abs(whole.velocity(0, 4)[1] + Number(24) / 50), 1e-290);  // (-2 * 12/25) / 2
}

TEST(Motion, ManeuversAndMissedContacts) {
  MotionScene scene{{0, 0, 100}, 1, WallLaw::normal, 1, {}};
  scene.disks = {moving(0, 0, 0, 0, 1, 1), moving(10, 0, 0, 1, 1, 1)};
  const std::vector<MotionRecord> turn{maneuver(1, 2, -1, 0), maneuver(1, 3, -1, -2)};
  const MotionOracle free(scene, turn);
  EXPECT_EQ(free.times()[1], 3);
  EXPECT_EQ(free.position(1, Number(2.5))[0], 9.5);
  EXPECT_EQ(free.position(1, 4)[1], 0);
  // At t = 4 disk 1 is at (8, 0), below the axis from then on; it passes disk 0 at a distance
  // of 8 * 2 / sqrt 5 and leaves the container, of radius 99 for centres, at
  // (8 - s)^2 + 4 s^2 = 99^2.
  EXPECT_FALSE(free.first_missed_contact(0, 40).has_value());
  const auto exit = free.first_missed_contact(0, 60);
  ASSERT_TRUE(exit.has_value());
  EXPECT_EQ(exit->i, -1);
  EXPECT_EQ(exit->j, 1);
  const Number s = (8 + sqrt(Number(64) + 5 * (99 * 99 - 64))) / 5;
  EXPECT_LT(abs(exit->t - (4 + s)), 1e-90);

  // Straight on along y = 2, or aimed at disk 0.
  const MotionOracle aimed(scene, {maneuver(1, 2, -5, -1)});
  const auto hit = aimed.first_missed_contact(0, 20);
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->i, 0);
  EXPECT_EQ(hit->j, 1);
  const MotionOracle collided(scene, {maneuver(1, 2, -5, -1), collision(0, 1)});
  EXPECT_LT(abs(collided.times()[1] - hit->t), 1e-90);
  EXPECT_FALSE(collided.first_missed_contact(0, 20).has_value());
  // The disk then flies on through the wall: that comes later.
  EXPECT_EQ(aimed.first_missed_contact(0, 60)->i, 0);
  EXPECT_EQ(aimed.first_missed_contact(10, 60)->i, -1);
  // Where the interval begins with an overlap, that is the first instant.
  EXPECT_EQ(free.first_missed_contact(55, 60)->t, 55);
  const MotionOracle back(scene, {turn[0], turn[1], maneuver(1, 55, 1, 2)});
  EXPECT_EQ(back.first_missed_contact(56, 80)->t, 56);
  EXPECT_FALSE(back.first_missed_contact(80, 90).has_value());
  EXPECT_EQ(aimed.first_missed_contact(hit->t + 0.1, 20)->t, hit->t + 0.1);
}

TEST(Motion, RefusesImpossibleRecords) {
  MotionScene scene{{0, 0, 100}, 1, WallLaw::normal, 1, {}};
  scene.disks = {moving(0, 0, 0, 0, 1, 1), moving(10, 0, 1, 0, 1, 1)};
  EXPECT_THROW(MotionOracle(scene, {collision(0, 1)}), std::invalid_argument);
  EXPECT_THROW(MotionOracle(scene, {collision(-1, 0)}), std::invalid_argument);
  EXPECT_THROW(MotionOracle(scene, {collision(0, 2)}), std::invalid_argument);
  EXPECT_THROW(MotionOracle(scene, {collision(1, 1)}), std::invalid_argument);
  EXPECT_THROW(MotionOracle(scene, {maneuver(0, 2, 1, 1), maneuver(0, 1, 1, 1)}),
               std::invalid_argument);
  // Through the wall, or through disk 0, and only then into it.
  EXPECT_THROW(MotionOracle(scene, {maneuver(1, 95, 1, 0), collision(-1, 1)}),
               std::invalid_argument);
  EXPECT_THROW(MotionOracle(scene, {maneuver(1, 0, -1, 0), maneuver(1, 9, -1, 0), collision(0, 1)}),
               std::invalid_argument);
}

// An event-driven simulation in double: who collides with whom, and about when.
std::vector<MotionRecord> simulate(const MotionScene& scene, double horizon,
                                   std::vector<double>* times) {
  struct Body {
    double x, y, vx, vy, r, m;
  };
  std::vector<Body> bodies;
  for (const MovingDisk& d : scene.disks) {
    bodies.push_back(
        {d.x.get_d(), d.y.get_d(), d.vx.get_d(), d.vy.get_d(), d.radius.get_d(), d.mass.get_d()});
  }
  const double wall = scene.container.radius.get_d();
  std::vector<MotionRecord> records;
  for (double now = 0;;) {
    double wait = horizon - now;
    int first = -2, second = -2;
    const int n = static_cast<int>(bodies.size());
    for (int j = 0; j < n; ++j) {
      const Body& b = bodies[static_cast<std::size_t>(j)];
      const double p = b.x * b.vx + b.y * b.vy, q = b.vx * b.vx + b.vy * b.vy;
      const double out =
          (std::sqrt(p * p - q * (b.x * b.x + b.y * b.y - (wall - b.r) * (wall - b.r))) - p) / q;
      if (p + q * out > 0 && out < wait) wait = out, first = -1, second = j;
      for (int i = 0; i < j; ++i) {
        const Body& a = bodies[static_cast<std::size_t>(i)];
        const double dx = b.x - a.x, dy = b.y - a.y, wx = b.vx - a.vx, wy = b.vy - a.vy;
        const double f = dx * wx + dy * wy, g = wx * wx + wy * wy;
        const double disc = f * f - g * (dx * dx + dy * dy - (a.r + b.r) * (a.r + b.r));
        if (f >= 0 || disc <= 0) continue;
        const double meet = (-f - std::sqrt(disc)) / g;
        if (meet < wait) wait = meet, first = i, second = j;
      }
    }
    if (first == -2) return records;
    now += wait;
    for (Body& b : bodies) b.x += wait * b.vx, b.y += wait * b.vy;
    Body& b = bodies[static_cast<std::size_t>(second)];
    if (first < 0) {
      const double k = 2 * (b.vx * b.x + b.vy * b.y) / (b.x * b.x + b.y * b.y);
      b.vx -= k * b.x, b.vy -= k * b.y;
    } else {
      Body& a = bodies[static_cast<std::size_t>(first)];
      const double nx = b.x - a.x, ny = b.y - a.y;
      const double k =
          2 * ((b.vx - a.vx) * nx + (b.vy - a.vy) * ny) / (nx * nx + ny * ny) / (a.m + b.m);
      a.vx += k * b.m * nx, a.vy += k * b.m * ny;
      b.vx -= k * a.m * nx, b.vy -= k * a.m * ny;
    }
    records.push_back(collision(first, second));
    times->push_back(now);
  }
}

MotionScene gas(Random& random, int n) {
  MotionScene scene{kContainer, 1, WallLaw::normal, 1, {}};
  for (const ExactCircle& d : thrown(random, n, [&] { return uniform(random, 10, 40); })) {
    scene.disks.push_back(moving(d.x, d.y, uniform(random, -10, 10), uniform(random, -10, 10),
                                 d.radius, d.radius * d.radius));
  }
  return scene;
}

TEST(Motion, RandomGas) {
  Random random(11);
  const MotionScene scene = gas(random, 8);
  std::vector<double> times;
  const std::vector<MotionRecord> records = simulate(scene, 60, &times);
  ASSERT_GT(records.size(), 30u);
  const MotionOracle motion(scene, records);
  const BasicMotionOracle<1000> finer(scene, records);

  ASSERT_EQ(motion.times().size(), records.size());
  EXPECT_TRUE(std::is_sorted(motion.times().begin(), motion.times().end()));
  for (std::size_t k = 0; k < records.size(); ++k) {
    EXPECT_NEAR(motion.nearest_double(k), times[k], 1e-3);
    EXPECT_EQ(motion.nearest_double(k), finer.nearest_double(k));
    EXPECT_LT(abs(BasicMotionOracle<1000>::Number(motion.times()[k]) - finer.times()[k]), 1e-150);
  }
  EXPECT_FALSE(motion.first_missed_contact(0, 60).has_value());

  const auto energy = [&](const Number& t) {
    Number sum = 0;
    for (std::size_t i = 0; i < scene.disks.size(); ++i) {
      const auto v = motion.velocity(static_cast<int>(i), t);
      sum += oracle::rounded<Number>(scene.disks[i].mass) * (v[0] * v[0] + v[1] * v[1]);
    }
    return sum;
  };
  EXPECT_LT(abs(energy(60) / energy(0) - 1), 1e-280);

  // Without any one of the records the rest is refused, or a contact is missing.
  for (std::size_t k = 0; k < records.size(); ++k) {
    std::vector<MotionRecord> fewer = records;
    fewer.erase(fewer.begin() + static_cast<long>(k));
    try {
      EXPECT_TRUE(MotionOracle(scene, fewer).first_missed_contact(0, 60).has_value());
    } catch (const std::invalid_argument&) {
    }
  }
}

// The exact value of a high-precision number.
mpq_class exact(const Real& x) {
  mpq_class q;
  mpfr_get_q(q.get_mpq_t(), x.backend().data());
  return q;
}

// The diagrams between the events of a motion, by both diagram oracles.
TEST(Motion, DiagramsBetweenEvents) {
  Random random(12);
  const MotionScene scene = gas(random, 7);
  std::vector<double> times;
  const MotionOracle motion(scene, simulate(scene, 60, &times));
  ASSERT_GT(motion.times().size(), 15u);
  std::set<std::set<Quadruple>> seen;
  for (std::size_t k = 0; k + 1 < motion.times().size(); ++k) {
    const Number middle = (motion.times()[k] + motion.times()[k + 1]) / 2;
    const std::vector<Circle> disks = motion.disks_at(middle);
    const BruteDiagram truth = brute_force_diagram(disks, oracle::rounded(kContainer));
    Disks rational;
    for (const Circle& d : disks) rational.push_back({exact(d.x), exact(d.y), exact(d.radius)});
    std::string why;
    EXPECT_TRUE(agrees_with_cgal(rational, kContainer, edges_of(truth), &why)) << why;
    seen.insert(truth.edges);
  }
  EXPECT_GT(seen.size(), 3u);
}

}  // namespace
}  // namespace voroproof::oracle
