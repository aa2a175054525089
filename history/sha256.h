// The fingerprint that ties a history to its scene.
#pragma once

#include <string>
#include <string_view>

namespace voroproof::internal {

// SHA-256 (FIPS 180-4) of the bytes, as 64 lower-case hexadecimal digits.
std::string sha256_hex(std::string_view bytes);

// The same of the content of a file of any size (ByteSource). Throws InputError.
std::string sha256_of_file(const std::string& path);

}  // namespace voroproof::internal
