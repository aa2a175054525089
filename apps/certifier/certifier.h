// The kernel's rules as a page for browsers.
#pragma once

#include <string>

namespace voroproof::internal {

// Writes the page, which certifies histories by the rules of docs/kernel.md and needs no other
// file. `producer` is the name and version of the program that writes it. The file appears whole or
// not at all. Throws OutputError.
void write_certifier(const std::string& path, const std::string& producer);

}  // namespace voroproof::internal
