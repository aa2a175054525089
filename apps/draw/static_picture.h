// Pictures of diagrams of disks at rest.
#pragma once

#include <string>
#include <vector>

#include "voroproof/static_diagram.h"

namespace voroproof::internal {

// Draws what lies in the box into a square picture file: cells and disks in the colours of their
// ids (disk_colour()), edges as curves, the frame, hidden disks with broken rims; a cross where a
// radius is negative. Labels, one a disk, stand where they have room (place_labels()). Throws
// std::invalid_argument for a box without area, and as write_picture() does.
void draw_static_diagram(const StaticDiagram& diagram, const Box& box,
                         const std::vector<std::string>& labels, const std::string& path, int size);

}  // namespace voroproof::internal
