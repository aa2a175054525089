// The number types of the predicates: none contradicts another, and each is the first to decide
// some.
#include "exact/predicates.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>
#include <vector>

#include "exact/rational.h"
#include "tests/exact/predicate_sites.h"
#include "tests/exact/predicate_tiers.h"

namespace voroproof::internal::testing {
namespace {

// Sites that nearly are what a description says, by hairs down to 2^-1000.
Four nearly(const Four& four, const std::vector<int>& list) {
  Reader read(list);
  Four other = four;
  Site<Rational>& s = other.at[std::abs(read.integer()) % 4];
  const int bits = 7 * std::abs(read.integer() * read.integer());
  s.x += read.any() * hair(bits);
  s.y += read.any() * hair(bits);
  if (read.integer() % 2 == 0) s.r += abs(read.any()) * hair(bits) * (s.r < 0 ? -1 : 1);
  return other;
}
rc::Gen<Four> near_fours() {
  return rc::gen::apply(nearly,
                        fours({Kind::collinear, Kind::cotangent, Kind::cocircular, Kind::on_line}),
                        numbers());
}

RC_GTEST_PROP(AllTiersAgree, OnEverySignThatTheyTell, ()) {
  const Four four = *near_fours();
  const bool separate = are_separate(four);
  for (const Question question : all_questions) {
    const Sign truth = answer(question, four.at, four.wall);
    RC_ASSERT(truth != Sign::unknown);
    for (const bool turned : {false, true}) {
      at_each_tier(four.at, turned, [&](int tier, const auto& at) {
        const Sign told = answer(question, at, four.wall);
        RC_ASSERT(told == truth || (told == Sign::unknown && tier != exactly));
        return false;
      });
    }
  }
  const Sign in_circle = answer(Question::in_circle, four.at, four.wall);
  bool kept_exactly = true;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < i; ++j) kept_exactly &= tangency(four.at[i], four.at[j]) != 0;
  }
  at_each_tier(four.at, false, [&](int tier, const auto& at) {
    // No tangency that vanishes is called certain.
    const bool kept = keeps_tangencies(at);
    RC_ASSERT(kept == kept_exactly || (!kept && tier != exactly));
    if constexpr (requires { sqrt(at[0].x); }) {
      // The in-circle function itself has the sign that is told without it.
      if (separate) {
        const auto t = triple(at, disk_leads({0, 1, 2}, four.wall), four.wall);
        const Sign value = sign(incircle_value(t, at[3], four.wall == 3));
        RC_ASSERT(value == in_circle || value == Sign::unknown);
      }
    }
    return false;
  });
}

// The property above asks each of them something that coarser ones leave open.
TEST(AllTiersAgree, EachIsTheFirstToDecideSome) {
  const rc::Gen<Four> gen = near_fours();
  for (const Question question : all_questions) {
    std::array<int, std::size(tiers)> first{};
    for (int k = 0; k < 3000; ++k) {
      const Four four = gen(rc::Random(k), rc::kNominalSize).value();
      const Decision d = first_decision(question, four, k % 2 == 0);
      ++first[std::find(std::begin(tiers), std::end(tiers), d.tier) - std::begin(tiers)];
    }
    for (const int n : first) EXPECT_GT(n, 5) << static_cast<int>(question);
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
