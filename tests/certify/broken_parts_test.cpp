// A history with a line that cannot be read, dealt out in parts: what is before that line is there.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "certify/part_reader.h"
#include "history/error.h"
#include "history/scene_motion.h"
#include "tests/certify/broken_history.h"
#include "tests/certify/claimed_history.h"
#include "tests/certify/dealt_parts.h"
#include "tests/certify/same_claim.h"

namespace voroproof::internal::testing {
namespace {

// A line that cannot be read: what is before is dealt out as far as parts have ended; the rest of
// it is lost.
TEST(PartReader, InputErrorInTheMiddle) {
  std::vector<double> times;
  for (int k = 1; k <= 40; ++k) times.push_back(k);
  const ClaimedHistory h = hits(times);
  const CertifyOptions options = in_parts_of(1);
  const Scene scene = lone();
  const MotionInput input = checked_input(motion_input(scene), h.header);
  for (const std::size_t readable : {0u, 1u, 4u, 17u, 39u, 40u}) {
    BrokenHistory source(h, readable);
    std::vector<std::string> remarks;
    PartReader reader(scene, input, source, options, remarks);
    std::size_t claims = 0, parts = 0;
    try {
      while (auto part = reader.next()) {
        ASSERT_TRUE(part->end.has_value()) << "the last part, though the history goes on";
        const ReadPart read = told(std::move(*part));
        EXPECT_EQ(read.number, parts++);
        for (const Claim& claim : read.claims) EXPECT_TRUE(same(claim, h.events[claims++]));
      }
      ADD_FAILURE() << "all could be read";
    } catch (const InputError& e) {
      EXPECT_EQ(e.line(), static_cast<std::int64_t>(readable) + 2);
    }
    // A few are read ahead.
    EXPECT_LE(claims, readable);
    EXPECT_GE(claims + 5, readable);
  }
}

// A claim that makes no sense is before the line that cannot be read: then the part that it is in
// is there, and reading it on throws.
TEST(PartReader, InputErrorAfterNonsense) {
  ClaimedHistory h = hits({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
  h.events[2] = ManeuverEvent{3, 0};
  const CertifyOptions options = in_parts_of(1);
  const Scene scene = lone();
  const MotionInput input = checked_input(motion_input(scene), h.header);
  BrokenHistory source(h, 10);
  std::vector<std::string> remarks;
  PartReader reader(scene, input, source, options, remarks);
  std::optional<Part> part;
  while ((part = reader.next()) && part->end) {
  }
  ASSERT_TRUE(part.has_value());
  int claims = 0;
  try {
    while (part->claims->next()) ++claims;
    ADD_FAILURE() << "all could be read";
  } catch (const InputError&) {
  }
  EXPECT_EQ(claims, 8);  // all but the two of parts before
}

}  // namespace
}  // namespace voroproof::internal::testing
