#include "history/json_text.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>

#include "history/sha256.h"

namespace voroproof::internal {
namespace {

// The shortest text in printf's "%e" that reads back as x: its length.
std::size_t shortest_scientific(double x) {
  char text[64];
  for (int digits = 0;; ++digits) {
    const int length = std::snprintf(text, sizeof text, "%.*e", digits, x);
    if (std::strtod(text, nullptr) == x) return static_cast<std::size_t>(length);
  }
}

RC_GTEST_PROP(NumberText, ReadsBackAndIsShortest, (std::uint64_t bits)) {
  const double x = std::bit_cast<double>(bits * 0x9E3779B97F4A7C15u);
  RC_PRE(std::isfinite(x));
  const std::string text = number_text(x);
  RC_ASSERT(text.size() <= max_double_text);
  RC_ASSERT(std::strtod(text.c_str(), nullptr) == x);
  RC_ASSERT(nlohmann::json::parse(text).get<double>() == x);
  RC_ASSERT(text.size() <= shortest_scientific(x));
}

TEST(NumberText, Forms) {
  EXPECT_EQ(number_text(0.0), "0");
  EXPECT_EQ(number_text(-0.0), "0");
  EXPECT_EQ(number_text(4.0), "4");
  EXPECT_EQ(number_text(-1000.0), "-1000");
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(1e100), "1e100");
  EXPECT_EQ(number_text(-1.5e-7), "-1.5e-7");
  EXPECT_EQ(number_text(std::numeric_limits<double>::denorm_min()), "5e-324");
  EXPECT_THROW(number_text(std::numeric_limits<double>::infinity()), std::invalid_argument);
  EXPECT_THROW(number_text(std::nan("")), std::invalid_argument);
}

TEST(NumberText, ExactValues) {
  EXPECT_EQ(number_text(Rational(1, 2)), "0.5");
  EXPECT_EQ(number_text(Rational(1, 3)), "\"1/3\"");
  EXPECT_EQ(number_text(Rational(-1, 10)), "\"-1/10\"");
  EXPECT_EQ(number_text(Rational(0)), "0");
  EXPECT_EQ(number_text(Rational("9007199254740993")), "\"9007199254740993\"");
}

RC_GTEST_PROP(StringText, ReadsBack, (const std::string& bytes)) {
  // Any code point below 256, so that the text is UTF-8.
  std::string text;
  for (char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      text += c;
    } else {
      text += static_cast<char>(0xC0 | byte >> 6);
      text += static_cast<char>(0x80 | (byte & 0x3F));
    }
  }
  RC_ASSERT(nlohmann::json::parse(string_text(text)).get<std::string>() == text);
}

TEST(StringText, EscapesAndReplaces) {
  EXPECT_EQ(string_text("a\"\\\n\t\x01"
                        "b"),
            "\"a\\\"\\\\\\n\\t\\u0001b\"");
  EXPECT_EQ(string_text("x\xff"), "\"x\xEF\xBF\xBD\"");
}

// The examples of FIPS 180-4.
TEST(Sha256, PublishedExamples) {
  EXPECT_EQ(sha256_hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256_hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_hex(std::string(1'000'000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

}  // namespace
}  // namespace voroproof::internal
