#include "history/file_bytes.h"

#include <algorithm>

#include "history/byte_source.h"
#include "history/error.h"

namespace voroproof::internal {

std::string file_bytes(const std::string& path, std::size_t limit, bool may_cut) {
  constexpr std::size_t max_step = std::size_t{1} << 24;
  ByteSource source(path);
  std::string bytes;
  if (const std::size_t size = source.known_size(); size > 0) {
    bytes.reserve(std::min(size, limit) + max_step);
  }
  std::size_t step = std::size_t{1} << 16;
  for (;;) {
    // Pipes and compressed files come in small pieces, and room is made seldom.
    std::size_t have = bytes.size();
    bytes.resize(have + std::min(step, limit + 1 - have));
    std::size_t got = 0;
    do {
      got = source.read(bytes.data() + have, bytes.size() - have);
      have += got;
    } while (got > 0 && have < bytes.size());
    bytes.resize(have);
    if (bytes.size() > limit) {
      if (!may_cut)
        throw InputError(path, 0, "", "larger than " + std::to_string(limit) + " bytes");
      bytes.resize(limit);
      return bytes;
    }
    if (got == 0) return bytes;
    step = std::min(2 * step, max_step);
  }
}

}  // namespace voroproof::internal
