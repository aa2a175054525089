// Extensions: fields of the caller's own in scenes, histories and diagrams.
#pragma once

#include <map>
#include <string>

namespace voroproof {

// The extensions of one object of a file: each by its name, which begins with "x-", its value as
// JSON. They are read and written, and otherwise ignored (docs/formats.md, section 14). What writes
// them throws InputError for another name, and for a value that is no JSON.
using Extensions = std::map<std::string, std::string>;

}  // namespace voroproof
