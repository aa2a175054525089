// The witnesses of mutants of right histories.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/certify/mutation.h"
#include "tests/certify/mutation_scenes.h"
#include "tests/evidence/tally.h"

namespace voroproof::internal::testing {
namespace {

TEST(MutantEvidence, NoWitnessIsFalse) {
  // VOROPROOF_MUTANTS asks for more.
  const char* asked = std::getenv("VOROPROOF_MUTANTS");
  const int wanted = asked != nullptr ? std::atoi(asked) : 300;
  Random random(asked != nullptr ? 77 : 3);
  Tally tally;
  int total = 0;
  while (total < wanted) {
    for (const Scene& scene : some_scenes(random, 1)) {
      const RecordedRun r = run(scene);
      if (!r.complete()) continue;
      const ClaimedHistory right = claimed_history(scene, r);
      for (int kind = 0; kind < static_cast<int>(Mutation::count); ++kind) {
        for (const Truth truth : {Truth::exact, Truth::recorded}) {
          CertifyOptions options;
          options.truth = truth;
          const double slack = truth == Truth::exact ? 0 : 1e-9;
          const auto wrong = mutate(scene, right, static_cast<Mutation>(kind), 1e-6, slack, random);
          if (!wrong) continue;
          ++total;
          const Certificate c = certify(scene, *wrong, options);
          if (!c.divergence) continue;
          tally.add(*c.divergence, std::string(mutation_names[kind]) + " truth " +
                                       std::to_string(static_cast<int>(truth)) + "\n" +
                                       text(*wrong) + text(scene));
        }
      }
    }
  }
  tally.print();
  // One of four refutations has something to check, on the whole.
  EXPECT_GE(4 * tally.count(Evidence::confirmed), wanted * 4 / 5);
}

}  // namespace
}  // namespace voroproof::internal::testing
