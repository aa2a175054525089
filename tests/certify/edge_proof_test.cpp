// What is proved of an edge over an interval in doubles, against signs in rationals.
#include "certify/edge_proof.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <vector>

#include "certify/contact_proof.h"
#include "certify/edge_circles.h"
#include "certify/edge_signs.h"
#include "certify/rootless.h"
#include "filtered/computed/computed_motion.h"
#include "filtered/search/bernstein.h"
#include "tests/support/compact_arithmetic.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
namespace {

class FourDisks {
 public:
  // Lengths are multiplied by `unit`, a power of two.
  FourDisks(double largest_radius, bool equal, Random& random, double unit = 1) : unit_(unit) {
    input_.container_radius = 300 * unit;
    input_.horizon = 100;
    const auto any = [&](double size) { return Rational(unit * uniform(random, -size, size)); };
    const Rational one(unit * uniform(random, 0, largest_radius));
    for (int k = 0; k < 4; ++k) {
      const Rational radius = equal ? one : Rational(unit * uniform(random, 0, largest_radius));
      input_.disks.push_back({any(100), any(100), radius, any(3), any(3), 1});
    }
  }
  const MotionInput& input() const { return input_; }

  // Whether no two disks overlap at any time of [a, b], and none leaves the container.
  bool apart(double a, double b) const {
    for (int i = 0; i < 4; ++i) {
      const DiskInput& d = input_.disks[i];
      for (const double t : {a, b}) {
        const double x = round_nearest(d.x) + t * round_nearest(d.vx),
                     y = round_nearest(d.y) + t * round_nearest(d.vy);
        if (std::hypot(x, y) + round_nearest(d.radius) > 299 * unit_) return false;
      }
      for (int j = 0; j < i; ++j) {
        const DiskInput& o = input_.disks[j];
        const double wx = Rational(d.vx - o.vx).get_d(), wy = Rational(d.vy - o.vy).get_d();
        const double dx = Rational(d.x - o.x).get_d(), dy = Rational(d.y - o.y).get_d();
        const double nearest = -(dx * wx + dy * wy) / (wx * wx + wy * wy);
        const double t = std::clamp(nearest, a, b);
        const double reach = Rational(d.radius + o.radius).get_d() + 1e-6 * unit_;
        if (std::hypot(dx + t * wx, dy + t * wy) < reach) return false;
      }
    }
    return true;
  }

  // Whether the two do not touch at t.
  bool apart(GenId i, GenId j, double t) const {
    const Site<Rational> a = site(i, t), b = site(j, t);
    const Rational x = a.x - b.x, y = a.y - b.y, reach = a.r + b.r;
    const Rational beyond = x * x + y * y - reach * reach;
    return i == container_id ? sgn(beyond) < 0 : sgn(beyond) > 0;
  }
  // Whether at every time of [a, b] no disk touches the inside of another or is not within the
  // container: the square of the distance less that of the radii's difference is convex in time.
  bool separated(double a, double b) const {
    for (GenId i = container_id; i < 4; ++i) {
      for (GenId j = std::max(i + 1, 0); j < 4; ++j) {
        std::vector<Rational> times{to_rational(a), to_rational(b)};
        if (i != container_id) {
          const DiskInput &d = input_.disks[i], &o = input_.disks[j];
          const Rational x = d.x - o.x, y = d.y - o.y, vx = d.vx - o.vx, vy = d.vy - o.vy;
          const Rational v2 = vx * vx + vy * vy;
          if (sgn(v2) > 0)
            times.push_back(std::clamp(Rational(-(x * vx + y * vy) / v2), times[0], times[1]));
        }
        for (const Rational& t : times) {
          const Site<Rational> p = site(i, t), q = site(j, t);
          if (sign(tangency(p, q)) != (i == container_id ? Sign::negative : Sign::positive))
            return false;
        }
      }
    }
    return true;
  }
  // The sign of the cotangency, and those of the circles.
  std::pair<Sign, EdgeSigns> signs(const Quad& q, double t) const {
    const Site<Rational> l = site(q.l, t), r = site(q.r, t), s = site(q.s, t), e = site(q.e, t);
    const Sign f = sign(cotangency(l, r, s, e));
    return {f, edge_signs(q, l, r, s, e, f)};
  }

