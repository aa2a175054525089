// The generators of a refutation's evidence, drawn.
#pragma once

#include <string>
#include <vector>

#include "library/explanation.h"

namespace voroproof::internal {

// Draws the generators at the time of the event into a picture file: the disks with their ids
// and velocities, the container where it is one of them, and the circles that touch all of them or,
// where none does, three of them and contain none of these three's points, as vertices of the
// diagram. Throws as write_picture does. Precondition: there are generators.
void draw_witness(const std::vector<DrawnGenerator>& generators, const std::string& path);

}  // namespace voroproof::internal
