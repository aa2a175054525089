// A list of claims gives back what it was given, each once, in any order.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "certify/part_reader.h"
#include "tests/certify/same_claim.h"

namespace voroproof::internal::testing {
namespace {

TEST(ClaimList, Empty) {
  ClaimList list;
  EXPECT_EQ(list.size(), 0u);
  list.reserve(100);
  EXPECT_EQ(list.size(), 0u);
}

Claim any_claim() {
  const double t = *rc::gen::element(0.0, 0.1, 1e-300, 7.5, 1e17);
  const auto id = [] { return *rc::gen::element<GenId>(-1, 0, 1, 2, 5, 1999999); };
  std::shared_ptr<ExactValues> exact;
  if (*rc::gen::element(false, false, true)) {
    exact = std::make_shared<ExactValues>();
    exact->t = to_rational(t) + Rational(1, 3);
    exact->v[1] = ExactVec2{Rational(1, 7), 2};
  }
  switch (*rc::gen::element(0, 0, 0, 1, 2)) {
    case 0:
      return FlipEvent{t, {id(), id(), id(), id()}, exact};
    case 1: {
      CollideEvent c{.t = t, .i = id(), .j = id()};
      if (*rc::gen::arbitrary<bool>()) c.v = {Vec2{1, t}, Vec2{2, 3}};
      if (*rc::gen::arbitrary<bool>()) c.p[1] = Vec2{t, 5};
      c.exact = exact;
      return c;
    }
    default: {
      ManeuverEvent m{.t = t, .disk = id()};
      if (*rc::gen::arbitrary<bool>()) m.v = Vec2{t, 1};
      m.exact = exact;
      return m;
    }
  }
}

RC_GTEST_PROP(ClaimList, GivesBackWhatItWasGiven, ()) {
  std::vector<std::pair<Claim, std::int64_t>> claims;
  const int size = *rc::gen::inRange(0, 30);
  std::int64_t line = *rc::gen::element<std::int64_t>(1, 2, std::int64_t{1} << 40);
  for (int k = 0; k < size; ++k) claims.emplace_back(any_claim(), line += *rc::gen::inRange(1, 4));
  ClaimList list;
  if (*rc::gen::arbitrary<bool>()) list.reserve(claims.size());
  for (const auto& [claim, at] : claims) list.add(Claim(claim), at);
  RC_ASSERT(list.size() == claims.size());
  ClaimList moved = std::move(list);
  // In any order, and as often as one likes.
  const bool backwards = *rc::gen::arbitrary<bool>();
  for (std::size_t n = 0; n < claims.size(); ++n) {
    const std::size_t k = backwards ? claims.size() - 1 - n : n;
    RC_ASSERT(moved.line(k) == claims[k].second);
    RC_ASSERT(same(moved.event(k).value(), claims[k].first));
    RC_ASSERT(same(moved.event(k).value(), claims[k].first));
    RC_ASSERT(moved.line(k) == claims[k].second);
  }
  RC_ASSERT(moved.size() == claims.size());
  // The others are passed over by turn_from().
  const auto is_plain_flip = [&](std::size_t k) {
    const auto* flip = std::get_if<FlipEvent>(&claims[k].first);
    return flip != nullptr && !flip->exact;
  };
  for (std::size_t k = 0; k <= claims.size(); ++k) {
    std::size_t first = k;
    while (first < claims.size() && is_plain_flip(first)) ++first;
    RC_ASSERT(moved.turn_from(k) == first);
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
