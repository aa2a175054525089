// Gap forms in doubles against those in fractions, and these against gaps by hand.
#include "filtered/billiards/billiard_gaps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "exact/polynomial.h"

namespace voroproof::internal {
namespace {

// Two disks that fall and one that is fixed, between walls, sheared; or in a circle.
Billiard sample(std::mt19937& random, bool round, bool gravity) {
  const auto number = [&](int lo, int hi) {
    Rational q(std::uniform_int_distribution<int>(8 * lo, 8 * hi)(random),
               std::uniform_int_distribution<int>(1, 8)(random));
    q.canonicalize();
    return q;
  };
  Billiard billiard;
  billiard.dimension = 3;
  billiard.horizon = 10;
  if (gravity) billiard.gravity = {number(-2, 2), number(-2, 2), number(-2, 2)};
  if (round) {
    billiard.round = RoundFrame{{number(-1, 1), number(-1, 1), number(-1, 1)}, 60, 1};
  } else {
    billiard.walls.push_back({{Rational(3, 5), 0, Rational(4, 5)}, -20, Rational(1, 3), 1});
    billiard.lattice = {{30, 20, 0}, Rational(1, 7)};
  }
  for (int i = 0; i < 3; ++i) {
    BilliardDisk disk;
    disk.center = {number(-4, 4), number(-4, 4), number(-4, 4)};
    disk.radius = number(1, 2);
    disk.growth = Rational(i, 16);
    disk.mass = i + 1;
    disk.fixed = i == 2;
    if (!disk.fixed) disk.velocity = {number(-3, 3), number(-3, 3), number(-3, 3)};
    billiard.disks.push_back(disk);
  }
  return billiard;
}

bool contains(const DoubleBall& ball, const Rational& value) {
  return abs(Rational(to_rational(ball.mid) - value)) <= to_rational(ball.rad);
}

DoubleBall enclose(const Rational& q) { return {q.get_d(), std::fabs(q.get_d()) * 0x1p-52}; }

// The gap at that time, in doubles.
double gap(const Billiard& billiard, const BilliardGaps<Rational>& gaps, const BilliardPair& pair,
           const Flight<Rational>& a, const Flight<Rational>& b, const Rational& t) {
  const BilliardDisk& disk = billiard.disks[static_cast<std::size_t>(pair.b)];
  const Vec3 place = gaps.place(pair.b, b, t);
  const double radius = Rational(disk.radius + disk.growth * t).get_d();
  if (pair.a < 0 && !billiard.round) {
    const BilliardWall& wall = billiard.walls.front();
    return Rational(dot(wall.normal, place) - wall.offset - wall.speed * t).get_d() - radius;
  }
  const Vec3 from = pair.a < 0 ? billiard.round->center : gaps.place(pair.a, a, t);
  const Vec3 d = place + gaps.offset(pair.image, t) - from;
  const double distance = std::sqrt(dot(d, d).get_d());
  return pair.a < 0 ? billiard.round->radius.get_d() - radius - distance
                    : distance - gaps.reach(pair, t).get_d();
}

TEST(BilliardGaps, FormsHaveTheSignsOfGaps) {
  std::mt19937 random(1);
  int signs[2] = {0, 0};
  for (int round = 0; round < 400; ++round) {
    const Billiard billiard = sample(random, round % 2 == 0, round % 4 < 2);
    const BilliardGaps<Rational> exact(billiard);
    const BilliardGaps<DoubleBall> near(billiard);
    std::vector<Flight<Rational>> lines;
    std::vector<Flight<DoubleBall>> near_lines;
    for (const BilliardDisk& disk : billiard.disks) {
      const Rational t0(static_cast<long>(lines.size()), 3);
      lines.push_back({t0, disk.center, disk.velocity});
      Flight<DoubleBall> enclosed{enclose(t0), {}, {}};
      for (std::size_t k = 0; k < 3; ++k) {
        enclosed.x[k] = enclose(disk.center[k]);
        enclosed.v[k] = enclose(disk.velocity[k]);
      }
      near_lines.push_back(enclosed);
    }
    const bool is_round = billiard.round.has_value();
    const LatticeImage image = is_round ? LatticeImage{} : LatticeImage{1, -1, 0};
    for (const BilliardPair& pair :
         {BilliardPair{-1, 0}, {-1, 2}, {0, 1}, {0, 1, image}, {0, 2}, {1, 2, image}}) {
      const auto a = static_cast<std::size_t>(std::max(pair.a, 0));
      const auto b = static_cast<std::size_t>(pair.b);
      const Rational since(2, 3), depth(1, 9);
      for (const Rational& deep : {Rational(0), depth, Rational(-depth)}) {
        const auto form = exact.form(pair, lines[a], lines[b], since, deep);
        const auto enclosed =
            near.form(pair, near_lines[a], near_lines[b], enclose(since), enclose(deep));
        const Polynomial<Rational> f(std::vector<Rational>(form.begin(), form.end()));
        EXPECT_LE(f.degree(), exact.degree(pair));
        for (std::size_t k = 0; k < form.size(); ++k)
          ASSERT_TRUE(contains(enclosed[k], form[k])) << round << ' ' << k;
        for (int u = 0; u <= 8; ++u) {
          const double g = gap(billiard, exact, pair, lines[a], lines[b], since + u);
          if (std::fabs(g + deep.get_d()) < 1e-9) continue;
          const int sign_of_gap = g + deep.get_d() > 0 ? 1 : -1;
          ASSERT_EQ(sgn(f.evaluate(u)), sign_of_gap) << round << ' ' << pair.a << ' ' << pair.b;
          ++signs[sign_of_gap > 0];
        }
        if (certainly_positive(enclosed, exact.degree(pair), 0, 8)) {
          for (int u = 0; u <= 64; ++u) ASSERT_GT(f.evaluate(Rational(u, 8)), 0);
        }
      }
    }
  }
  EXPECT_GT(signs[0], 100);
  EXPECT_GT(signs[1], 100);
}

// Nothing turns positive by rounding, and what is clearly so is found.
TEST(BilliardGaps, PositiveForms) {
  const auto form = [](double c, double b, double a) {
    return GapForm<DoubleBall>{DoubleBall(c), DoubleBall(b), DoubleBall(a), 0.0, 0.0};
  };
  EXPECT_TRUE(certainly_positive(form(1, 0, 0), 2, 0, 5));
  EXPECT_TRUE(certainly_positive(form(1, -2, 1.125), 2, 0, 5));  // 1/9 at its least
  EXPECT_FALSE(certainly_positive(form(1, -2, 1), 2, 0, 5));     // touches 0 at 1
  EXPECT_TRUE(certainly_positive(form(1, -2, 1), 2, 1.5, 5));
  EXPECT_FALSE(certainly_positive(form(0, 1, 0), 2, 0, 1));   // 0 at the start
  EXPECT_FALSE(certainly_positive(form(1, -1, 0), 2, 0, 1));  // 0 at the end
  EXPECT_FALSE(certainly_positive(form(1, -3, 2), 2, 0, 5));  // negative between 1/2 and 1
  EXPECT_FALSE(certainly_positive({DoubleBall(1, 2), 0.0, 0.0, 0.0, 0.0}, 2, 0, 1));
}

}  // namespace
}  // namespace voroproof::internal
