// Well-formed UTF-8 (RFC 3629).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace voroproof::internal {

// The length in bytes of the character that `text` starts with, or 0 where it starts with none:
// stray or missing continuation bytes, overlong forms, surrogates, beyond U+10FFFF, empty text.
std::size_t utf8_character(std::string_view text);

// Appends the character of the given code point, which is at most 0x10FFFF and no surrogate.
void append_utf8(std::string& out, unsigned code_point);

}  // namespace voroproof::internal
