// Points that have no cell.
#pragma once

#include <optional>
#include <utility>

#include "filtered/search/instant_predicates.h"

namespace voroproof::internal {

// The smallest pair of a point (radius 0) and another generator that touch. Tangencies vanish there
// and nowhere else: the point's cell has no area, the vertices around it coincide, and neither walk
// of the construction needs to end. Each disk is tried with the points between its extreme
// abscissas, the container with all.
std::optional<std::pair<GenId, GenId>> touching_point(InstantPredicates& predicates);

}  // namespace voroproof::internal
