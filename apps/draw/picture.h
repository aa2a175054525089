// Picture files.
#pragma once

#include <cairo.h>

#include <functional>
#include <string>

namespace voroproof::internal {

// Whether the name ends as that of a picture: in .svg, .png or .pdf, compressed or not.
bool names_picture(const std::string& path);

// Paints a square picture of `size` pixels (16 to 20000) into a file, an SVG, a PNG or a PDF (96
// pixels an inch) by the extension of its name; a stream without one gets an SVG. On one system,
// equal paintings give equal files. The file appears whole or not at all. Throws
// std::invalid_argument for another extension or a size out of range; OutputError when the file
// cannot be written.
void write_picture(const std::string& path, int size, const std::function<void(cairo_t*)>& paint);

}  // namespace voroproof::internal
