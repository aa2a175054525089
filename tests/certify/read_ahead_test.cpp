// A history read ahead gives the claims that it would give anyway, and what cannot be read in its
// place.
#include "certify/read_ahead.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>

#include "history/error.h"
#include "tests/certify/broken_history.h"
#include "tests/certify/claimed_history.h"
#include "tests/certify/dealt_parts.h"
#include "tests/certify/same_claim.h"

namespace voroproof::internal::testing {
namespace {

TEST(ReadAhead, GivesTheClaimsInTheirOrderWithTheirLines) {
  const ClaimedHistory h = hits({1, 2, 3, 4, 5});
  for (const std::size_t far : {0u, 1u, 3u, 5u, 9u}) {
    MemoryHistory source(h);
    ReadAhead ahead(source, far);
    EXPECT_EQ(ahead.after(0), nullptr) << "nothing is read before it is asked for";
    for (std::size_t k = 0; k < h.events.size(); ++k) {
      const ReadAhead::Claim* const claim = ahead.first();
      ASSERT_NE(claim, nullptr);
      EXPECT_TRUE(same(claim->event(), h.events[k]));
      EXPECT_EQ(claim->line, static_cast<std::int64_t>(k) + 2);
      EXPECT_EQ(claim, ahead.first()) << "it is given until it is dropped";
      for (std::size_t others = 0; others <= far + 1; ++others) {
        const ReadAhead::Claim* const later = ahead.after(others);
        const bool is_read = others <= far && k + others < h.events.size();
        ASSERT_EQ(later != nullptr, is_read) << far << ' ' << k << ' ' << others;
        if (!is_read) continue;
        EXPECT_TRUE(same(later->event(), h.events[k + others]));
      }
      ahead.drop_first();
    }
    EXPECT_EQ(ahead.first(), nullptr);
    EXPECT_EQ(ahead.first(), nullptr);
  }
}

TEST(ReadAhead, WhatCannotBeReadIsThrownInItsPlace) {
  const ClaimedHistory h = hits({1, 2, 3, 4, 5});
  for (const std::size_t readable : {0u, 1u, 4u, 5u}) {
    BrokenHistory source(h, readable);
    ReadAhead ahead(source, 3);
    for (std::size_t k = 0; k < readable; ++k) {
      ASSERT_NE(ahead.first(), nullptr);
      ahead.drop_first();
    }
    EXPECT_THROW(ahead.first(), InputError);
    EXPECT_THROW(ahead.first(), InputError);
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
