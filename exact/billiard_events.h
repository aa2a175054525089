// The events of billiards.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <variant>

#include "exact/billiard.h"
#include "exact/generators.h"

namespace voroproof::internal {

// A collision of a wall (a < 0) or a disk a with a disk b > a, or with an image of it.
struct BilliardCollision {
  GenId a, b;
  std::optional<LatticeImage> image;              // none where the file names none
  std::array<std::optional<CompactVec3>, 2> v{};  // velocities just after; none of a wall
  std::array<std::optional<CompactVec3>, 2> p{};  // centres
};
// A maneuver.
struct BilliardTurn {
  GenId disk;
  std::optional<CompactVec3> v, p;
};
struct BilliardEvent {
  CompactRational t;
  std::int64_t line = 0;  // in a history that was read
  std::variant<BilliardCollision, BilliardTurn> what;
};

}  // namespace voroproof::internal
