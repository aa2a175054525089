// The JSON reader against nlohmann's and against strtod.
#include "history/json_reader.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>

#include "history/error.h"
#include "history/utf8.h"

namespace voroproof::internal {
namespace {

const std::string file = "in.json";

// The fault found when the text is read as any one value, or "".
std::string fault(const std::string& text) {
  try {
    JsonReader json(text, file);
    json.any();
    json.finish();
    return "";
  } catch (const InputError& e) {
    return e.what();
  }
}

double number(const std::string& text) {
  JsonReader json(text, file);
  const double x = json.number().nearest;
  json.finish();
  return x;
}

TEST(JsonReader, AcceptsWhatJsonIs) {
  for (const char* text : {"null", "true", "false", "0", "-0", "1.5e+10", "1E5", "\"\"", "[]", "{}",
                           " [ 1 , [ ] ] ", "{\"a\":{\"b\":[1,2,{\"c\":null}]}}",
                           "\"\\u00e9\\ud83d\\ude00\\n\"", "\"\xc3\xa9\"", "\"\x7f\"", "\t\r\n1"}) {
    EXPECT_EQ(fault(text), "") << text;
    EXPECT_TRUE(nlohmann::json::accept(text)) << text;
  }
}

TEST(JsonReader, RefusesWhatJsonIsNot) {
  for (const char* text : {"",
                           " ",
                           "nul",
                           "nulL",
                           "tru",
                           "True",
                           "NaN",
                           "Infinity",
                           "-Infinity",
                           "+1",
                           "01",
                           "-01",
                           ".5",
                           "1.",
                           "1.e5",
                           "1e",
                           "1e+",
                           "-",
                           "0x10",
                           "1 2",
                           "[1,]",
                           "[,1]",
                           "[1",
                           "[1 2]",
                           "{",
                           "{\"a\"}",
                           "{\"a\":}",
                           "{\"a\":1,}",
                           "{a:1}",
                           "{'a':1}",
                           "{\"a\" 1}",
                           "\"",
                           "\"\\x\"",
                           "\"\\u12g4\"",
                           "\"\\u+123\"",
                           "\"\\ud800\"",
                           "\"\\udc00\"",
                           "\"\\ud800\\u0041\"",
                           "\"\\ud800\\ud800\"",
                           "\"a\nb\"",
                           "\"\x01\"",
                           "\"\x80\"",
                           "\"\xc0\xaf\"",
                           "\"\xed\xa0\x80\"",
                           "\"\xf4\x90\x80\x80\"",
                           "\"\xe2\x82\"",
                           "\xff",
                           "//x\n1",
                           "[1]]",
                           "1,"}) {
    EXPECT_NE(fault(text), "") << text;
    EXPECT_FALSE(nlohmann::json::accept(text)) << text;
  }
}

// Random damage to a text with every construct: both readers agree on what is left, but that ours
// alone refuses a key that occurs twice. The text is too small for the limits of ours.
RC_GTEST_PROP(JsonReader, AgreesWithNlohmannOnDamagedText, ()) {
  std::string text =
      R"({"a": [0, -1.5e-3, 20E+2, true, false, null], "b\n\u00e9": {"c": "\ud83d\ude00é", "": []}, "d": {}})";
  const auto damages = *rc::gen::inRange(1, 4);
  for (int i = 0; i < damages; ++i) {
    const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
    switch (*rc::gen::inRange(0, 3)) {
      case 0:
        text.erase(at, *rc::gen::inRange<std::size_t>(1, 4));
        break;
      case 1:
        text.insert(at, 1, *rc::gen::elementOf(std::string("{}[],:\"\\0129.eE+-ntu \n\x80\xc3")));
        break;
      default:
        text[at] = static_cast<char>(*rc::gen::inRange(0, 256));
    }
    if (text.empty()) break;
  }
  const std::string why = fault(text);
  RC_PRE(why.find("appears twice") == std::string::npos);
  RC_ASSERT(why.empty() == nlohmann::json::accept(text));
}

RC_GTEST_PROP(JsonReader, ReadsTheNearestBinary64, (long long digits, int scale)) {
  const std::string text = std::to_string(digits) + "." + std::to_string(std::abs(scale)) + "e" +
                           std::to_string(scale % 280);
  const double x = std::strtod(text.c_str(), nullptr);
  RC_ASSERT(number(text) == x);
}

TEST(JsonReader, ReadsLongNumeralsToTheLastDigit) {
  // Half way between 1 and its successor, and a little more.
  const std::string half = "1.00000000000000011102230246251565404236316680908203125";
  EXPECT_EQ(number(half), 1.0);
  EXPECT_EQ(number(half + std::string(3000, '0') + "1"), 1.0 + 0x1p-52);
  EXPECT_EQ(number("9007199254740993"), 9007199254740992.0);
  EXPECT_EQ(number("3e-324"), 4.9406564584124654e-324);
  EXPECT_EQ(number("1e308"), 1e308);
  EXPECT_EQ(number("4.9406564584124654e-324"), 4.9406564584124654e-324);
  EXPECT_EQ(number("123456789012345678901234567890"), 123456789012345678901234567890.0);
}

TEST(JsonReader, ReadsExactStrings) {
  const std::string text = R"(["0.1", "1/3", "0x1.8p-3", "-0", 0.1])";
  JsonReader json(text, file);
  std::vector<Number> numbers;
  json.array([&](std::size_t) { numbers.push_back(json.number()); });
  EXPECT_EQ(numbers[0].value(), Rational(1, 10));
  EXPECT_EQ(numbers[0].nearest, 0.1);
  EXPECT_EQ(numbers[1].value(), Rational(1, 3));
  EXPECT_EQ(numbers[1].nearest, 1.0 / 3);
  EXPECT_EQ(numbers[2].value(), Rational(3, 16));
  EXPECT_EQ(numbers[3].value(), 0);
  EXPECT_FALSE(numbers[4].exact);
  EXPECT_NE(numbers[4].value(), Rational(1, 10));
}

TEST(JsonReader, ZeroHasNoSign) {
  EXPECT_FALSE(std::signbit(number("-0")));
  EXPECT_FALSE(std::signbit(number("-0.0e5")));
  EXPECT_FALSE(std::signbit(number("\"-0\"")));
}

TEST(JsonReader, RefusesNumbersThatNoBinary64IsNear) {
  for (const char* text : {"1e999", "-1e999", "1.8e308", "1e-999", "-1e-400", "2e-324", "\"1e350\"",
                           "\"1/0\"", "\"NaN\"", "\"inf\"", "\"\"", "\" 1\"", "NaN", "null", "true",
                           "[1]", "1e99999999999999999999"})
    EXPECT_THROW(number(text), InputError) << text;
}

TEST(JsonReader, RefusesLongNumeralsEarly) {
  const std::string text(50'000'000, '7');
  JsonReader json(text, file);
  try {
    json.number();
    FAIL();
  } catch (const InputError& e) {
    EXPECT_EQ(e.reason(), "a number of more than 4096 characters");
  }
}

TEST(JsonReader, RefusesLongStringsEarly) {
  EXPECT_NE(fault('"' + std::string(2'000'000, 'x') + '"'), "");
  std::string escapes = "\"";
  for (int i = 0; i < 1'100'000; ++i) escapes += "\\n";
  EXPECT_NE(fault(escapes + '"'), "");
  EXPECT_EQ(fault('"' + std::string(1'000'000, 'x') + '"'), "");
}

TEST(JsonReader, LimitsTheDepth) {
  EXPECT_EQ(fault(std::string(16, '[') + std::string(16, ']')), "");
  EXPECT_EQ(
      fault(std::string(17, '[') + std::string(17, ']')).find("nested deeper") == std::string::npos,
      false);
  EXPECT_NE(fault(std::string(10'000'000, '[')), "");
  std::string objects;
  for (int i = 0; i < 100'000; ++i) objects += "{\"a\":";
  EXPECT_NE(fault(objects), "");
}

TEST(JsonReader, IntegersAreWrittenAsIntegers) {
  const auto integer = [](const std::string& text) {
    JsonReader json(text, file);
    const auto value = json.integer(-1, 5);
    json.finish();
    return value;
  };
  EXPECT_EQ(integer("-1"), -1);
  EXPECT_EQ(integer("5"), 5);
  EXPECT_EQ(integer("-0"), 0);
  for (const char* text : {"-2", "6", "1.0", "1e0", "\"1\"", "99999999999999999999", "01", "null"})
    EXPECT_THROW(integer(text), InputError) << text;
}

TEST(JsonReader, NamesLineAndField) {
  static constexpr std::array<std::string_view, 2> names = {"a", "b"};
  const auto read = [](const std::string& text) -> std::string {
    try {
      JsonReader json(text, file, 10);
      json.object(names, 3, [&](std::size_t) {
        json.array([&](std::size_t) { json.array_of<2>([&](std::size_t) { json.number(); }); });
      });
      json.finish();
      return "";
    } catch (const InputError& e) {
      return e.what();
    }
  };
  EXPECT_EQ(read("{\"a\":[[1,2]],\n\"b\":[]}\n"), "");
  EXPECT_EQ(read("{\"a\":[[1,2],\n[3,\nx]]}"), "in.json:12: a[1][1]: expected a number, found 'x'");
  EXPECT_EQ(read("\n{\"a\":[],\n\"a\":[]}"), "in.json:12: a: appears twice in one object");
  EXPECT_EQ(read("{\"a\":[],\"\\u0061\":[]}"), "in.json:10: a: appears twice in one object");
  EXPECT_EQ(read("\n{\n\"a\":[]\n\n}"), "in.json:11: b: missing");
  EXPECT_EQ(read("{\"c\\n\":1}"), "in.json:10: c\\x0a: unknown field");
  EXPECT_EQ(read("{\"a\":[[1,2,3]]}"), "in.json:10: a[0]: not an array of 2 elements");
  EXPECT_EQ(read("{\"a\":[[1]]}"), "in.json:10: a[0]: not an array of 2 elements");
  EXPECT_EQ(read("{\"a\":[],\"b\":[]}\n\nx"), "in.json:12: expected nothing more, found 'x'");
  EXPECT_EQ(read("{\"a\":[],\n"), "in.json:11: unexpected end of input, expected a key");
  EXPECT_EQ(read("{\"a\":{}}"), "in.json:10: a: expected an array, found '{'");
}

TEST(Utf8, EveryCodePointAndNothingElse) {
  for (unsigned code = 0; code <= 0x10FFFF; ++code) {
    if (code >= 0xD800 && code < 0xE000) continue;
    std::string text;
    append_utf8(text, code);
    ASSERT_EQ(utf8_character(text), text.size()) << code;
    text.pop_back();
    ASSERT_EQ(utf8_character(text), 0u) << code;
  }
  // All sequences of two bytes, counted: 128 * 256 that start with one byte, 30 * 64 of two.
  std::size_t good = 0;
  for (int a = 0; a < 256; ++a)
    for (int b = 0; b < 256; ++b)
      good += utf8_character(std::string{static_cast<char>(a), static_cast<char>(b)}) > 0;
  EXPECT_EQ(good, 128u * 256 + 30 * 64);
}

}  // namespace
}  // namespace voroproof::internal
