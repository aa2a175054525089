// The check beside the engine sees what is wrong with the events that it is given.
#include "apps/run/self_check.h"

#include <gtest/gtest.h>

#include "certify/report.h"
#include "tests/certify/claimed_history.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {
namespace {

struct Example {
  Scene scene;
  ClaimedHistory history;
};

Example example() {
  Random random(5);
  Example e;
  e.scene = random_scene({.n = 25, .horizon = 30}, random);
  e.history = claimed_history(e.scene, run(e.scene));
  return e;
}

Certificate check(const Example& e) {
  SelfCheck check(e.scene, {});
  check.begin(e.history.header);
  for (const voroproof::internal::Event& event : e.history.events) check.event(event);
  return check.finish(HistoryEnd{});
}

TEST(SelfCheck, ARightRunIsCertified) {
  const Example e = example();
  ASSERT_GT(e.history.events.size(), 50u);
  EXPECT_EQ(check(e).verdict, Verdict::certified);
}

TEST(SelfCheck, AMissingFlipIsSeen) {
  Example e = example();
  const auto it = std::find_if(e.history.events.begin(), e.history.events.end(),
                               [](const auto& x) { return std::holds_alternative<FlipEvent>(x); });
  e.history.events.erase(it);
  const Certificate c = check(e);
  EXPECT_EQ(c.verdict, Verdict::refuted);
  EXPECT_EQ(c.divergence->fault, Fault::missing_event) << reason_line(c);
}

TEST(SelfCheck, WhatIsAbandonedEndsAtOnce) {
  const Example e = example();
  SelfCheck check(e.scene, {});
  check.begin(e.history.header);
  for (int k = 0; k < 5; ++k) check.event(e.history.events[k]);
}

}  // namespace
}  // namespace voroproof::internal::testing
