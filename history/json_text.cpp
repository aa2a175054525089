#include "history/json_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "history/utf8.h"

namespace voroproof::internal {

char* put_number(char* out, double x) {
  if (!std::isfinite(x)) throw std::invalid_argument("a JSON number must be finite");
  if (x == 0) {
    *out = '0';
    return out + 1;
  }
  char* const end = std::to_chars(out, out + max_double_text, x).ptr;
  char* const mark = static_cast<char*>(std::memchr(out, 'e', static_cast<std::size_t>(end - out)));
  if (mark == nullptr) return end;
  // std::to_chars writes "1e+05" and "1e-07".
  char* to = mark + 1;
  const char* from = mark + 1;
  if (*from == '-') ++to;
  ++from;
  while (*from == '0') ++from;
  return std::copy(from, static_cast<const char*>(end), to);
}

char* put_integer(char* out, long long i) { return std::to_chars(out, out + 20, i).ptr; }

std::string number_text(double x) {
  char text[max_double_text];
  return std::string(text, put_number(text, x));
}

std::string number_text(const Rational& q) {
  // Truncation changes nothing exactly where q is a binary64.
  const double x = q.get_d();
  if (std::isfinite(x) && to_rational(x) == q) return number_text(x);
  return '"' + q.get_str() + '"';
}

std::string string_text(std::string_view text) {
  static constexpr char hex[] = "0123456789abcdef";
  std::string out = "\"";
  while (!text.empty()) {
    const char c = text[0];
    const std::size_t length = utf8_character(text);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (c == '\n') {
      out += "\\n";
    } else if (c == '\t') {
      out += "\\t";
    } else if (static_cast<unsigned char>(c) < 0x20) {
      out += "\\u00";
      out += hex[c >> 4];
      out += hex[c & 15];
    } else if (length == 0) {
      append_utf8(out, 0xFFFD);
    } else {
      out += text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out + '"';
}

}  // namespace voroproof::internal
