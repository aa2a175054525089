#include "history/descriptor.h"

#include <sys/stat.h>
#include <unistd.h>

#include <charconv>
#include <string_view>
#include <system_error>

namespace voroproof::internal {

std::optional<int> named_descriptor(const std::string& path) {
  if (path == "/dev/stdin") return STDIN_FILENO;
  if (path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!path.starts_with(folder)) continue;
    const char* const end = path.data() + path.size();
    int number = 0;
    const auto [rest, error] = std::from_chars(path.data() + folder.size(), end, number);
    if (error == std::errc() && rest == end && number >= 0) return number;
  }
  return std::nullopt;
}

bool is_stream(const std::string& path) {
  if (named_descriptor(path)) return true;
  struct stat status {};
  return stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

bool is_standard_output(const std::string& path) {
  if (const auto descriptor = named_descriptor(path)) {
    if (*descriptor == STDOUT_FILENO) return true;
  }
  struct stat named {
  }, out{};
  if (stat(path.c_str(), &named) != 0 || fstat(STDOUT_FILENO, &out) != 0) return false;
  // Many processes share a device, such as /dev/null.
  return (S_ISREG(out.st_mode) || S_ISFIFO(out.st_mode)) && named.st_dev == out.st_dev &&
         named.st_ino == out.st_ino;
}

bool is_same_stream(const std::string& a, const std::string& b) {
  const auto first = named_descriptor(a), second = named_descriptor(b);
  if (first || second) return first == second;
  return a == b && is_stream(a);
}

}  // namespace voroproof::internal
