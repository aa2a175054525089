#include "history/error.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace voroproof::internal {
namespace {

constexpr std::size_t whole = std::numeric_limits<std::size_t>::max();

std::string message(const std::string& file, std::int64_t line, const std::string& field,
                    const std::string& reason) {
  std::string text = printable(file, whole);
  if (line > 0) text += ":" + std::to_string(line);
  text += ": ";
  if (!field.empty()) text += printable(field, whole) + ": ";
  return text + printable(reason, whole);
}

// The bytes of the character of UTF-8 that the text begins with; 0 where it is none, or one that
// controls the terminal or the line: C0, DEL, C1, the separators of lines, marks that turn the
// direction of writing.
std::size_t whole_character(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned lead = byte(0);
  if (lead < 0x80) return lead < 0x20 || lead == 0x7F ? 0 : 1;
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return 0;
  unsigned character = lead & (0xFFu >> (length + 1));
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(k) & 0xC0) != 0x80) return 0;
    character = character << 6 | (byte(k) & 0x3Fu);
  }
  const bool controls = character < 0xA0 || character == 0x2028 || character == 0x2029 ||
                        (character >= 0x202A && character <= 0x202E) ||
                        (character >= 0x2066 && character <= 0x2069);
  const bool overlong = (length == 3 && character < 0x800) || (length == 4 && character < 0x10000);
  return controls || overlong ? 0 : length;
}

}  // namespace

InputError::InputError(std::string file, std::int64_t line, std::string field, std::string reason)
    : std::runtime_error(message(file, line, field, reason)),
      file_(std::move(file)),
      line_(line),
      field_(std::move(field)),
      reason_(std::move(reason)) {}

OutputError::OutputError(const std::string& file, std::string reason)
    : std::runtime_error(message(file, 0, "", reason)), reason_(std::move(reason)) {}

std::string printable(std::string_view text, std::size_t limit) {
  const bool cut = text.size() > limit;
  if (cut) {
    // Bytes 10xxxxxx continue a character: step back to where one starts.
    while (limit > 0 && (static_cast<unsigned char>(text[limit]) & 0xC0) == 0x80) --limit;
    text = text.substr(0, limit);
  }
  std::string out;
  while (!text.empty()) {
    const std::size_t length = whole_character(text);
    if (length > 0) {
      out += text.substr(0, length);
    } else {
      static constexpr char hex[] = "0123456789abcdef";
      const auto byte = static_cast<unsigned char>(text.front());
      out += "\\x";
      out += hex[byte >> 4];
      out += hex[byte & 15];
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  if (cut) out += "...";
  return out;
}

}  // namespace voroproof::internal
