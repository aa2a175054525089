// Which disks may meet, against all pairs of all images.
#include "filtered/billiards/near_boxes.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace voroproof::internal {
namespace {

Billiard box(int dimension, std::array<int, 3> sides, int shear) {
  Billiard billiard;
  billiard.dimension = dimension;
  for (std::size_t k = 0; k < 3; ++k) billiard.lattice.sides[k] = sides[k];
  billiard.lattice.shear = shear;
  return billiard;
}

// The boxes of j at image k, in a window, and of i meet, for certain: by a margin of an eighth.
bool certainly_meet(const Billiard& billiard, const SweptBox& a, const SweptBox& b,
                    const LatticeImage& k, double from, double to) {
  const auto side = [&](std::size_t axis) { return billiard.lattice.sides[axis].get_d(); };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double lo = b.lo[axis] + k[axis] * side(axis), hi = b.hi[axis] + k[axis] * side(axis);
    if (axis == 0) {
      const double drift = k[1] * billiard.lattice.shear.get_d() * side(1);
      lo += std::min(drift * from, drift * to);
      hi += std::max(drift * from, drift * to);
    }
    if (a.lo[axis] > hi - 0.125 || lo > a.hi[axis] - 0.125) return false;
  }
  return true;
}

struct Sample {
  int dimension;
  std::array<int, 3> sides;
  int shear;
  double spread, extent;  // of places, of boxes
  int n;
};

void compare(const Sample& sample, unsigned seed) {
  const Billiard billiard = box(sample.dimension, sample.sides, sample.shear);
  std::mt19937 random(seed);
  const auto uniform = [&](double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(random);
  };
  std::vector<SweptBox> boxes;
  for (int i = 0; i < sample.n; ++i) {
    SweptBox b{};
    for (int k = 0; k < sample.dimension; ++k) {
      b.lo[k] = uniform(-sample.spread, sample.spread);
      // One in eight is as long as many others.
      b.hi[k] = b.lo[k] + uniform(0.25, i % 8 == 0 ? 12 * sample.extent : sample.extent);
    }
    if (sample.dimension == 2) b.hi[2] = 0.25;  // so that the margin is there
    boxes.push_back(b);
  }
  const double from = uniform(0, 3), to = from + uniform(0, 0.5);
  NearBoxes near(billiard);
  const std::vector<BilliardPair> found = near.pairs(boxes, from, to).value();
  const std::set<BilliardPair> pairs(found.begin(), found.end());
  EXPECT_EQ(pairs.size(), found.size());
  constexpr int far = 12;
  const auto range = [&](std::size_t axis) { return sample.sides[axis] == 0 ? 0 : far; };
  int met = 0;
  for (int i = 0; i < sample.n; ++i) {
    for (int j = i + 1; j < sample.n; ++j) {
      for (int x = -4 * range(0); x <= 4 * range(0); ++x) {
        for (int y = -range(1); y <= range(1); ++y) {
          for (int z = -range(2); z <= range(2); ++z) {
            const BilliardPair pair{i, j, {x, y, z}};
            if (!certainly_meet(billiard, boxes[i], boxes[j], pair.image, from, to)) continue;
            ++met;
            ASSERT_TRUE(pairs.count(pair))
                << "seed " << seed << ": " << i << ' ' << j << " at " << x << ' ' << y << ' ' << z;
          }
        }
      }
    }
  }
  EXPECT_GT(met, 0);
  EXPECT_LT(pairs.size(), 4U * static_cast<unsigned>(met) + 64);
}

TEST(NearBoxes, FindsAllPairsOfAllImages) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    compare({2, {0, 0, 0}, 0, 20, 2, 60}, seed);
    compare({3, {0, 0, 0}, 0, 6, 2, 60}, seed);
    compare({2, {8, 0, 0}, 0, 20, 2, 24}, seed);
    compare({2, {8, 7, 0}, 0, 20, 2, 24}, seed);
    compare({2, {3, 4, 0}, 0, 10, 2, 12}, seed);
    compare({2, {8, 7, 0}, 1, 20, 2, 24}, seed);
    compare({2, {4, 3, 0}, -1, 9, 1, 12}, seed);
  }
  for (unsigned seed = 0; seed < 2; ++seed) {
    compare({3, {8, 7, 9}, 0, 20, 3, 12}, seed);
    compare({3, {8, 7, 0}, 1, 20, 3, 12}, seed);
  }
}

// A box across a million cells is to be split, and is not looked at.
TEST(NearBoxes, TooManyImages) {
  const Billiard billiard = box(2, {5, 5, 0}, 0);
  const SweptBox one{{1, 1, 0}, {2, 2, 0}}, other{{0, 0, 0}, {5e6, 1, 0}};
  EXPECT_FALSE(NearBoxes(billiard).pairs({one, other}, 0, 1).has_value());
}

TEST(NearBoxes, FewDisks) {
  const Billiard billiard = box(2, {5, 5, 0}, 0);
  EXPECT_TRUE(NearBoxes(billiard).pairs({}, 0, 1)->empty());
  const SweptBox one{{1, 1, 0}, {2, 2, 0}};
  EXPECT_TRUE(NearBoxes(billiard).pairs({one}, 0, 1)->empty());
  const SweptBox other{{5.5, 1, 0}, {6.5, 2, 0}};
  const auto pairs = NearBoxes(billiard).pairs({one, other}, 0, 1).value();
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(pairs.front(), (BilliardPair{0, 1, {-1, 0, 0}}));
}

}  // namespace
}  // namespace voroproof::internal
