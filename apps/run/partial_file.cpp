#include "apps/run/partial_file.h"

#include <cstdio>
#include <filesystem>
#include <iostream>

#include "apps/cli/command_line.h"
#include "history/atomic_file.h"
#include "history/error.h"
#include "history/file_format.h"

namespace voroproof::internal {

bool PartialFile::is_there() const {
  std::error_code error;
  return std::filesystem::is_regular_file(path_, error);
}

void PartialFile::require_replaceable(const std::string& option) const {
  std::error_code error;
  if (!std::filesystem::exists(std::filesystem::symlink_status(path_, error))) return;
  try {
    if (is_there() && format_of_file(path_).name == format_) return;
  } catch (const InputError&) {
    // Then it is of no format.
  }
  throw UsageError(option + ": " + printable(path_, 4096) +
                   " is there, in which what the run reaches is kept, and is something else");
}

bool PartialFile::keep(const std::string& text) {
  try {
    AtomicFile file(path_);
    file.write(text);
    file.commit();
    return true;
  } catch (const OutputError& error) {
    if (!told_) {
      std::cerr << "voroproof: " << printable(error.what(), 4096)
                << "; the run goes on, and cannot be taken up from here\n";
    }
    told_ = true;
  }
  return false;
}

void PartialFile::forget() const { std::remove(path_.c_str()); }

}  // namespace voroproof::internal
