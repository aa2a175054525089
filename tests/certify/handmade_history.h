// Histories made by hand, and the verdicts that they must get.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <utility>
#include <vector>

#include "certify/report.h"
#include "tests/certify/claimed_history.h"

namespace voroproof::internal::testing {

using History = ClaimedHistory;

// Two disks have one diagram, which never flips.
inline const std::vector<Quad> kTwo{{-1, 0, 1, 1}, {-1, 1, 0, 0}, {0, 1, -1, -1}};

inline History history_of(const Scene& scene, const std::vector<Quad>& initial,
                          std::vector<voroproof::internal::Event> events) {
  History h;
  h.header.horizon = scene.horizon;
  h.header.initial = initial;
  h.events = std::move(events);
  h.count();
  return h;
}

inline CollideEvent collision(double t, GenId i, GenId j, std::optional<Vec2> v_i, Vec2 v_j) {
  return {.t = t, .i = i, .j = j, .v = {v_i, v_j}};
}

inline void expect(Verdict verdict, const Scene& scene, const History& h, Truth truth,
                   CertifyOptions options = {}) {
  options.truth = truth;
  const Certificate c = certify(scene, h, options);
  EXPECT_EQ(c.verdict, verdict) << (truth == Truth::exact ? "exact" : "recorded") << ": "
                                << reason_line(c) << "\n"
                                << text(scene) << text(h);
}

inline void expect_refuted(const Scene& scene, const History& h) {
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    for (const bool strict : {false, true}) {
      CertifyOptions options;
      options.strict = strict;
      expect(Verdict::refuted, scene, h, truth, options);
    }
  }
}

inline void expect_certified(const Scene& scene, const History& h) {
  for (const Truth truth : {Truth::exact, Truth::recorded}) {
    expect(Verdict::certified, scene, h, truth);
  }
}

}  // namespace voroproof::internal::testing
