// Picture files.
#pragma once

#include <cairo.h>

#include <functional>
#include <string>

namespace voroproof::internal {

// Paints a square picture of `size` pixels (16 to 20000) into a file, an SVG or a PNG by the
// extension of its name. On one system, equal paintings give equal SVG files. The file appears
// whole or not at all. Throws std::invalid_argument for another extension or a size out of range;
// OutputError when the file cannot be written.
void write_picture(const std::string& path, int size, const std::function<void(cairo_t*)>& paint);

}  // namespace voroproof::internal
