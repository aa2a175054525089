// What is proved of an edge over an interval in doubles, against signs in rationals.
#include "certify/edge_proof.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <vector>

#include "certify/edge_signs.h"
#include "tests/support/random_scenes.h"

namespace voroproof::testing {
namespace {

class FourDisks {
 public:
  FourDisks(double largest_radius, bool equal, Random& random) {
    input_.container_radius = 300;
    input_.horizon = 100;
    const auto any = [&](double size) { return Rational(uniform(random, -size, size)); };
    const Rational one(uniform(random, 0, largest_radius));
    for (int k = 0; k < 4; ++k) {
      const Rational radius = equal ? one : Rational(uniform(random, 0, largest_radius));
      input_.disks.push_back({any(100), any(100), radius, any(3), any(3), 1});
    }
  }
  const MotionInput& input() const { return input_; }

  // Whether no two disks overlap at any time of [a, b], and none leaves the container.
  bool apart(double a, double b) const {
    for (int i = 0; i < 4; ++i) {
      const DiskInput& d = input_.disks[i];
      for (const double t : {a, b}) {
        const double x = d.x.get_d() + t * d.vx.get_d(), y = d.y.get_d() + t * d.vy.get_d();
        if (std::hypot(x, y) + d.radius.get_d() > 299) return false;
      }
      for (int j = 0; j < i; ++j) {
        const DiskInput& o = input_.disks[j];
        const double wx = Rational(d.vx - o.vx).get_d(), wy = Rational(d.vy - o.vy).get_d();
        const double dx = Rational(d.x - o.x).get_d(), dy = Rational(d.y - o.y).get_d();
        const double nearest = -(dx * wx + dy * wy) / (wx * wx + wy * wy);
        const double t = std::clamp(nearest, a, b);
        if (std::hypot(dx + t * wx, dy + t * wy) < Rational(d.radius + o.radius).get_d() + 1e-6) {
          return false;
        }
      }
    }
    return true;
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
  Site<Rational> site(GenId g, double t) const {
    if (g == container_id) return {0, 0, Rational(-input_.container_radius)};
    const DiskInput& d = input_.disks[g];
    const Rational s = to_rational(t);
    return {d.x + d.vx * s, d.y + d.vy * s, d.radius};
  }
  MotionInput input_;
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

TEST(EdgeProof, NoCollapseIsLost) {
  Random random(8);
  int proved = 0, with_roots = 0, collapsing = 0, collapses = 0;
  for (int k = 0; k < 1500; ++k) {
    const FourDisks disks(k % 2 == 0 ? 40 : 4, k % 5 == 0, random);
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
    collapsing += bad != times.end();
    const Motion motion(disks.input(), {});
    if (proved_free(motion, q, a, b)) {
      ++proved;
      with_roots += changes > 0;
      ASSERT_EQ(bad, times.end()) << "at " << *bad << " in [" << a << ", " << b << "]";
    }
    if (bad == times.end()) continue;
    // The collapse lies between this time and the one before it in the list.
    const double pad = 1e-7, root = *bad;
    const bool there = proved_collapse(motion, q, root - pad, root + pad);
    collapses += there;
    if (there) {
      ASSERT_FALSE(disks.at(q, root - pad).illegal);
      ASSERT_TRUE(disks.at(q, root + pad).illegal);
    }
  }
  EXPECT_GT(proved, 500);
  EXPECT_GT(with_roots, 50);
  EXPECT_GT(collapsing, 50);
  EXPECT_GT(collapses, 50);
  std::cout << proved << " proved free, " << with_roots << " of them with roots; " << collapsing
            << " collapse, " << collapses << " of them proved\n";
}

}  // namespace
}  // namespace voroproof::testing
