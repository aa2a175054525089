// The events of a world, as its history tells them (docs/formats.md, section 20).
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "exact/generators.h"
#include "exact/point2.h"
#include "exact/rational.h"

namespace voroproof::internal {

// The disk g is in the host j from now on, and has no cell.
struct Hide {
  GenId g, j;
  bool operator==(const Hide&) const = default;
};
// The disk g leaves its last host j. Its cell comes into the edge `at`, of which j is the first
// generator; there is none where fewer than two disks are visible before.
struct Appear {
  GenId g, j;
  std::optional<Quad> at;
  bool operator==(const Appear&) const = default;
};
// A flip, named canonically as just before it, is one of a Quad.
using Step = std::variant<Quad, Hide, Appear>;

// i < j have changed places.
struct Swap {
  GenId i, j;
  bool operator==(const Swap&) const = default;
};
// A maneuver that is no jump: the state after it, as far as it is told.
struct PathTurn {
  GenId g;
  std::optional<Point2> velocity, center;
  std::optional<Rational> growth;
};
// The disk g leaves the diagram by the steps `out` and enters it by those `in`, of which the first
// is an appear, if it is visible then. One that comes has no `out`, one that goes no `in`, and one
// that jumps at 0 may have neither: the initial diagram has it done. One that is hidden before has
// an empty `out`, one that is hidden afterwards an empty `in`. Where the first appear of `in` has
// no edge, no line tells its j: readers give container_id.
struct Jump {
  GenId g;
  std::optional<std::vector<Step>> out, in;
  std::optional<Point2> center, velocity;  // after it
  std::optional<Rational> radius;
};

struct WorldEvent {
  Rational t;  // as its line denotes it
  std::variant<Quad, Hide, Appear, Swap, PathTurn, Jump> what;
};

}  // namespace voroproof::internal
