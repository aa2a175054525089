// The certifier of the recorded truth, linked without anything that computes a motion.
#include <gtest/gtest.h>

#include <string>

#include "certify/recorded_certifier.h"
#include "history/claim.h"

namespace voroproof::internal {
namespace {

Verdict verdict(const std::string& history, EventKinds events) {
  const std::string folder = VOROPROOF_CASES "/symmetry/half-turn-08/";
  const Claim claim = open_claim(folder + "scene.scene.json", folder + history);
  CertifyOptions options;
  options.truth = Truth::recorded;
  options.events = events;
  return certify_recorded(claim.scene, *claim.history, options).verdict;
}

TEST(RecordedAlone, TellsRightFromWrong) {
  for (const EventKinds events : {EventKinds::all, EventKinds::collisions}) {
    EXPECT_EQ(verdict("exact.history.jsonl", events), Verdict::certified);
    EXPECT_EQ(verdict("wrong/second-collision-dropped.history.jsonl", events), Verdict::refuted);
  }
}

}  // namespace
}  // namespace voroproof::internal
