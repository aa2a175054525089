// Runs that their monitor stops: between events and within a long decision.
#include <gtest/gtest.h>

#include <vector>

#include "certify/report.h"
#include "corpus/generate.h"
#include "library/maneuver_input.h"
#include "tests/certify/claimed_history.h"

namespace voroproof::internal::testing {
namespace {

// Ties after collisions, which take exact arithmetic.
Scene scene_with_long_decisions() {
  GridOptions options;
  options.n = 49;
  options.motion = GridOptions::Motion::shear;
  options.spacing = 2.5;
  options.horizon = 60;
  return generate_grid(options);
}

// Runs until the call numbered `last`; notes how many events there were at each.
RecordedRun run_until(const Scene& scene, std::size_t last, std::vector<std::uint64_t>& calls) {
  return run(scene, {}, [&](double, std::uint64_t events) {
    calls.push_back(events);
    return calls.size() != last;
  });
}

TEST(EngineInterruption, WithinALongDecision) {
  const Scene scene = scene_with_long_decisions();
  std::vector<std::uint64_t> calls;
  const RecordedRun whole = run_until(scene, 0, calls);
  ASSERT_TRUE(whole.complete());
  // The calls before which no event has come since the monitor was asked, and none comes until it
  // is asked again.
  std::vector<std::size_t> within;
  for (std::size_t k = 1; k + 1 < calls.size(); ++k) {
    if (calls[k - 1] == calls[k] && calls[k] == calls[k + 1] && calls[k] > 0) within.push_back(k);
  }
  ASSERT_GT(within.size(), 3u);
  for (const std::size_t k : {within.front(), within[within.size() / 2], within.back()}) {
    std::vector<std::uint64_t> until;
    const RecordedRun part = run_until(scene, k + 1, until);
    EXPECT_EQ(part.outcome.kind, Outcome::Kind::interrupted);
    EXPECT_EQ(until.size(), k + 1);
    ASSERT_EQ(part.events.size(), calls[k]);
    EXPECT_EQ(part.begins, 1);
    EXPECT_EQ(part.outcome.t, part.events.back().t);
    for (std::size_t e = 0; e < part.events.size(); ++e) {
      EXPECT_EQ(text(part.events[e]), text(whole.events[e]));
    }
  }
}

// Numbers that grow by some hundred digits a collision, and stay rational.
Scene scene_with_long_rationals() {
  const Rational heavy = *parse_rational("1e90"), light = *parse_rational("1e-90");
  return scene_of(100, 100, {disk(0, 0, 1, 1, 0, heavy), disk(5, 0, 1, -1, 0, light)});
}

TEST(EngineInterruption, WithinArithmeticOfRationals) {
  const Scene scene = scene_with_long_rationals();
  std::vector<std::uint64_t> calls;
  const RecordedRun part = run_until(scene, 50, calls);
  EXPECT_EQ(part.outcome.kind, Outcome::Kind::interrupted);
  EXPECT_EQ(calls.size(), 50u);
}

// Without a budget this takes longer than anyone waits for.
TEST(EngineInterruption, RationalsHaveABudget) {
  MotionOptions options;
  options.max_bits = 4096;
  const RecordedRun stopped = run(scene_with_long_rationals(), options);
  EXPECT_EQ(stopped.outcome.kind, Outcome::Kind::stopped);
}

TEST(CertifierInterruption, WithinALongDecision) {
  const Scene scene = scene_with_long_decisions();
  const ClaimedHistory history = claimed_history(scene, run(scene));
  std::vector<std::int64_t> calls;
  CertifyOptions options;
  options.monitor = [&](double, std::int64_t events) {
    calls.push_back(events);
    return calls.size() < 3 || calls[calls.size() - 2] != events || events == 0;
  };
  EXPECT_THROW(certify(scene, history, options), CertificationInterrupted);
  EXPECT_LT(calls.back(), static_cast<std::int64_t>(history.events.size()));
}

}  // namespace
}  // namespace voroproof::internal::testing
