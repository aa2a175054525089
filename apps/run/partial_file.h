// The state that a run has reached, kept beside its result for a later run to take up.
#pragma once

#include <string>

namespace voroproof::internal {

// The file RESULT.partial, or of another ending, of one of the project's formats.
class PartialFile {
 public:
  PartialFile(const std::string& result, std::string format, const std::string& ending = ".partial")
      : path_(result + ending), format_(std::move(format)) {}

  const std::string& path() const { return path_; }

  // Whether an earlier run has left it.
  bool is_there() const;

  // Throws UsageError, which begins with the option that names the result, where something else
  // than a file of this format has its name: it would be replaced, and removed at the end.
  void require_replaceable(const std::string& option) const;

  // Replaces it, and returns true. A disk that is full is no reason to end the run: the user is
  // told, once.
  bool keep(const std::string& text);

  // The result says more.
  void forget() const;

 private:
  std::string path_, format_;
  bool told_ = false;
};

}  // namespace voroproof::internal
