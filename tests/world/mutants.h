// Histories of worlds that are wrong in one place.
#pragma once

#include <optional>
#include <random>
#include <string>
#include <vector>

#include "history/world.h"
#include "history/world_history.h"

namespace voroproof::internal::testing {

struct WrittenWorld {
  std::vector<Quad> initial;
  std::vector<WorldEvent> events;
};

struct Mutant {
  std::string kind;
  WrittenWorld history;
};

// The history with one change, by which it mostly becomes wrong; none where that change has no
// place in it. Times are changed by more than the tolerance.
std::optional<Mutant> mutant(const World& world, const WrittenWorld& right,
                             const Rational& tolerance, std::mt19937_64& random);

}  // namespace voroproof::internal::testing
