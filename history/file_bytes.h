// A whole file in memory, within a limit.
#pragma once

#include <cstddef>
#include <string>

namespace voroproof::internal {

// The content of the file, expanded where it is compressed; at most `limit` bytes of it: a longer
// one is an InputError, or is cut where `may_cut`. Also throws InputError where the file cannot be
// read.
std::string file_bytes(const std::string& path, std::size_t limit, bool may_cut = false);

}  // namespace voroproof::internal
