// Writing a world (docs/formats.md, section 20).
#pragma once

#include <iosfwd>
#include <string>

#include "history/world.h"

namespace voroproof::internal {

// Writes the world so that reading it gives the same values, one disk a line, in the form of
// write_scene(). Defaults are left out; a circle is a "frame", whatever it was read from.
void write_world(std::ostream& out, const World& world);

// The same to a file, as OutputFile says. Throws OutputError.
void write_world(const std::string& path, const World& world);

}  // namespace voroproof::internal
