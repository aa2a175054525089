// The errors that the library throws. All have a message of one line.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include "voroproof/export.h"

namespace voroproof {

// The base of all that follow. Besides these, functions throw std::invalid_argument for arguments
// without meaning, std::bad_alloc, and std::logic_error where the library contradicts itself.
class VOROPROOF_API Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  ~Error() override;
};

// A scene, a history or a plan that is not what it claims to be, or a file that cannot be read.
class VOROPROOF_API InputError : public Error {
 public:
  // The text of what() is "FILE:LINE: FIELD: REASON" without the parts that are empty or zero.
  InputError(const std::string& what, std::string file, std::int64_t line, std::string field,
             std::string reason);
  ~InputError() override;

  const std::string& file() const { return file_; }    // "scene" and "history" for values in memory
  std::int64_t line() const { return line_; }          // counted from 1; 0: the file as a whole
  const std::string& field() const { return field_; }  // such as "disks[3].velocity[0]"
  const std::string& reason() const { return reason_; }

 private:
  std::string file_;
  std::int64_t line_;
  std::string field_;
  std::string reason_;
};

// An output file that cannot be written. Nothing is half-written then.
class VOROPROOF_API OutputError : public Error {
 public:
  using Error::Error;
  ~OutputError() override;
};

// A decision that needs more than the budget (`max_bits`), where no partial result can say so.
class VOROPROOF_API Undecided : public Error {
 public:
  using Error::Error;
  ~Undecided() override;
};

// A monitor asked to stop, where no partial result can say so.
class VOROPROOF_API Interrupted : public Error {
 public:
  using Error::Error;
  ~Interrupted() override;
};

}  // namespace voroproof
