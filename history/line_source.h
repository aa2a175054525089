// The lines of an input of any length, in bounded memory.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "history/byte_source.h"

namespace voroproof::internal {

class LineSource {
 public:
  // Throws InputError where the file cannot be opened.
  explicit LineSource(const std::string& path);

  // The next line without its end, or nothing after the last. Text after the last line end is a
  // line too. The view holds until the next call. Throws InputError where the line has more than
  // `limit` bytes, or the file cannot be read.
  std::optional<std::string_view> next(std::size_t limit);

  // The number of the line that next() gave last; 0 before the first.
  std::int64_t number() const { return number_; }
  // The bytes up to the end of that line, its line end included.
  std::int64_t offset() const { return offset_; }

  // Goes on as if that line, which has that number, had been given. False, and nothing is done,
  // where the input is no plain file. Throws InputError where no line ends there.
  bool skip_to(std::int64_t offset, std::int64_t number);

 private:
  bool fill();  // reads more; false at the end of the file

  std::string path_;
  ByteSource source_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;  // what is read and not yet given
  std::int64_t number_ = 0, offset_ = 0;
};

}  // namespace voroproof::internal
