// The certified prefix: nothing is missing before its time, whatever ended the certifier's work.
#include <gtest/gtest.h>

#include <variant>

#include "certify/report.h"
#include "tests/certify/handmade_history.h"
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
  EXPECT_GT(undecided, 5);
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

// Two disks hit the wall, each claimed late by nearly the tolerance, and are so slow behind it that
// they stay in it for longer than that. Which of the two the certifier asks first depends on their
// numbers.
TEST(Prefix, EndsBeforeTheFirstOfSeveralOverlapsThatLastTooLong) {
  for (const GenId first : {0, 1}) {
    Scene scene = scene_of(100, Rational(21, 2), {});
    scene.disks.assign(2, disk(10, 0, 1, 9, 0));
    scene.disks[first] = disk(-19, 0, 1, -10, 0);
    scene.container_restitution = Rational(9, 10);
    const double late = 97e-8;
    const History h =
        history_of(scene, kTwo,
                   {collision(8 + late, container_id, first, std::nullopt, {9, 0}),
                    collision(89. / 9 + late, container_id, 1 - first, std::nullopt, {-8.1, 0})});
    for (const EventKinds events : {EventKinds::all, EventKinds::collisions}) {
      CertifyOptions options;
      options.truth = Truth::recorded;
      options.events = events;
      const Certificate c = certify(scene, h, options);
      ASSERT_EQ(c.verdict, Verdict::refuted) << reason_line(c);
      EXPECT_EQ(c.divergence->fault, Fault::overlap);
      EXPECT_EQ(c.divergence->true_contact, std::pair(container_id, first));
      EXPECT_LE(c.prefix_t, 8);
      EXPECT_EQ(c.prefix_events, 0);
    }
  }
}

// Two small disks pass through each other in less than the tolerance and then hit the wall, all
// unclaimed. Where no boxes of the two meet any more, nothing but that overlap is left of them.
TEST(Prefix, EndsBeforeAnOverlapOfTwoThatAreFarApart) {
  for (int k = 0; k < 40; ++k) {
    const Rational half = 480 + Rational(k, 2);
    Scene scene = scene_of(1000, 30, {disk(-half, 0, 1, 100, 0), disk(half, 0, 1, -100, 0)});
    for (int x = -7; x < 7; ++x) scene.disks.push_back(disk(50 * x, -600, 1, 0, 0));
    CertifyOptions options;
    options.truth = Truth::recorded;
    options.events = EventKinds::collisions;
    options.tolerance = Rational(1, 4);
    const Certificate c = certify(scene, history_of(scene, kTwo, {}), options);
    ASSERT_EQ(c.verdict, Verdict::refuted) << reason_line(c);
    EXPECT_EQ(c.divergence->true_contact, std::pair(0, 1)) << k;
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
