// Lines of fields separated by blanks or tabs, as in the formats of docs/formats.md that are not
// JSON.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "history/line_source.h"

namespace voroproof::internal {

inline constexpr std::size_t max_text_line = std::size_t{1} << 16;

class FieldLines {
 public:
  // Throws InputError where the file cannot be opened.
  explicit FieldLines(const std::string& path) : path_(path), lines_(path) {}

  // Moves to the next line that is not blank; false after the last.
  bool next();

  std::string_view line() const { return line_; }  // without white space at its end
  std::int64_t number() const { return lines_.number(); }
  std::int64_t offset() const { return lines_.offset(); }
  LineSource& source() { return lines_; }
  std::size_t size() const { return fields_.size(); }
  std::string_view field(std::size_t k) const { return fields_[k]; }

  // The values of fields; `name` is for messages. A number is decimal, finite, and denotes the
  // nearest binary64. Throws InputError.
  std::int64_t integer(std::size_t k, const char* name, std::int64_t low, std::int64_t high) const;
  double number(std::size_t k, const char* name) const;
  // A number as the 16 lower-case hexadecimal digits of its 8 bytes, the least significant first.
  double hexadecimal(std::size_t k, const char* name) const;

  // Throws InputError, naming the line.
  [[noreturn]] void fail(const std::string& field, const std::string& reason) const;

 private:
  std::string path_;
  LineSource lines_;
  std::string_view line_;
  std::vector<std::string_view> fields_;
};

// Whether the text has the form that FieldLines::hexadecimal reads.
bool is_hexadecimal(std::string_view text);

}  // namespace voroproof::internal
