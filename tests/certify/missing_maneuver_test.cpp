// A history that lacks a maneuver is refuted for that, also where its next claims are at the same
// instant and would be judged by the motion without it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "certify/report.h"
#include "tests/certify/claimed_history.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
namespace {

namespace fs = std::filesystem;

// Drops each maneuver in turn, at most `most` of them. How many times.
int expect_each_named(const Scene& scene, const ClaimedHistory& right, const std::string& what,
                      int most) {
  int dropped = 0;
  for (std::size_t k = 0; k < right.events.size() && dropped < most; ++k) {
    const auto* maneuver = std::get_if<ManeuverEvent>(&right.events[k]);
    if (maneuver == nullptr) continue;
    ++dropped;
    ClaimedHistory wrong = right;
    wrong.events.erase(wrong.events.begin() + static_cast<std::ptrdiff_t>(k));
    wrong.count();
    for (const Truth truth : {Truth::exact, Truth::recorded}) {
      CertifyOptions options;
      options.truth = truth;
      const Certificate c = certify(scene, wrong, options);
      const std::string context = what + " event " + std::to_string(k) + ": " + reason_line(c);
      EXPECT_EQ(c.verdict, Verdict::refuted) << context;
      if (c.verdict != Verdict::refuted) continue;
      EXPECT_EQ(c.divergence->fault, Fault::missing_event) << context;
      EXPECT_TRUE(c.divergence->truth.starts_with("disk " + std::to_string(maneuver->disk) +
                                                  " is scheduled for a maneuver"))
          << context;
      EXPECT_EQ(c.divergence->t, maneuver->t) << context;
    }
  }
  return dropped;
}

TEST(MissingManeuver, OfTheDegenerateCases) {
  int dropped = 0;
  for (const auto& entry : fs::recursive_directory_iterator(VOROPROOF_CASES)) {
    if (entry.path().filename() != "exact.history.jsonl") continue;
    const Scene scene = read_scene((entry.path().parent_path() / "scene.scene.json").string());
    if (scene.maneuvers.empty() || scene.disks.size() > 12) continue;
    const auto right = read_claimed_history(entry.path().string(), scene);
    if (right) dropped += expect_each_named(scene, *right, entry.path().string(), 4);
  }
  EXPECT_GT(dropped, 20);
}

// All vehicles of a lattice turn at once, when four of them are cocircular everywhere.
TEST(MissingManeuver, OfManyAtAnInstantOfFlips) {
  Random random(3);
  Scene scene = scene_of(50, 6, {});
  for (int x = -2; x <= 2; ++x) {
    for (int y = -2; y <= 2; ++y) {
      const int disk = static_cast<int>(scene.disks.size());
      const auto speed = [&] { return Rational(static_cast<int>(random() % 7) - 3, 8); };
      scene.disks.push_back({4 * x - 2, 4 * y - 2, 1, 1, 1, 1});
      scene.maneuvers.push_back({2, disk, speed(), speed()});
    }
  }
  const RecordedRun r = run(scene);
  ASSERT_TRUE(r.complete());
  const ClaimedHistory right = claimed_history(scene, r);
  const auto flips = std::count_if(right.events.begin(), right.events.end(), [](const auto& e) {
    return std::holds_alternative<FlipEvent>(e) && time(e) == 2;
  });
  EXPECT_GT(flips, 5);
  EXPECT_EQ(expect_each_named(scene, right, "lattice", 25), 25);
}

}  // namespace
}  // namespace voroproof::internal::testing
