// Whether an edge is legal at one instant: by tangent circles, not by predicates.
#pragma once

#include <optional>

#include "exact/generators.h"
#include "tests/oracle/tangent_circles.h"

namespace voroproof::internal::testing {

// Positive: e is outside the circle of the edge's start vertex and s outside that of its end
// vertex. Zero: the four are cotangent. nullopt: the circles do not exist, or do not agree.
std::optional<int> legality(const oracle::Generators& at, const Quad& q);

// Whether q stays at an instant at which nothing happens: cotangent then means for ever.
std::optional<bool> is_legal(const oracle::Generators& at, const Quad& q);

// Whether an edge that is illegal just after an instant has shrunk to a point at it: two circles
// may touch the same four generators, and an edge lead from the one to the other. Then e touches
// the start circle elsewhere than between r and l.
bool has_shrunk(const oracle::Generators& just_after, const Quad& q);

}  // namespace voroproof::internal::testing
