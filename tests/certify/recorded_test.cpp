// The recorded truth where it is most easily deceived.
#include <gtest/gtest.h>

#include "certify/report.h"
#include "tests/certify/claimed_history.h"

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

}  // namespace
}  // namespace voroproof::testing
