// Whether a file is of one of the project's formats.
#pragma once

#include <string>

namespace voroproof {

// Finds out by its field "format" which of scene, history and diagram the file claims to be, reads
// it completely and returns a short description: "history: 12 flips, ...". A history need not be
// complete in time: one that stopped early is valid, one without a last line is not; an end line
// with wrong counts is not either. Throws InputError.
std::string validate_file(const std::string& path);

}  // namespace voroproof
