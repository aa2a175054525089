// The certified prefix: nothing is missing before its time, whatever ended the certifier's work.
#include <gtest/gtest.h>

#include <variant>

#include "tests/certify/claimed_history.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
namespace {

constexpr std::array truths{Truth::exact, Truth::recorded};

// Disks, and far above them two points that meet at t = 5: the motion has no continuation.
Scene with_meeting_points(std::uint64_t seed) {
  Random random(seed);
  Scene scene = scene_of(100, 10, {disk(-40, 90, 0, 8, 0), disk(40, 90, 0, -8, 0)});
  for (DiskInput& d : scene.disks) d.mass = 1;
  for (int k = 0; k < 12; ++k) {
    const double x = -45 + 30 * (k % 4), y = -60 + 40 * (k / 4);
    scene.disks.push_back(disk(x + uniform(random, -8, 8), y + uniform(random, -8, 8),
                               uniform(random, 1, 4), uniform(random, -2, 2),
                               uniform(random, -2, 2)));
  }
  return scene;
}

// The history without its k-th event, where that is a flip.
std::optional<ClaimedHistory> without(const ClaimedHistory& history, std::size_t k) {
  if (!std::holds_alternative<FlipEvent>(history.events[k])) return std::nullopt;
  ClaimedHistory wrong = history;
  wrong.events.erase(wrong.events.begin() + static_cast<std::ptrdiff_t>(k));
  wrong.count();
  return wrong;
}

TEST(Prefix, EndsBeforeWhatIsMissingWhereAClaimIsUndecided) {
  int undecided = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Scene scene = with_meeting_points(seed);
    Scene shorter = scene;
    shorter.horizon = Rational(49, 10);
    ClaimedHistory right = claimed_history(shorter, run(shorter));
    right.header.horizon = scene.horizon;
    for (std::size_t k = 0; k < right.events.size(); ++k) {
      const auto wrong = without(right, k);
      if (!wrong) continue;
      for (const Truth truth : truths) {
        CertifyOptions options;
        options.truth = truth;
        options.motion.max_bits = 1024;  // what the points' edges do at t = 5 takes all there are
        const Certificate c = certify(scene, *wrong, options);
        EXPECT_NE(c.verdict, Verdict::certified);
        EXPECT_LE(c.prefix_t, time(right.events[k])) << "seed " << seed;
        EXPECT_LE(c.prefix_events, k) << "seed " << seed;
        undecided += c.verdict == Verdict::undecided;
      }
    }
  }
  EXPECT_GT(undecided, 10);
}

TEST(Prefix, EndsBeforeWhatIsMissingWhereTheRunIsInterrupted) {
  Random random(7);
  const Scene scene = random_scene({.n = 100, .horizon = 10}, random);
  const ClaimedHistory right = claimed_history(scene, run(scene));
  int interrupted = 0;
  for (std::size_t k = 180; k < 256; ++k) {
    const auto wrong = without(right, k);
    if (!wrong) continue;
    for (const Truth truth : truths) {
      CertifyOptions options;
      options.truth = truth;
      options.monitor = [](double, std::int64_t events) { return events < 256; };
      try {
        certify(scene, *wrong, options);
      } catch (const CertificationInterrupted& c) {
        EXPECT_LE(c.prefix_t, time(right.events[k]));
        EXPECT_LE(c.prefix_events, k);
        ++interrupted;
      }
    }
  }
  EXPECT_GT(interrupted, 10);
}

}  // namespace
}  // namespace voroproof::internal::testing
