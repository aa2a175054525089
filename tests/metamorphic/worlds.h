// Worlds that are mapped: a scene, what is claimed of it, and the tolerance with which it is
// judged.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "history/scene.h"
#include "tests/certify/claimed_history.h"
#include "tests/certify/mutation.h"
#include "tests/support/correspondence.h"

namespace voroproof::internal::metamorphic {

struct World {
  std::string family;
  std::uint64_t seed = 0;
  // Nothing happens at one instant with something else, but by design of a relation.
  bool generic = false;
  Scene scene;
  Rational tolerance{1, 1000000};
  // A history of a wrong world; else the engine's own, or that with one fault.
  std::optional<testing::ClaimedHistory> claim{};
  std::optional<testing::Mutation> mutation{};
};

// All families: those of tests/adversary, and those of scenes.h.
std::vector<std::string> world_families();

// A function of the seed; of any family where none is named. Nothing where no scene comes about.
std::optional<World> world_of(std::uint64_t seed, const std::string& family);

// The same in other units, of lengths 2^length and of times 2^time.
testing::Image units_image(int length, int time);
// Whether the reader takes the scene: all values in range, nothing overlaps.
std::optional<Scene> read_again(const Scene& scene);
// Units at random, as far from the usual ones as the range of values has room for.
std::optional<testing::Image> random_units(const Scene& scene, std::uint64_t seed);

}  // namespace voroproof::internal::metamorphic
