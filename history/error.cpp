#include "history/error.h"

#include <limits>
#include <utility>

namespace voroproof {
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

}  // namespace

InputError::InputError(std::string file, std::int64_t line, std::string field, std::string reason)
    : std::runtime_error(message(file, line, field, reason)),
      file_(std::move(file)),
      line_(line),
      field_(std::move(field)),
      reason_(std::move(reason)) {}

OutputError::OutputError(const std::string& file, const std::string& reason)
    : std::runtime_error(message(file, 0, "", reason)) {}

std::string printable(std::string_view text, std::size_t limit) {
  const bool cut = text.size() > limit;
  if (cut) {
    // Bytes 10xxxxxx continue a character: step back to where one starts.
    while (limit > 0 && (static_cast<unsigned char>(text[limit]) & 0xC0) == 0x80) --limit;
    text = text.substr(0, limit);
  }
  static constexpr char hex[] = "0123456789abcdef";
  std::string out;
  for (char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F) {
      out += "\\x";
      out += hex[byte >> 4];
      out += hex[byte & 15];
    } else {
      out += c;
    }
  }
  if (cut) out += "...";
  return out;
}

}  // namespace voroproof
