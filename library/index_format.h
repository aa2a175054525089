// The common parts of the writer and the reader of an index.
#pragma once

#include <cstdint>
#include <string>

namespace voroproof::internal {

inline constexpr const char* index_format = "voroproof-index";

// SHA-256 of the bytes [from, until) of a plain file; of fewer where the file ends before. Throws
// InputError.
std::string sha256_of_stretch(const std::string& path, std::int64_t from, std::int64_t until);

}  // namespace voroproof::internal
