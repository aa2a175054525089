#include "history/text_fields.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>

#include "history/error.h"

namespace voroproof::internal {

namespace {

constexpr std::string_view kBlanks = " \t\r";

int digit_value(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return -1;
}

}  // namespace

bool FieldLines::next() {
  while (const auto line = lines_.next(max_text_line)) {
    const std::size_t last = line->find_last_not_of(kBlanks);
    if (last == std::string_view::npos) continue;
    line_ = line->substr(0, last + 1);
    fields_.clear();
    for (std::size_t k = line_.find_first_not_of(kBlanks); k != std::string_view::npos;) {
      const std::size_t end = std::min(line_.find_first_of(kBlanks, k), line_.size());
      fields_.push_back(line_.substr(k, end - k));
      k = line_.find_first_not_of(kBlanks, end);
    }
    return true;
  }
  line_ = {};
  fields_.clear();
  return false;
}

std::int64_t FieldLines::integer(std::size_t k, const char* name, std::int64_t low,
                                 std::int64_t high) const {
  if (k >= size()) fail(name, "missing");
  const std::string_view text = field(k);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) fail(name, "not a whole number");
  if (value < low || value > high) {
    fail(name, "not in [" + std::to_string(low) + ", " + std::to_string(high) + "]");
  }
  return value;
}

double FieldLines::number(std::size_t k, const char* name) const {
  if (k >= size()) fail(name, "missing");
  std::string_view text = field(k);
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) fail(name, "beyond the range of a binary64");
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    fail(name, "not a number");
  }
  return value == 0 ? 0 : value;  // never -0
}

double FieldLines::hexadecimal(std::size_t k, const char* name) const {
  if (k >= size()) fail(name, "missing");
  const std::string_view text = field(k);
  if (!is_hexadecimal(text)) fail(name, "not the 16 hexadecimal digits of a binary64");
  std::uint64_t bits = 0;
  for (int byte = 7; byte >= 0; --byte) {
    bits = bits << 8 | static_cast<std::uint64_t>(digit_value(text[2 * byte]) << 4 |
                                                  digit_value(text[2 * byte + 1]));
  }
  const double value = std::bit_cast<double>(bits);
  if (!std::isfinite(value)) fail(name, "not a finite number");
  return value == 0 ? 0 : value;
}

void FieldLines::fail(const std::string& field, const std::string& reason) const {
  throw InputError(path_, lines_.number(), field, reason);
}

bool is_hexadecimal(std::string_view text) {
  return text.size() == 16 &&
         std::all_of(text.begin(), text.end(), [](char c) { return digit_value(c) >= 0; });
}

}  // namespace voroproof::internal
