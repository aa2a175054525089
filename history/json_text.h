// JSON values as text, in the one way in which this project writes them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "exact/rational.h"

namespace voroproof::internal {

// The longest text that put_number writes.
inline constexpr std::size_t max_double_text = 32;

// Writes x at `out`, which has room for max_double_text characters, and returns the end: the
// shortest decimal that reads back as x, an integral value without a point, zero as "0" whatever
// its sign, an exponent without "+" and leading zeros. Throws std::invalid_argument where x is not
// finite, for JSON has no such number.
char* put_number(char* out, double x);

// Writes i at `out`, which has room for 20 characters, and returns the end.
char* put_integer(char* out, long long i);

std::string number_text(double x);

// A JSON number where q is exactly a binary64, else the string "p/q" with its quotes.
std::string number_text(const Rational& q);

// The text between quotes, with what JSON requires escaped. Bytes that are not UTF-8 become U+FFFD.
std::string string_text(std::string_view text);

}  // namespace voroproof::internal
