// The generators of a refutation's evidence, drawn.
#pragma once

#include <string>
#include <vector>

#include "apps/explanation.h"

namespace voroproof {

// Draws the generators at the time of the event into an SVG or PNG file: the disks with their ids
// and velocities, the container where it is one of them, and for each triple of them the circle
// that touches all three and, as a vertex of the diagram, contains none of their points. Throws
// as write_picture does. Precondition: there are generators.
void draw_witness(const std::vector<DrawnGenerator>& generators, const std::string& path);

}  // namespace voroproof
