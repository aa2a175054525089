#include "history/json_reader.h"

#include <cctype>
#include <charconv>
#include <cmath>
#include <cstring>
#include <set>
#include <system_error>

#include "history/error.h"
#include "history/utf8.h"

namespace voroproof::internal {
namespace {

constexpr std::size_t max_integer_digits = 1000;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

char JsonReader::peek() {
  for (; next_ != end_; ++next_) {
    switch (*next_) {
      case '\n':
        ++line_;
        break;
      case ' ':
      case '\t':
      case '\r':
        break;
      default:
        return *next_;
    }
  }
  return '\0';
}

void JsonReader::expect(char c, const char* what) {
  if (!accept(c)) fail_expected(what);
}

// Whether another member or element follows the one just read.
bool JsonReader::more(char closing) {
  if (accept(',')) return true;
  if (accept(closing)) return false;
  fail_expected(closing == '}' ? "',' or '}'" : "',' or ']'");
}

std::string_view JsonReader::any_member_name() {
  top().name = {};
  if (peek() != '"' || next_ == end_) fail_expected("a key");
  const std::string_view name = text();
  expect(':', "':'");
  return name;
}

// The index of a member among `names`; `count` for an extension, whose value is read as well.
std::size_t JsonReader::member_name(const std::string_view* names, std::size_t count,
                                    Extensions* extensions) {
  const std::string_view name = any_member_name();
  for (std::size_t i = 0; i < count; ++i)
    if (name == names[i]) return i;
  if (extensions != nullptr && is_extension(name)) {
    extension(std::string(name), *extensions);
    return count;
  }
  const std::string unknown = printable(name);
  top().name = unknown;
  fail("unknown field");
}

void JsonReader::extension(std::string name, Extensions& extensions) {
  const auto [place, fresh] = extensions.emplace(std::move(name), std::string());
  top().name = place->first;
  if (!fresh) fail("appears twice in one object");
  place->second = compact_json(any());
}

std::string_view JsonReader::text() {
  if (peek() != '"' || next_ == end_) fail_expected("a string");
  ++next_;
  const char* start = next_;
  bool plain = true;
  unescaped_.clear();
  for (;;) {
    const auto length = static_cast<std::size_t>(next_ - start);
    if (length + unescaped_.size() > max_json_text)
      fail("a string of more than " + std::to_string(max_json_text) + " bytes");
    if (next_ == end_) fail("unexpected end of input within a string");
    const char c = *next_;
    if (c == '"') break;
    if (c == '\\') {
      unescaped_.append(start, length);
      escape();
      start = next_;
      plain = false;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      fail("control character within a string");
    } else if (static_cast<unsigned char>(c) < 0x80) {
      ++next_;
    } else {
      const std::size_t bytes =
          utf8_character(std::string_view(next_, static_cast<std::size_t>(end_ - next_)));
      if (bytes == 0) fail("invalid UTF-8");
      next_ += bytes;
    }
  }
  const std::string_view rest(start, static_cast<std::size_t>(next_ - start));
  ++next_;
  if (plain) return rest;
  unescaped_ += rest;
  return unescaped_;
}

// Reads the escape sequence at next_ and appends what it stands for.
void JsonReader::escape() {
  ++next_;
  if (next_ == end_) fail("unexpected end of input within a string");
  switch (*next_++) {
    case '"':
      unescaped_ += '"';
      return;
    case '\\':
      unescaped_ += '\\';
      return;
    case '/':
      unescaped_ += '/';
      return;
    case 'b':
      unescaped_ += '\b';
      return;
    case 'f':
      unescaped_ += '\f';
      return;
    case 'n':
      unescaped_ += '\n';
      return;
    case 'r':
      unescaped_ += '\r';
      return;
    case 't':
      unescaped_ += '\t';
      return;
    case 'u': {
      unsigned code = four_hex_digits();
      if (code >= 0xD800 && code < 0xDC00 && end_ - next_ >= 2 && next_[0] == '\\' &&
          next_[1] == 'u') {
        next_ += 2;
        const unsigned low = four_hex_digits();
        if (low < 0xDC00 || low >= 0xE000) fail("half a surrogate pair");
        code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
      } else if (code >= 0xD800 && code < 0xE000) {
        fail("half a surrogate pair");
      }
      append_utf8(unescaped_, code);
      return;
    }
    default:
      fail("unknown escape sequence within a string");
  }
}

unsigned JsonReader::four_hex_digits() {
  unsigned code = 0;
  if (end_ - next_ < 4) fail("unexpected end of input within a string");
  const auto result = std::from_chars(next_, next_ + 4, code, 16);
  // A sign is no digit, though from_chars takes none for an unsigned type either.
  if (result.ec != std::errc() || result.ptr != next_ + 4)
    fail("\\u needs four hexadecimal digits");
  next_ += 4;
  return code;
}

// Reads a token of JSON's number grammar, which is narrower than that of std::from_chars.
std::string_view JsonReader::number_token() {
  const char first = peek();
  if (first != '-' && !is_digit(first)) fail_expected("a number");
  const char* const start = next_;
  const auto at = [&](char c) { return next_ != end_ && *next_ == c; };
  const auto digits = [&] {
    const char* const first_digit = next_;
    while (next_ != end_ && is_digit(*next_)) {
      if (static_cast<std::size_t>(next_ - start) >= max_number_text)
        fail("a number of more than " + std::to_string(max_number_text) + " characters");
      ++next_;
    }
    if (next_ == first_digit) fail("a number lacks digits");
  };
  if (at('-')) ++next_;
  const bool leading_zero = at('0');
  const char* const integral = next_;
  digits();
  if (leading_zero && next_ - integral > 1) fail("a number has a leading zero");
  if (at('.')) {
    ++next_;
    digits();
  }
  if (at('e') || at('E')) {
    ++next_;
    if (at('+') || at('-')) ++next_;
    digits();
  }
  return {start, static_cast<std::size_t>(next_ - start)};
}

Number JsonReader::number() {
  Number number;
  if (peek() == '"') {
    std::string reason;
    number.exact = parse_rational(text(), &reason);
    if (!number.exact) fail("the string " + reason);
    number.nearest = round_nearest(*number.exact);
    if (std::isinf(number.nearest)) fail("beyond the range of binary64");
    return number;
  }
  const std::string_view token = number_token();
  const auto result = std::from_chars(token.data(), token.data() + token.size(), number.nearest);
  // This refuses, too, a value that is not zero, but nearest to zero.
  if (result.ec != std::errc()) fail("beyond the range of binary64");
  if (number.nearest == 0) number.nearest = 0;  // not -0
  return number;
}

std::int64_t JsonReader::integer(std::int64_t low, std::int64_t high) {
  const std::string_view token = number_token();
  std::int64_t value = 0;
  const auto result = std::from_chars(token.data(), token.data() + token.size(), value);
  if (result.ptr != token.data() + token.size()) fail("not an integer");
  if (result.ec != std::errc() || value < low || value > high)
    fail("not in [" + std::to_string(low) + ", " + std::to_string(high) + "]");
  return value;
}

Integer JsonReader::big_integer() {
  const std::string_view token = number_token();
  if (token.find_first_of(".eE") != std::string_view::npos) fail("not an integer");
  if (token.size() > max_integer_digits)
    fail("an integer of more than " + std::to_string(max_integer_digits) + " digits");
  return Integer(std::string(token), 10);
}

bool JsonReader::null() {
  if (peek() != 'n') return false;
  if (end_ - next_ < 4 || std::memcmp(next_, "null", 4) != 0) fail_expected("a value");
  next_ += 4;
  return true;
}

bool JsonReader::boolean() {
  peek();
  const std::string_view rest(next_, static_cast<std::size_t>(end_ - next_));
  const bool value = rest.starts_with("true");
  if (!value && !rest.starts_with("false")) fail_expected("true or false");
  next_ += value ? 4 : 5;
  return value;
}

std::string_view JsonReader::any() {
  peek();
  const char* const start = next_;
  switch (peek()) {
    case '{': {
      std::set<std::string> names;
      any_object([&](std::string_view name) {
        if (!names.emplace(name).second) fail("a field appears twice in one object");
        any();
        return true;
      });
      break;
    }
    case '[':
      array([&](std::size_t) { any(); });
      break;
    case '"':
      text();
      break;
    case 'n':
      null();
      break;
    case 't':
    case 'f':
      boolean();
      break;
    default:
      if (next_ == end_ || (*next_ != '-' && !is_digit(*next_))) fail_expected("a value");
      number();
  }
  return {start, static_cast<std::size_t>(next_ - start)};
}

void JsonReader::finish() {
  peek();
  if (next_ != end_) fail_expected("nothing more");
}

std::string JsonReader::field() const {
  std::string field;
  for (int i = 0; i < depth_; ++i) {
    if (path_[i].index >= 0) {
      field += '[' + std::to_string(path_[i].index) + ']';
    } else if (!path_[i].name.empty()) {
      if (!field.empty()) field += '.';
      field += path_[i].name;
    }
  }
  return field;
}

void JsonReader::fail(const std::string& reason) const {
  throw InputError(*file_, line_, field(), reason);
}

void JsonReader::fail_expected(const char* what) {
  const char found = peek();
  if (next_ == end_) fail(std::string("unexpected end of input, expected ") + what);
  const std::string_view rest(next_, static_cast<std::size_t>(end_ - next_));
  const std::size_t length = utf8_character(rest);
  if (length == 0) fail(std::string("invalid UTF-8 (expected ") + what + ")");
  std::string shown(1, found);
  // A word tells more than its first letter: NaN, true.
  if (std::isalpha(static_cast<unsigned char>(found))) {
    std::size_t letters = 1;
    while (letters < rest.size() && letters < 20 &&
           std::isalpha(static_cast<unsigned char>(rest[letters])))
      ++letters;
    shown = rest.substr(0, letters);
  } else if (length > 1) {
    shown = rest.substr(0, length);
  }
  fail(std::string("expected ") + what + ", found '" + shown + "'");
}

void JsonReader::fail_depth() const {
  fail("nested deeper than " + std::to_string(max_json_depth) + " levels");
}

void JsonReader::fail_length(std::size_t wanted) const {
  fail("not an array of " + std::to_string(wanted) + " elements");
}

void JsonReader::fail_in(const std::string& member, const std::string& reason) const {
  const std::string object = field();
  throw InputError(*file_, line_, object.empty() ? member : object + '.' + member, reason);
}

}  // namespace voroproof::internal
