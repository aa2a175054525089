// Formations that a swarm of vehicles can take, by name.
#pragma once

#include <string_view>
#include <vector>

#include "history/scene.h"

namespace voroproof::internal {

// Places around the origin for n vehicles, any two at least `spacing` apart. Lattices and letters
// consist of multiples of spacing / 20, and the places on a circle have exactly one distance from
// its centre.
//
//   square     a square lattice, row by row from below; the last row may be shorter
//   staggered  the same with every other row moved by half the spacing
//   frame      the sides of a square without its corners, counterclockwise
//   circle     one circle, about evenly
//   rings      a centre and circles of 8, 16, 24, ... vehicles around it; the last may have fewer
//   h, y       the letters, of two and three straight strokes (the 19 drones of the paper's Fig.
//   1d)
//
// Throws std::invalid_argument for a name that is none of these, and where n vehicles are too many
// for the points of a circle that there are.
std::vector<Point2> formation_places(std::string_view name, int n, const Rational& spacing);

// Whether a name is one of the above.
bool is_formation(std::string_view name);

}  // namespace voroproof::internal
