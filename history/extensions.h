// Extensions: fields of strangers in files of this project's formats (docs/formats.md, section 14).
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace voroproof::internal {

// The extensions of one object: each by its name, which begins with "x-", its value as JSON without
// white space outside of strings. Nothing is decided by them.
using Extensions = std::map<std::string, std::string>;

inline bool is_extension(std::string_view name) { return name.starts_with("x-"); }

// A text that is JSON, without white space outside of strings.
std::string compact_json(std::string_view json);

// Each extension as another member of an object: `,"x-name":value`, or with a blank after comma and
// colon. Throws InputError where one has no such name, or a value that is no JSON.
std::string members_text(const Extensions& extensions, bool spaced = false);

}  // namespace voroproof::internal
