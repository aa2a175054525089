// The scenes of corpus/cases/ turned by a rational angle, mirrored, scaled and with ids counted
// backwards, and in two parts: their histories correspond to that of the whole scene, with all its
// ties.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "history/scene.h"
#include "tests/support/correspondence.h"

namespace voroproof::internal::testing {
namespace {

namespace fs = std::filesystem;

// Scenes of more disks or longer histories take long and are like smaller ones.
constexpr std::size_t kDisks = 12, kEvents = 60;

std::vector<std::string> scenes() {
  std::vector<std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(VOROPROOF_CASES)) {
    if (entry.path().filename() == "scene.scene.json") found.push_back(entry.path().string());
  }
  std::sort(found.begin(), found.end());
  return found;
}

// Where a run stops depends on the budget; the cases that are made to stop are left out.
RecordedRun run_with_small_budget(const Scene& scene) {
  MotionOptions small_budget;
  small_budget.max_bits = 1024;
  return run(scene, small_budget);
}

// Recorded times do not tell which side of t such instants are on.
bool has_instants_of_one_binary64(const std::string& path) {
  std::ifstream file(fs::path(path).parent_path() / "case.json");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str().find("one-time-two-instants") != std::string::npos;
}

bool has_points(const Scene& scene) {
  return std::any_of(scene.disks.begin(), scene.disks.end(),
                     [](const DiskInput& d) { return d.radius == 0; });
}

Image linear(const Rational& xx, const Rational& xy, const Rational& yx, const Rational& yy) {
  Image image;
  image.xx = xx;
  image.xy = xy;
  image.yx = yx;
  image.yy = yy;
  return image;
}

std::vector<std::pair<std::string, Image>> images(const Scene& scene, const RecordedRun& whole) {
  std::vector<std::pair<std::string, Image>> all{
      {"turned", linear(Rational(3, 5), Rational(-4, 5), Rational(4, 5), Rational(3, 5))},
      {"mirrored", linear(-1, 0, 0, 1)},
      {"scaled", linear(Rational(7, 3), 0, 0, Rational(7, 3))}};
  all.back().second.length = Rational(7, 3);
  all.back().second.time = Rational(5, 4);
  // The order of simultaneous collisions that share a disk is one of ids. And the brute force that
  // is asked where ids change has nothing to say of points that touch.
  if (!has_points(scene) && !shares_a_disk_at_an_instant(whole)) {
    Image backwards;
    backwards.ids.resize(scene.disks.size());
    std::iota(backwards.ids.rbegin(), backwards.ids.rend(), 0);
    all.emplace_back("backwards", backwards);
  }
  return all;
}

TEST(CorpusCorrespondence, ImagesAndParts) {
  std::size_t compared = 0, continued = 0;
  for (const std::string& path : scenes()) {
    const Scene scene = read_scene(path);
    if (scene.disks.size() > kDisks || has_instants_of_one_binary64(path)) continue;
    const RecordedRun whole = run_with_small_budget(scene);
    if (!whole.complete() || whole.events.size() > kEvents) continue;
    for (const auto& [name, image] : images(scene, whole)) {
      const RecordedRun other = run_with_small_budget(image_of(scene, image));
      ASSERT_TRUE(other.complete()) << path << " " << name;
      EXPECT_EQ(difference_from_image(scene, whole, image, other), "") << path << " " << name;
      ++compared;
    }
    if (scene.restitution != 1 || scene.container_restitution != 1) continue;
    // The second is the instant of the ties of many cases.
    for (const Rational& part : {Rational(3, 8), Rational(1, 2)}) {
      const Rational t = to_rational(Rational(scene.horizon * part).get_d());
      const auto rest = rest_of(scene, whole, t);
      if (!rest) continue;
      Scene first = scene;
      first.horizon = t;
      const RecordedRun end = run_with_small_budget(*rest);
      // No run begins with a point that touches something.
      ASSERT_TRUE(end.complete() || has_points(scene)) << path << " from " << t;
      EXPECT_EQ(difference_from_parts(scene, whole, t, run_with_small_budget(first),
                                      end.complete() ? &end : nullptr),
                "")
          << path << " at " << t;
      ++continued;
    }
  }
  EXPECT_GT(compared, 800u);
  EXPECT_GT(continued, 400u);
}

}  // namespace
}  // namespace voroproof::internal::testing
