// The events of a history (docs/formats.md).
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <variant>

#include "exact/generators.h"
#include "exact/rational.h"

namespace voroproof::internal {

using Vec2 = std::array<double, 2>;
using ExactVec2 = std::array<Rational, 2>;

// The values of an event line on which some number was written as an exact string. All the values
// that the line gives are here, also those written as JSON numbers.
struct ExactValues {
  Rational t;
  std::array<std::optional<ExactVec2>, 2> v, p;  // for a maneuver: [0]
};

// The doubles of an event are the nearest to what its line denotes; `exact` is null where that
// loses nothing.
struct FlipEvent {
  double t = 0;
  Quad quad{};  // the edge just before, canonical
  std::shared_ptr<const ExactValues> exact{};
};

// Generators i < j touch. v: velocities just after; p: centres; [0] of i, [1] of j. A history gives
// v (and p) for both or for neither, and never for the container.
struct CollideEvent {
  double t = 0;
  GenId i = 0, j = 0;
  std::array<std::optional<Vec2>, 2> v{}, p{};
  std::shared_ptr<const ExactValues> exact{};
};

struct ManeuverEvent {
  double t = 0;
  GenId disk = 0;
  std::optional<Vec2> v{}, p{};
  std::shared_ptr<const ExactValues> exact{};
};

using Event = std::variant<FlipEvent, CollideEvent, ManeuverEvent>;

inline double time(const Event& event) {
  return std::visit([](const auto& e) { return e.t; }, event);
}

// Exactly what the line denotes. `side` is 0 for i and 1 for j.
Rational exact_time(const Event& event);
std::optional<ExactVec2> exact_velocity(const CollideEvent& event, int side);
std::optional<ExactVec2> exact_center(const CollideEvent& event, int side);
std::optional<ExactVec2> exact_velocity(const ManeuverEvent& event);
std::optional<ExactVec2> exact_center(const ManeuverEvent& event);

}  // namespace voroproof::internal
