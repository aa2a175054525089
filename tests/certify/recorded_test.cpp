// The recorded truth where it is most easily deceived.
#include <gtest/gtest.h>

#include "certify/report.h"
#include "tests/certify/claimed_history.h"
#include "tests/support/random_scenes.h"

namespace voroproof::testing {
namespace {

Certificate certify_recorded(const Scene& scene, const ClaimedHistory& h) {
  CertifyOptions options;
  options.truth = Truth::recorded;
  return certify(scene, h, options);
}

DiskSpec disk(const Rational& x, const Rational& y, const Rational& vx, const Rational& vy) {
  return {x, y, 1, vx, vy, 1};
}

// Two disks side by side, one nearly at rest relative to the other.
struct Creeping {
  Scene scene;
  ClaimedHistory history;
};
Creeping creeping(const Rational& horizon) {
  Creeping c;
  const Rational slow(1, 10'000'000'000);
  c.scene = scene_of(1'000'000, horizon, {disk(0, 0, 0, 1), disk(2 + 10 * slow, 0, -slow, 1)});
  c.history = claimed_history(c.scene, run(c.scene));
  return c;
}

// The law allows a part in 10^9 of the speeds, and so no response at all; the disks may then creep
// into each other as far as they go in the tolerance of time, and no further.
TEST(Recorded, VelocitiesThatDoNotPart) {
  for (const bool responds : {true, false}) {
    for (const int horizon : {100, 100'000}) {
      Creeping c = creeping(horizon);
      ASSERT_EQ(c.history.events.size(), 1u);
      auto& hit = std::get<CollideEvent>(c.history.events[0]);
      if (!responds) std::swap(hit.v[0], hit.v[1]);  // equal masses: as before
      const Certificate result = certify_recorded(c.scene, c.history);
      if (responds || horizon == 100) {
        EXPECT_EQ(result.verdict, Verdict::certified) << reason_line(result);
      } else {
        EXPECT_EQ(result.verdict, Verdict::refuted);
        EXPECT_EQ(result.divergence->fault, Fault::overlap);
      }
    }
  }
}

// Four disks meet in the middle of a square, all at once. Without one of the collisions two of them
// pass through each other, and four generators stay cotangent where nothing decides an edge.
TEST(Refuted, DroppedCollisionAmongFourSymmetricDisks) {
  const Scene scene = scene_of(
      50, 60, {disk(5, 5, -1, -1), disk(-5, 5, 1, -1), disk(-5, -5, 1, 1), disk(5, -5, -1, 1)});
  const ClaimedHistory right = claimed_history(scene, run(scene));
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    CertifyOptions options;
    options.truth = truth;
    EXPECT_EQ(certify(scene, right, options).verdict, Verdict::certified);
    for (int k = 0; k < 4; ++k) {
      ClaimedHistory wrong = right;
      ASSERT_TRUE(std::holds_alternative<CollideEvent>(wrong.events[k]));
      wrong.events.erase(wrong.events.begin() + k);
      wrong.count();
      const Certificate result = certify(scene, wrong, options);
      EXPECT_EQ(result.verdict, Verdict::refuted) << reason_line(result);
    }
  }
}

// Each thread takes the parts as they come; nothing of that is in the certificate.
TEST(Recorded, AnyNumberOfThreads) {
  Random random(11);
  const Scene scene = random_scene({.n = 30, .horizon = 60}, random);
  const ClaimedHistory right = claimed_history(scene, run(scene));
  ASSERT_GT(right.events.size(), 300u);
  ClaimedHistory wrong = right;
  wrong.events.erase(wrong.events.begin() + 200);
  wrong.count();
  for (const ClaimedHistory& history : {right, wrong}) {
    std::string first;
    for (const int threads : {1, 2, 3, 8}) {
      CertifyOptions options;
      options.truth = Truth::recorded;
      options.least_part = 20;
      options.threads = threads;
      const std::string report = report_text({}, options, certify(scene, history, options));
      if (first.empty()) first = report;
      EXPECT_EQ(report, first) << threads << " threads";
    }
  }
}

}  // namespace
}  // namespace voroproof::testing
