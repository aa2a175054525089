// Small worlds in which something happens that has no place among random numbers, with what must
// come of it by hand.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exact/rational.h"
#include "history/world.h"
#include "history/world_history.h"

namespace voroproof::internal::testing {

// A line of a history that is no flip.
struct ExpectedLine {
  Rational t;
  std::string what;  // kind and ids: "hide [1,0]"
  bool operator==(const ExpectedLine&) const = default;
};

struct DegenerateWorld {
  std::string name;
  World world;
  // None: by hand only the diagrams are known.
  std::optional<std::vector<ExpectedLine>> lines;
  std::optional<int> flips;             // how many, where that is known
  std::optional<Rational> undecided{};  // nobody decides what happens then
};

std::vector<DegenerateWorld> degenerate_worlds();
// Those of them in which disks are one at an instant.
std::vector<DegenerateWorld> coincidences();

// The event without the place of an appear and without the steps of a jump, its time rounded; none
// of a flip.
std::optional<ExpectedLine> line_of(const WorldEvent& event);

}  // namespace voroproof::internal::testing
