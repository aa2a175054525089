// Billiards and their histories as text, for tests.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "certify/billiards/billiard_certifier.h"
#include "tests/history/temporary_directory.h"

namespace voroproof::internal::testing {

struct BilliardCase {
  std::string members;  // of the scene: "frame" and what else it has besides the horizon
  std::string horizon;  // as in the file
  std::vector<std::string> events;  // lines
  int collisions = 0, maneuvers = 0;
  Rational tolerance{1, 1000000};
  std::string last{};  // the last line, where it is not that of a history that ends
  Truth truth = Truth::recorded;
  int threads = 1;

  std::string scene() const {
    return R"({"format":"voroproof-scene","version":2,"contacts":"bounce","horizon":)" + horizon +
           "," + members + "}";
  }

  Certificate judge() const {
    const TemporaryDirectory folder;
    const std::string scene_file = folder.write("a.scene.json", scene());
    const Billiard billiard = read_billiard(scene_file);
    std::string text = R"({"format":"voroproof-history","version":2,"scene_sha256":")" +
                       billiard.sha256 + R"(","horizon":)" + horizon + R"(,"producer":"test"})" +
                       "\n";
    for (const std::string& event : events) text += event + "\n";
    const std::string end = R"({"end":{"t":)" + horizon + R"(,"collisions":)" +
                            std::to_string(collisions) + R"(,"maneuvers":)" +
                            std::to_string(maneuvers) + "}}";
    text += (last.empty() ? end : last) + "\n";
    BilliardHistoryReader history(folder.write("a.history.jsonl", text), &billiard);
    CertifyOptions options;
    options.truth = truth;
    options.motion.max_bits = 2048;
    options.tolerance = tolerance;
    options.threads = threads;
    return certify_billiard(billiard, scene_file, history, options);
  }
};

// Disk 0 hits disk 1 at rest, at t = 2.
inline BilliardCase head_on() {
  return {R"("frame":"none","disks":[
    {"center":[0,0],"radius":1,"velocity":[1,0]},
    {"center":[4,0],"radius":1,"velocity":[0,0]}])",
          "5",
          {R"({"t":2,"collide":[0,1],"v":[[0,0],[1,0]],"p":[[2,0],[4,0]]})"},
          1};
}

inline void expect_certified(const BilliardCase& c) {
  const Certificate certificate = c.judge();
  EXPECT_EQ(certificate.verdict, Verdict::certified)
      << (certificate.divergence ? certificate.divergence->truth : certificate.reason);
}

inline void expect_refuted(const BilliardCase& c, Fault fault, std::int64_t line) {
  const Certificate certificate = c.judge();
  ASSERT_EQ(certificate.verdict, Verdict::refuted) << certificate.reason;
  EXPECT_EQ(fault_names[static_cast<int>(certificate.divergence->fault)],
            fault_names[static_cast<int>(fault)])
      << certificate.divergence->truth;
  EXPECT_EQ(certificate.divergence->line, line) << certificate.divergence->truth;
}

}  // namespace voroproof::internal::testing
