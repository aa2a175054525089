// Histories of scenes full of ties correspond to those of their images and of their parts:
// formation flights, small lattices, and these made symmetric. RC_PARAMS="max_success=1000" looks
// further.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "corpus/generate.h"
#include "tests/support/correspondence.h"
#include "tests/support/formation_scene.h"
#include "tests/support/history_check.h"
#include "tests/support/lattice_scene.h"

namespace voroproof::internal::testing {
namespace {

// As in engine_lattice_test.cpp: where collisions come before ties, a run may stop.
RecordedRun run_with_small_budget(const Scene& scene) {
  MotionOptions small_budget;
  small_budget.max_bits = 1024;
  return run(scene, small_budget);
}

bool compared(const RecordedRun& a, const RecordedRun& b) {
  const bool both = a.complete() && b.complete();
  RC_CLASSIFY(!both, "undecided");
  RC_CLASSIFY(both && a.count(Event::Kind::collision) > 0, "collisions");
  RC_CLASSIFY(both && a.stats.ties > 0, "ties");
  return both;
}

void expect_image(const Scene& scene, const Image& image) {
  const RecordedRun original = run_with_small_budget(scene);
  const RecordedRun other = run_with_small_budget(image_of(scene, image));
  if (!compared(original, other)) return;
  if (!image.ids.empty() && shares_a_disk_at_an_instant(original)) {
    RC_TAG("the order of ids matters");
    return;
  }
  RC_ASSERT(difference_from_image(scene, original, image, other) == std::string());
}

Scene up_to(Scene scene, const Rational& t) {
  scene.horizon = t;
  return scene;
}

void expect_parts(const Scene& scene, const Rational& t) {
  const RecordedRun whole = run_with_small_budget(scene);
  if (!whole.complete()) return;
  const RecordedRun beginning = run_with_small_budget(up_to(scene, t));
  RC_ASSERT(beginning.complete());
  const auto rest = rest_of(scene, whole, t);
  RC_CLASSIFY(!rest, "irrational");
  std::optional<RecordedRun> end;
  if (rest) end = run_with_small_budget(*rest);
  if (end && !compared(whole, *end)) end.reset();
  RC_ASSERT(difference_from_parts(scene, whole, t, beginning, end ? &*end : nullptr) ==
            std::string());
}

// (x, y) -> ((3, -4), (4, 3)) (x, y) / 5, and larger, elsewhere and in another tempo.
Image turned() {
  Image image;
  image.xx = image.yy = Rational(3, 5);
  image.xy = Rational(-4, 5);
  image.yx = Rational(4, 5);
  return image;
}
Image scaled() {
  Image image;
  image.xx = image.yy = image.length = Rational(7, 3);
  image.dx = Rational(1000, 7);
  image.dy = -17;
  image.time = Rational(5, 4);
  return image;
}
Image mirrored() {
  Image image;
  image.xx = -1;
  return image;
}
Image permuted(const Scene& scene) {
  Image image;
  image.ids.resize(scene.disks.size());
  std::iota(image.ids.begin(), image.ids.end(), 0);
  // A random order: sorted by random keys, which shrink to those that keep it.
  const auto keys =
      *rc::gen::container<std::vector<int>>(scene.disks.size(), rc::gen::arbitrary<int>());
  std::stable_sort(image.ids.begin(), image.ids.end(), [&](int i, int j) {
    return keys[static_cast<std::size_t>(i)] < keys[static_cast<std::size_t>(j)];
  });
  return image;
}
// A binary64, and often an instant of maneuvers.
Rational instant_of(const Scene& scene) {
  Rational part(*rc::gen::inRange(0, 65), 64);
  part.canonicalize();
  return scene.horizon * part;
}

// ---- The families. ----

Scene formation() { return scene_of(*formation_scenes(9)); }

Scene lattice() {
  LatticeFamily family;
  family.max_radius = 2;
  const Scene scene = scene_of(*lattice_scenes(family));
  RC_PRE(scene.disks.size() >= 2u);
  return scene;
}

// Each disk of a small lattice with its images under a half or quarter turns, or the reflections
// in both axes.
Scene symmetric() {
  LatticeFamily family;
  family.max_radius = 2;
  LatticeScene lattice = *lattice_scenes(family);
  if (lattice.disks.size() > 2) lattice.disks.resize(2);
  const int kind = *rc::gen::inRange(0, 3);
  LatticeScene all = lattice;
  all.disks.clear();
  for (LatticeDisk d : lattice.disks) {
    const int images = kind == 0 ? 2 : 4;
    for (int k = 0; k < images; ++k) {
      all.disks.push_back(d);
      if (kind == 0) {
        d = {-d.x, -d.y, d.radius, -d.vx, -d.vy};
      } else if (kind == 1) {
        d = {-d.y, d.x, d.radius, -d.vy, d.vx};
      } else if (k % 2 == 0) {
        d = {-d.x, d.y, d.radius, -d.vx, d.vy};
      } else {
        d = {d.x, -d.y, d.radius, d.vx, -d.vy};
      }
    }
  }
  Scene scene = scene_of(all);
  RC_PRE(scene.disks.size() >= 2u);
  scene.horizon = 3;
  return scene;
}

RC_GTEST_PROP(Formation, IsRight, ()) {
  const Scene scene = formation();
  const RecordedRun history = run(scene);
  RC_ASSERT(check_history(scene, history) == std::string());
  RC_ASSERT(history.count(Event::Kind::collision) == 0u);
  RC_CLASSIFY(history.stats.ties > 0, "ties");
}
// The instant began with a flip, and was then sought as a root of what the flip's generators no
// longer did.
TEST(Formation, FlipsAtTheInstantOfManeuvers) {
  const Scene scene = scene_of(FormationScene{9, {"staggered", "y"}});
  EXPECT_EQ(check_history(scene, run(scene)), "");
}
// Three disks that end in a row have no tangent circle, only lines.
TEST(Formation, EndsInARow) {
  const Scene scene = scene_of(FormationScene{3, {"y", "turn", "turn", "h"}});
  EXPECT_EQ(check_history(scene, run(scene)), "");
}
RC_GTEST_PROP(Formation, Turned, ()) { expect_image(formation(), turned()); }
RC_GTEST_PROP(Formation, Scaled, ()) { expect_image(formation(), scaled()); }
RC_GTEST_PROP(Formation, Mirrored, ()) { expect_image(formation(), mirrored()); }
RC_GTEST_PROP(Formation, Permuted, ()) {
  const Scene scene = formation();
  expect_image(scene, permuted(scene));
}
RC_GTEST_PROP(Formation, InTwoParts, ()) {
  const Scene scene = formation();
  expect_parts(scene, instant_of(scene));
}

// Larger ones: each, and each of its steps, begins and ends at an instant of many ties.
TEST(Formation, OfThePaper) {
  for (const std::string name : {"figure24", "h-to-y", "segments58"}) {
    const Scene scene = generate_formation(formation_preset(name));
    const RecordedRun whole = run(scene);
    ASSERT_TRUE(whole.complete()) << name;
    for (const Image& image : {turned(), mirrored()})
      EXPECT_EQ(difference_from_image(scene, whole, image, run(image_of(scene, image))), "")
          << name;
    for (const Rational& t : {Rational(16), Rational(41, 2)}) {
      const auto rest = rest_of(scene, whole, t);
      ASSERT_TRUE(rest);
      const RecordedRun end = run(*rest);
      EXPECT_EQ(difference_from_parts(scene, whole, t, run(up_to(scene, t)), &end), "") << name;
    }
  }
}

RC_GTEST_PROP(Lattice, Turned, ()) { expect_image(lattice(), turned()); }
RC_GTEST_PROP(Lattice, Scaled, ()) { expect_image(lattice(), scaled()); }
RC_GTEST_PROP(Lattice, Mirrored, ()) { expect_image(lattice(), mirrored()); }
RC_GTEST_PROP(Lattice, Permuted, ()) {
  const Scene scene = lattice();
  expect_image(scene, permuted(scene));
}
RC_GTEST_PROP(Lattice, InTwoParts, ()) {
  const Scene scene = lattice();
  expect_parts(scene, instant_of(scene));
}

RC_GTEST_PROP(Symmetric, Turned, ()) { expect_image(symmetric(), turned()); }
RC_GTEST_PROP(Symmetric, Mirrored, ()) { expect_image(symmetric(), mirrored()); }
RC_GTEST_PROP(Symmetric, Permuted, ()) {
  const Scene scene = symmetric();
  expect_image(scene, permuted(scene));
}
RC_GTEST_PROP(Symmetric, InTwoParts, ()) {
  const Scene scene = symmetric();
  expect_parts(scene, instant_of(scene));
}

}  // namespace
}  // namespace voroproof::internal::testing
