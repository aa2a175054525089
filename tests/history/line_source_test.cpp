// The hash of what is read line by line.
#include "history/line_source.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "history/sha256.h"
#include "tests/history/temporary_directory.h"

namespace voroproof::internal::testing {
namespace {

// Lines of 0 to `longest` bytes, so many bytes in all at least.
std::string some_lines(std::size_t bytes, std::size_t longest) {
  std::string text;
  for (std::size_t k = 1; text.size() < bytes; ++k) {
    text += std::string(k * 7919 % longest, static_cast<char>('a' + k % 26)) + '\n';
  }
  return text;
}

TEST(Sha256, GoesOnFromEveryState) {
  const std::string text = some_lines(300, 40);
  for (std::size_t k = 0; k <= text.size(); ++k) {
    Sha256 before;
    before.add(std::string_view(text).substr(0, k));
    auto after = Sha256::resumed(before.state(), static_cast<std::int64_t>(k));
    ASSERT_TRUE(after) << k;
    EXPECT_EQ(after->state(), before.state());
    after->add(std::string_view(text).substr(k));
    EXPECT_EQ(after->hex(), sha256_hex(text)) << k;
  }
}

TEST(Sha256, GoesOnFromNothingElse) {
  Sha256 sha;
  sha.add("abc");
  const std::string state = sha.state();
  EXPECT_TRUE(Sha256::resumed(state, 3));
  EXPECT_FALSE(Sha256::resumed(state, 4));
  EXPECT_FALSE(Sha256::resumed(state, -61));
  EXPECT_FALSE(Sha256::resumed("x" + state.substr(1), 3));
  EXPECT_FALSE(Sha256::resumed(state.substr(0, state.size() - 1) + "g", 3));
  EXPECT_FALSE(Sha256::resumed("", 0));
  // The length is part of what was hashed.
  EXPECT_NE(Sha256::resumed(state, 3)->hex(), Sha256::resumed(state, 67)->hex());
}

// Of text of several buffers, in lines of any length; asked for now and then, some lines behind.
TEST(LineSource, HashesWhatItHasGiven) {
  const TemporaryDirectory directory;
  for (const std::size_t longest : {3ul, 100ul, 50'000ul}) {
    const std::string text = some_lines(900'000, longest) + "no line end";
    const std::string path = directory.write("a", text);
    for (const std::size_t behind : {0u, 5u}) {
      LineSource lines(path);
      lines.keep_digest();
      lines.next(text.size());
      std::vector<std::int64_t> ends{lines.offset()};
      for (std::size_t k = 1; lines.next(text.size()); ++k) {
        ends.push_back(lines.offset());
        if (behind > 0) lines.settle(ends[k - std::min(k, behind)]);
        if (k % 97 != 0) continue;
        const std::int64_t asked = ends[k - std::min(k, behind)];
        ASSERT_EQ(Sha256(lines.digest_up_to(asked)).hex(),
                  sha256_hex(text.substr(0, static_cast<std::size_t>(asked))));
      }
      EXPECT_EQ(lines.content_sha256(), sha256_hex(text));
      EXPECT_EQ(lines.content_sha256(), sha256_hex(text));
    }
  }
}

TEST(LineSource, HashesTheRestOfWhatItHasNotGiven) {
  const TemporaryDirectory directory;
  const std::string text = some_lines(900'000, 100), path = directory.write("a", text);
  LineSource lines(path);
  EXPECT_EQ(lines.content_sha256(), "");
  lines.keep_digest();
  lines.drop_digest();
  EXPECT_EQ(lines.content_sha256(), "");
  lines.keep_digest();
  for (int k = 0; k < 1000; ++k) lines.next(text.size());
  const std::int64_t offset = lines.offset(), number = lines.number();
  const Sha256 before = lines.digest_up_to(offset);
  EXPECT_EQ(lines.content_sha256(), sha256_hex(text));
  // From the middle on: only where it is told what was before.
  LineSource later(path);
  later.keep_digest();
  ASSERT_TRUE(later.skip_to(offset, number));
  EXPECT_EQ(later.content_sha256(), "");
  ASSERT_TRUE(later.skip_to(offset, number, before));
  later.next(text.size());
  EXPECT_EQ(later.content_sha256(), sha256_hex(text));
}

}  // namespace
}  // namespace voroproof::internal::testing
