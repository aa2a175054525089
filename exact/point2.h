// A place or a vector of the plane, exactly.
#pragma once

#include "exact/rational.h"

namespace voroproof::internal {

struct Point2 {
  Rational x, y;
};

}  // namespace voroproof::internal
