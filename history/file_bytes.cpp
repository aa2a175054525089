#include "history/file_bytes.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "history/error.h"

namespace voroproof::internal {

std::string file_bytes(const std::string& path, std::size_t limit, bool may_cut) {
  const auto fail = [&] {
    throw InputError(path, 0, "", std::string("cannot read: ") + std::strerror(errno));
  };
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  if (!file) fail();
  constexpr std::size_t max_step = std::size_t{1} << 24;
  std::string bytes;
  struct stat status {};
  if (fstat(fileno(file.get()), &status) == 0 && S_ISREG(status.st_mode))
    bytes.reserve(std::min(static_cast<std::size_t>(status.st_size), limit) + max_step);
  std::size_t step = std::size_t{1} << 16;
  for (;;) {
    const std::size_t before = bytes.size();
    const std::size_t wanted = std::min(step, limit + 1 - before);
    bytes.resize(before + wanted);
    const std::size_t got = std::fread(bytes.data() + before, 1, wanted, file.get());
    bytes.resize(before + got);
    if (std::ferror(file.get())) fail();
    if (bytes.size() > limit) {
      if (!may_cut)
        throw InputError(path, 0, "", "larger than " + std::to_string(limit) + " bytes");
      bytes.resize(limit);
      return bytes;
    }
    if (got < wanted) return bytes;
    step = std::min(2 * step, max_step);
  }
}

}  // namespace voroproof::internal
