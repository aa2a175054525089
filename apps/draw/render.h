// Pictures of diagrams: SVG, PNG and PDF files drawn with Cairo.
#pragma once

#include <optional>
#include <string>

#include "history/diagram_file.h"

namespace voroproof::internal {

struct RenderOptions {
  int size = 1000;  // width and height of the square picture, in pixels; 16 to 20000
  // The radius (>= 0) of a probe: its voids, tunnels and the offset instead of the cells.
  std::optional<double> probe{};
};

// Draws the diagram into a file, an SVG, a PNG or a PDF by the extension of its name:
// the container, a pale cell for each disk (in the colour of its id, disk_colour()), the
// edges, the disks and their velocities; ids where there are at most 60 disks,
// vertices where there are at most 200. The y axis points upwards. On one system,
// equal diagrams give equal files.
//
// The file appears whole or not at all. Throws std::invalid_argument for another
// extension, a size out of range or a diagram that is none (edges that do not fit
// its vertices and disks); OutputError when the file cannot be written.
void render_diagram(const DiagramFile& diagram, const std::string& path,
                    const RenderOptions& options = {});

}  // namespace voroproof::internal