  struct State {
    int f;         // the sign of the cotangency
    bool legal;    // both circles exist and are free of the other's third generator
    bool illegal;  // both exist, and neither is
  };
  State at(const Quad& q, double t) const {
    const Site<Rational> l = site(q.l, t), r = site(q.r, t), s = site(q.s, t), e = site(q.e, t);
    const Sign f = sign(cotangency(l, r, s, e));
    const EdgeSigns signs = edge_signs(q, l, r, s, e, f);
    const bool exist = signs.start_exists == Sign::positive && signs.end_exists == Sign::positive;
    return {static_cast<int>(f),
            exist && signs.end_in_start == Sign::positive && signs.start_in_end == Sign::positive,
            exist && signs.end_in_start == Sign::negative && signs.start_in_end == Sign::negative};
  }

 private:
  Site<Rational> site(GenId g, double t) const { return site(g, to_rational(t)); }
  Site<Rational> site(GenId g, const Rational& t) const {
    if (g == container_id) return {0, 0, Rational(-input_.container_radius)};
    const DiskInput& d = input_.disks[g];
    return {d.x + d.vx * t, d.y + d.vy * t, d.radius};
  }
  MotionInput input_;
  double unit_;
};

// The times of a grid over [a, b], and one just after each sign change of f that it shows.
std::vector<double> telling_times(const FourDisks& disks, const Quad& q, double a, double b,
                                  int& changes) {
  constexpr int parts = 10;
  std::vector<double> times{a};
  for (int k = 1; k <= parts; ++k) {
    double lo = times.back(), hi = k == parts ? b : a + (b - a) * k / parts;
    const double end = hi;
    const int before = disks.at(q, lo).f;
    if (disks.at(q, hi).f != before) {
      ++changes;
      for (double middle = 0.5 * (lo + hi); lo < middle && middle < hi; middle = 0.5 * (lo + hi)) {
        (disks.at(q, middle).f == before ? lo : hi) = middle;
      }
      times.push_back(hi);
    }
    times.push_back(end);
  }
  return times;
}

struct Tally {
  int proved = 0, with_roots = 0, collapsing = 0, collapses = 0, first = 0, one_root = 0,
      proved_of_one = 0;
};

// What is proved of edges of random disks, which is checked, and how much.
void prove_edges(int edges, double unit, Tally& tally) {
  Random random(8);
  for (int k = 0; k < edges; ++k) {
    const FourDisks disks(k % 2 == 0 ? 40 : 4, k % 5 == 0, random, unit);
    const GenId last = k % 3 == 0 ? container_id : 3;
    const double a = uniform(random, 0, 20);
    // The first way to pair the four that is legal.
    std::array<GenId, 4> ids{0, 1, 2, last};
    std::sort(ids.begin(), ids.end());
    Quad q{};
    do {
      q = {ids[0], ids[1], ids[2], ids[3]};
    } while (!disks.at(q, a).legal && std::next_permutation(ids.begin(), ids.end()));
    if (!disks.at(q, a).legal) continue;
    const double b = a + std::ldexp(uniform(random, 1, 2), static_cast<int>(random() % 5) + 1);
    if (!disks.apart(a, b)) continue;
    int changes = 0;
    const std::vector<double> times = telling_times(disks, q, a, b, changes);
    const auto bad =
        std::find_if(times.begin(), times.end(), [&](double t) { return disks.at(q, t).illegal; });
    tally.collapsing += bad != times.end();
    const ComputedMotion motion(disks.input(), {});
    RootlessBatch batch(motion);
    batch.add(q, a, b);
    batch.prove();
    const bool of_one = batch.one_root(0) && proved_free_of_one(motion, q, b, batch.end_sign(0));
    if (batch.one_root(0)) {
      ++tally.one_root;
      ASSERT_LE(changes, 1);
      if (batch.end_sign(0) != Sign::unknown) {
        ASSERT_EQ(static_cast<int>(batch.end_sign(0)), disks.at(q, b).f);
      }
    }
    tally.proved_of_one += of_one;
    if (proved_free(motion, q, a, b) || of_one) {
      ++tally.proved;
      tally.with_roots += changes > 0;
      ASSERT_EQ(bad, times.end()) << "at " << *bad << " in [" << a << ", " << b << "]";
    }
    if (bad == times.end()) continue;
    // The collapse lies between this time and the one before it in the list.
    const double pad = 1e-7, root = *bad;
    const bool there = proved_collapse(motion, q, root - pad, root + pad);
    tally.collapses += there;
    if (there) {
      ASSERT_FALSE(disks.at(q, root - pad).illegal);
      ASSERT_TRUE(disks.at(q, root + pad).illegal);
    }
    // None is before it: the root was found by halving from the legal side.
    const bool first =
        a < root - pad && proved_first_collapse(motion, q, a, root - pad, root + pad);
    tally.first += first;
    if (first) {
      ASSERT_FALSE(disks.at(q, root - pad).illegal);
      ASSERT_TRUE(disks.at(q, root + pad).illegal);
      ASSERT_FALSE(proved_first_collapse(motion, q, a, root + pad, root + 3 * pad));
      ASSERT_FALSE(proved_first_collapse(motion, q, a, root - 3 * pad, root - pad));
    }
    // Of what comes later no bracket is the first.
    for (auto later = bad; later != times.end(); ++later) {
      ASSERT_FALSE(*later - pad > root &&
                   proved_first_collapse(motion, q, a, *later - pad, *later + pad));
    }
  }
}

TEST(EdgeProof, NoCollapseIsLost) {
  Tally of;
  prove_edges(1500, 1, of);
  EXPECT_GT(of.proved, 500);
  EXPECT_GT(of.with_roots, 50);
  EXPECT_GT(of.collapsing, 50);
  EXPECT_GT(of.collapses, 50);
  EXPECT_GT(of.first, of.collapses * 8 / 10);
  EXPECT_GT(of.one_root, 50);
  EXPECT_GT(of.proved_of_one, 30);
  EXPECT_LT(of.proved_of_one, of.one_root);
  std::cout << of.proved << " proved free, " << of.with_roots << " of them with roots; "
            << of.collapsing << " collapse, " << of.collapses << " of them proved, " << of.first
            << " to be the first; " << of.one_root << " with one root at most, " << of.proved_of_one
            << " of them free\n";
}

// Where polynomials of degree eight in the lengths overflow and underflow, in part or all.
TEST(EdgeProof, NoCollapseIsLostAtTheEndsOfTheRange) {
  for (const int exponent : {-330, -130, -120, 112, 116, 120, 124, 128, 132, 160, 240, 320}) {
    SCOPED_TRACE(exponent);
    Tally of;
    prove_edges(200, std::ldexp(1.0, exponent), of);
    if (HasFatalFailure()) return;
    EXPECT_GT(of.collapsing, 10);
  }
}

// Disks that cross each other, and the container's edge.
TEST(EdgeProof, GeneratorsAreSeparatedWhereThatIsSaid) {
  Random random(11);
  int truly = 0, said = 0;
  for (int k = 0; k < 4000; ++k) {
    const FourDisks disks(k % 3 == 0 ? 200 : k % 3 == 1 ? 60 : 6, k % 5 == 0, random);
    const double a = uniform(random, -40, 40);
    const double b = a + std::ldexp(uniform(random, 1, 2), static_cast<int>(random() % 12) - 6);
    const bool separated = disks.separated(a, b);
    truly += separated;
    const ComputedMotion motion(disks.input(), {});
    bool all = true;
    // Each pair at least once.
    for (const Quad& q : {Quad{0, 1, 2, 3}, {0, 1, 2, container_id}, {container_id, 3, 0, 1}}) {
      all = all && are_separated(motion, q, a, b);
    }
    ASSERT_TRUE(separated || !all) << k << " in [" << a << ", " << b << "]";
    said += all;
  }
  EXPECT_GT(truly, 400);
  EXPECT_LT(truly, 3600);
  EXPECT_GT(said, truly * 8 / 10);
}

// The signs of both circles side by side, at instants, are those in rationals.
TEST(EdgeProof, CirclesSideBySide) {
  Random random(9);
  int known = 0, asked = 0;
  for (int k = 0; k < 400; ++k) {
    const FourDisks disks(k % 2 == 0 ? 40 : 4, k % 5 == 0, random);
    std::array<GenId, 4> ids{0, 1, 2, k % 3 == 0 ? container_id : 3};
    std::shuffle(ids.begin(), ids.end(), random);
    const Quad q{ids[0], ids[1], ids[2], ids[3]};
    const double t = uniform(random, 0, 20);
    const auto [f, truth] = disks.signs(q, t);
    const ComputedMotion motion(disks.input(), {});
    const EdgeCircles circles(motion, q, DoubleBall(t));
    const auto same = [&](Sign found, Sign expected) {
      ++asked;
      known += found != Sign::unknown;
      return found == Sign::unknown || found == expected;
    };
    ASSERT_TRUE(same(circles.start_exists(), truth.start_exists));
    ASSERT_TRUE(same(circles.end_exists(), truth.end_exists));
    if (truth.start_exists == Sign::positive) {
      ASSERT_TRUE(same(circles.end_in_start(f), truth.end_in_start));
    }
    if (truth.end_exists == Sign::positive) {
      ASSERT_TRUE(same(circles.start_in_end(f), truth.start_in_end));
    }
  }
  EXPECT_GT(known, asked * 9 / 10);
}

// Pairs four at a time: what is proved is true on a grid of times, and one by one hardly more is
// proved. Disks that overlap at first are not asked about.
TEST(ContactProof, ManyPairsAtOnce) {
  Random random(10);
  int proved = 0, made = 0, touching = 0;
  for (int k = 0; k < 400; ++k) {
    const FourDisks disks(k % 2 == 0 ? 40 : 4, k % 5 == 0, random);
    const ComputedMotion motion(disks.input(), {});
    const double a = uniform(random, 0, 20), b = a + uniform(random, 0, 40);
    ApartBatch batch(motion);
    std::vector<std::array<GenId, 2>> pairs;
    for (GenId i = container_id; i < 4; ++i) {
      for (GenId j = std::max(i + 1, 0); j < 4; ++j) {
        if (!disks.apart(i, j, a)) continue;
        pairs.push_back({i, j});
        batch.add(i, j, a);
      }
    }
    batch.prove(b);
    for (std::size_t n = 0; n < pairs.size(); ++n) {
      const auto [i, j] = pairs[n];
      ++made;
      bool apart = true;
      for (int part = 0; part <= 64; ++part) {
        apart = apart && disks.apart(i, j, part == 64 ? b : a + (b - a) * part / 64);
      }
      touching += !apart;
      ASSERT_TRUE(apart || !proved_apart(motion, i, j, a, b)) << i << ", " << j;
      if (!batch.apart(n)) continue;
      ++proved;
      ASSERT_TRUE(apart) << i << " and " << j << " in [" << a << ", " << b << "]";
      ASSERT_TRUE(proved_apart(motion, i, j, a, b));
    }
  }
  EXPECT_GT(touching, 40);
  EXPECT_GT(proved, (made - touching) * 9 / 10);
}

TEST(EdgeProof, IllegalEdges) {
  Random random(11);
  int illegal = 0, legal = 0;
  for (int k = 0; k < 300; ++k) {
    const FourDisks disks(10, k % 2 == 0, random);
    const ComputedMotion motion(disks.input(), {});
    const double t = uniform(random, 0, 10);
    for (const Quad& q : {Quad{0, 1, 2, 3}, Quad{0, 2, 1, 3}, Quad{container_id, 1, 2, 3}}) {
      const auto [f, signs] = disks.signs(q, t);
      const bool expected =
          signs.end_in_start == Sign::negative && signs.start_in_end == Sign::negative;
      const bool proved = proved_illegal(motion, q, to_rational(t));
      EXPECT_TRUE(expected || !proved);
      if (!disks.separated(t, t)) continue;
      EXPECT_EQ(proved, expected);
      ++(expected ? illegal : legal);
    }
  }
  EXPECT_GT(illegal, 20);
  EXPECT_GT(legal, 20);
}

}  // namespace
}  // namespace voroproof::internal::testing
