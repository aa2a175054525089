// The sweep against the definition, applied to every pair.
#include "history/placement.h"
#include "tests/support/compact_arithmetic.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <vector>

namespace voroproof::internal {
namespace {

DiskInput disk(const Rational& x, const Rational& y, const Rational& r) {
  return {x, y, r, 0, 0, 1};
}

Scene scene_of(std::vector<DiskInput> disks, const Rational& radius = 1000) {
  Scene scene;
  scene.container_radius = radius;
  scene.disks = std::move(disks);
  return scene;
}

bool overlap(const DiskInput& a, const DiskInput& b) {
  const Rational dx = a.x - b.x, dy = a.y - b.y, reach = a.radius + b.radius;
  const Rational gap = dx * dx + dy * dy - reach * reach;
  return gap < 0 || (dx == 0 && dy == 0);
}

bool any_overlap(const std::vector<DiskInput>& disks) {
  for (std::size_t i = 0; i < disks.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (overlap(disks[i], disks[j])) return true;
  return false;
}

// Small integers make touching disks, equal heights and equal abscissas common; the unit is either
// a binary64, so that the keys decide alone, or not, so that they do not.
RC_GTEST_PROP(Placement, FindsAnOverlapIfThereIsOne, ()) {
  const Rational unit = *rc::gen::element(Rational(1), Rational(1, 3), Rational(1, 1024));
  const Rational offset =
      *rc::gen::element(Rational(0), Rational(1, 7), Rational("123456789/1000"));
  const int range = *rc::gen::element(3, 8, 20);
  std::vector<DiskInput> disks;
  const int tries = *rc::gen::inRange(0, 60);
  const bool allow_one = *rc::gen::arbitrary<bool>();
  for (int k = 0; k < tries; ++k) {
    const DiskInput d =
        disk(offset + unit * *rc::gen::inRange(-range, range + 1),
             offset + unit * *rc::gen::inRange(-range, range + 1), unit * *rc::gen::inRange(0, 5));
    // Mostly disjoint sets, for in others every fault is found at once.
    bool clash = false;
    for (const DiskInput& other : disks) clash = clash || overlap(d, other);
    if (!clash || (allow_one && k + 1 == tries)) disks.push_back(d);
  }
  const bool expected = any_overlap(disks);
  const auto fault = find_placement_fault(scene_of(disks, 1'000'000));
  RC_CLASSIFY(expected, "overlap");
  RC_ASSERT(fault.has_value() == expected);
  if (fault) {
    bool to_blame = false;
    for (int j = 0; j < fault->disk; ++j)
      to_blame = to_blame || overlap(disks[j], disks[fault->disk]);
    RC_ASSERT(to_blame);
  }
}

// The last bit decides: two disks at a distance given to 300 digits.
TEST(Placement, DecidesExactly) {
  Rational tiny = 1;
  for (int i = 0; i < 300; ++i) tiny /= 10;
  const Rational third(1, 3);
  const auto pair = [&](const Rational& x) {
    return find_placement_fault(scene_of({disk(third, third, third), disk(x, third, third)}));
  };
  EXPECT_FALSE(pair(1));
  EXPECT_FALSE(pair(1 + tiny));
  ASSERT_TRUE(pair(1 - tiny));
  EXPECT_EQ(pair(1 - tiny)->disk, 1);
  EXPECT_EQ(pair(1 - tiny)->reason, "overlaps disks[0] by 1e-300");
}

TEST(Placement, Container) {
  const auto alone = [](DiskInput d, const Rational& vx, const Rational& vy) -> std::string {
    d.vx = vx;
    d.vy = vy;
    Scene scene = scene_of({d}, 10);
    scene.cx = 1;
    scene.cy = Rational(1, 3);
    d.x += scene.cx;
    d.y += scene.cy;
    scene.disks = {d};
    const auto fault = find_placement_fault(scene);
    return fault ? fault->reason : "";
  };
  const DiskInput touching = disk(3, 4, 5), inside = disk(3, 4, Rational(49, 10));
  EXPECT_EQ(alone(inside, -4, 3), "");
  EXPECT_EQ(alone(touching, 0, 0), "");
  EXPECT_EQ(alone(touching, 3, 4), "");
  EXPECT_EQ(alone(touching, -1, 0), "");
  EXPECT_EQ(alone(touching, -4, 3), "touches the container with a tangential velocity");
  EXPECT_EQ(alone(touching, 4, -3), "touches the container with a tangential velocity");
  EXPECT_EQ(alone(disk(3, 4, Rational("5000000000000000000001/1000000000000000000000")), 0, 0),
            "not inside the container, by 1e-21");
  EXPECT_EQ(alone(disk(30, 0, 1), 0, 0), "not inside the container, by 21");
  EXPECT_EQ(alone(disk(0, 0, 10), 0, 0), "not smaller than the container");
  EXPECT_EQ(alone(disk(0, 0, 40), 0, 0), "not smaller than the container");
  EXPECT_EQ(alone(disk(10, 0, 0), 0, 0), "");
}

TEST(Placement, Points) {
  const auto fault =
      find_placement_fault(scene_of({disk(1, 1, 0), disk(2, 1, 1), disk(3, 1, 0), disk(1, 1, 0)}));
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->disk, 3);
  EXPECT_EQ(fault->reason, "coincides with disks[0]");
  EXPECT_FALSE(find_placement_fault(scene_of({disk(1, 1, 0), disk(2, 1, 1), disk(3, 1, 0)})));
  EXPECT_TRUE(find_placement_fault(scene_of({disk(2, Rational(1, 3), 0), disk(2, 1, 1)})));
}

// One disk beside very many tiny ones, rows of touching disks, columns of equal abscissas: the
// sweep must not fall into comparing all pairs.
TEST(Placement, UnevenScenes) {
  std::vector<DiskInput> disks = {disk(0, 0, 900)};
  for (int i = 0; i < 300; ++i)
    for (int k = 0; k < 100; ++k)
      disks.push_back(disk(Rational(i, 8), 901 + k * Rational(1, 8), Rational(1, 16)));
  EXPECT_FALSE(find_placement_fault(scene_of(disks, 5000)));
  disks.push_back(disk(Rational(1, 16), 901 + Rational(1, 16), Rational(1, 10)));
  const auto fault = find_placement_fault(scene_of(disks, 5000));
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->disk, 30001);
}

}  // namespace
}  // namespace voroproof::internal
