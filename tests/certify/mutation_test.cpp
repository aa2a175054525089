// Faults must never be certified; what means the same must never be refuted.
#include "tests/certify/mutation.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

#include "certify/report.h"
#include "tests/certify/mutation_scenes.h"

namespace voroproof::internal::testing {
namespace {

CertifyOptions options_for(Truth truth, double tolerance = 1e-6) {
  CertifyOptions o;
  o.truth = truth;
  o.tolerance = to_rational(tolerance);
  return o;
}

TEST(Mutation, RightHistoriesAreCertified) {
  Random random(1);
  for (const Scene& scene : some_scenes(random, 10)) {
    const RecordedRun r = run(scene);
    if (!r.complete()) continue;
    const ClaimedHistory h = claimed_history(scene, r);
    for (const Truth truth : {Truth::exact, Truth::recorded}) {
      CertifyOptions options = options_for(truth);
      options.least_part = 1;
      const Certificate c = certify(scene, h, options);
      EXPECT_EQ(c.verdict, Verdict::certified) << reason_line(c) << "\n"
                                               << text(h) << text(scene) << static_cast<int>(truth);
    }
  }
}

TEST(Mutation, NoFaultIsCertified) {
  // VOROPROOF_MUTANTS asks for more.
  const char* asked = std::getenv("VOROPROOF_MUTANTS");
  const int wanted = asked != nullptr ? std::atoi(asked) : 2000;
  Random random(asked != nullptr ? 77 : 2);
  std::array<int, static_cast<int>(Mutation::count)> made{}, refuted{}, undecided{};
  int total = 0;
  while (total < wanted) {
    for (const Scene& scene : some_scenes(random, 1)) {
      const RecordedRun r = run(scene);
      if (!r.complete()) continue;
      const ClaimedHistory right = claimed_history(scene, r);
      for (int kind = 0; kind < static_cast<int>(Mutation::count); ++kind) {
        for (int attempt = 0; attempt < 3; ++attempt) {
          const double tolerance = 1e-6;
          const Truth truth = attempt == 0 ? Truth::exact : Truth::recorded;
          // The recorded motion is near the true one, by which `right` was written, and no more.
          const double slack = truth == Truth::exact ? 0 : 1e-9;
          const auto wrong =
              mutate(scene, right, static_cast<Mutation>(kind), tolerance, slack, random);
          if (!wrong) continue;
          CertifyOptions options = options_for(truth, tolerance);
          // In parts as small as can be, in the last attempt.
          options.least_part = attempt == 2 ? 1 : 16384;
          const Certificate c = certify(scene, *wrong, options);
          ++made[kind];
          ++total;
          refuted[kind] += c.verdict == Verdict::refuted;
          undecided[kind] += c.verdict == Verdict::undecided;
          EXPECT_NE(c.verdict, Verdict::certified)
              << mutation_names[kind] << " truth " << static_cast<int>(truth) << "\nright:\n"
              << text(right) << "wrong:\n"
              << text(*wrong) << text(scene);
          if (c.verdict == Verdict::certified) return;
        }
      }
    }
  }
  for (int kind = 0; kind < static_cast<int>(Mutation::count); ++kind) {
    std::cout << mutation_names[kind] << ": " << made[kind] << " made, " << refuted[kind]
              << " refuted, " << undecided[kind] << " undecided\n";
    EXPECT_GT(made[kind], 0) << mutation_names[kind];
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
