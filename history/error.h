// The errors of this room: an input that is not of its format, an output that cannot be written.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace voroproof::internal {

// A file that is not what it claims to be, or that cannot be read.
// what() is one line: "FILE:LINE: FIELD: REASON". Where the fault concerns the file as a whole
// (it cannot be opened, it is too large) the line is 0 and is left out; so is an empty field.
class InputError : public std::runtime_error {
 public:
  InputError(std::string file, std::int64_t line, std::string field, std::string reason);

  const std::string& file() const { return file_; }
  std::int64_t line() const { return line_; }          // counted from 1
  const std::string& field() const { return field_; }  // e.g. "disks[3].velocity[0]"
  const std::string& reason() const { return reason_; }

 private:
  std::string file_;
  std::int64_t line_;
  std::string field_;
  std::string reason_;
};

// A compressed file whose content is damaged, or ends too early.
class DamagedInput : public InputError {
 public:
  using InputError::InputError;
};

// An output file that cannot be written. what() is "FILE: REASON".
class OutputError : public std::runtime_error {
 public:
  OutputError(const std::string& file, std::string reason);

  const std::string& reason() const { return reason_; }

 private:
  std::string reason_;
};

// The text fit to stand in a message of one line: control characters written as \xNN, and at most
// `limit` bytes of it, cut between characters.
std::string printable(std::string_view text, std::size_t limit = 80);

}  // namespace voroproof::internal
