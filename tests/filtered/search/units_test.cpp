// The searches answer the same in every unit of time and length, and wherever the scene lies.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/static_diagram.h"
#include "filtered/computed/computed_motion.h"
#include "filtered/search/collapse.h"
#include "filtered/search/contact.h"
#include "history/scene_motion.h"

namespace voroproof::internal::testing {
namespace {

struct Disk {
  const char *x, *y, *r;
  int vx, vy;
};

// Three disks that are cotangent with the container at 0.
const std::array<std::array<Disk, 3>, 2> ties{{
    {{{"-9/10", "46/5", "3/2", 3, -2}, {"-11/2", "0", "3/2", 1, 0}, {"6", "11", "1", 3, 2}}},
    {{{"-34/5", "-81/10", "3/2", 1, 0},
      {"-9", "0", "1", -3, -1},
      {"227/20", "-49/5", "1/4", -1, 3}}},
}};

Rational power_of_two(int e) {
  const Rational one = 1;
  return e < 0 ? Rational(one >> -e) : Rational(one << e);
}

// The scene with lengths times 2^length, times times 2^time, then moved by (dx, dy).
Scene scene_of(const std::array<Disk, 3>& disks, int length, int time, const Rational& dx = 0,
               const Rational& dy = 0) {
  const Rational l = power_of_two(length), v = power_of_two(length - time);
  Scene scene;
  scene.cx = dx;
  scene.cy = dy;
  scene.container_radius = 16 * l;
  scene.horizon = power_of_two(time);
  for (const Disk& d : disks) {
    const auto number = [&](const char* text) { return Rational(*parse_rational(text) * l); };
    DiskInput disk;
    disk.x = Rational(number(d.x) + dx);
    disk.y = Rational(number(d.y) + dy);
    disk.radius = number(d.r);
    disk.vx = Rational(d.vx * v);
    disk.vy = Rational(d.vy * v);
    disk.mass = 1;
    scene.disks.push_back(disk);
  }
  return scene;
}

// What becomes of each edge that four generators may name, at 0 and until the horizon.
std::vector<Collapse::Kind> answers(const Scene& scene, bool filters) {
  MotionOptions options;
  options.filters = filters;
  ComputedMotion motion(motion_input(scene), options);
  TierCounts counts;
  CollapseSearch search(motion, counts);
  const Moment now = Moment::at(0);
  std::array<GenId, 4> ids{container_id, 0, 1, 2};
  std::vector<Collapse::Kind> kinds;
  do {
    const Quad q{ids[0], ids[1], ids[2], ids[3]};
    kinds.push_back(search.from(q, now, 0x1p-10 * round_up(scene.horizon)).kind);
  } while (std::next_permutation(ids.begin(), ids.end()));
  return kinds;
}

// A tangency of two of the four vanishes as soon after the tie as disks cross the container: within
// 2^-70 in the units in which they are fast.
TEST(CollapseSearch, ATangencyChangesJustAfterATie) {
  for (const auto& disks : ties) {
    for (const bool filters : {true, false}) {
      const auto expected = answers(scene_of(disks, 0, 0), filters);
      EXPECT_NE(std::count(expected.begin(), expected.end(), Collapse::Kind::now), 0);
      for (const int time : {-290, -120, -83, -66, -40, 40, 120, 290}) {
        EXPECT_EQ(answers(scene_of(disks, 0, time), filters), expected) << time;
      }
    }
  }
}

// Two disks and their mirror images stay cotangent. Those of one pair pass through each other
// before the next binary64 after the instant 1 if they are fast: what is meant is the instant.
TEST(CollapseSearch, CotangentForGoodFromAnInstantOn) {
  const auto kinds = [](int speed) {
    const Rational v = power_of_two(speed);
    MotionInput input;
    input.container_radius = 100;
    input.horizon = 2;
    for (const int side : {-1, 1}) {
      input.disks.push_back({Rational(side * (2 + v)), 0, 1, Rational(-side * v), 0, 1});
      input.disks.push_back({Rational(side * 3), 5, 1, 0, 0, 1});
    }
    ComputedMotion motion(input, {});
    TierCounts counts;
    CollapseSearch search(motion, counts);
    Moment now = Moment::at(1);
    now.hi = std::nextafter(1, 2);
    std::array<GenId, 4> ids{0, 1, 2, 3};
    std::vector<Collapse::Kind> found;
    do {
      const Quad q{ids[0], ids[1], ids[2], ids[3]};
      found.push_back(search.from(q, now, now.hi).kind);
    } while (std::next_permutation(ids.begin(), ids.end()));
    return found;
  };
  const auto expected = kinds(-4);
  EXPECT_NE(std::count(expected.begin(), expected.end(), Collapse::Kind::now), 0);
  EXPECT_EQ(kinds(54), expected);
}

TEST(CollapseSearch, AnyUnitOfLength) {
  for (const auto& disks : ties) {
    const auto expected = answers(scene_of(disks, 0, 0), true);
    for (const int length : {-320, -150, -120, 120, 150, 320}) {
      EXPECT_EQ(answers(scene_of(disks, length, 0), true), expected) << length;
      EXPECT_EQ(answers(scene_of(disks, length, length / 2), true), expected) << length;
    }
  }
}

TEST(CollapseSearch, AnyPlace) {
  for (const auto& disks : ties) {
    const auto expected = answers(scene_of(disks, 0, 0), true);
    for (const int far : {20, 60, 100}) {
      const Rational d = power_of_two(far);
      EXPECT_EQ(answers(scene_of(disks, 0, 0, d, Rational(-3 * d)), true), expected) << far;
    }
  }
}

// Places and velocities that leave a motion are those of the scene, however far that is from its
// origin, and no bit of a distance is lost for it.
TEST(Motion, IsAboutTheCentreOfTheContainer) {
  const Rational far = power_of_two(100);
  ComputedMotion near(motion_input(scene_of(ties[0], 0, 0)), {});
  ComputedMotion moved(motion_input(scene_of(ties[0], 0, 0, far, far)), {});
  for (GenId g = container_id; g < 3; ++g) {
    EXPECT_EQ(moved.doubles(g).x, near.doubles(g).x);
    EXPECT_EQ(moved.doubles(g).ex, near.doubles(g).ex);
  }
  const RoundedState a = near.maneuver(1, Rational(1, 2), 1, 0);
  const RoundedState b = moved.maneuver(1, Rational(1, 2), 1, 0);
  EXPECT_EQ(a.px, -5);
  EXPECT_EQ(b.px, round_nearest(Rational(far - 5)));
  EXPECT_EQ(b.py, round_nearest(far));
  EXPECT_EQ(a.vx, b.vx);
}

}  // namespace
}  // namespace voroproof::internal::testing
