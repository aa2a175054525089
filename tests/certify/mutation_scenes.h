// Scenes whose histories are falsified.
#pragma once

#include <vector>

#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {

// Scenes of all families, in so many rounds, small enough for thousands of certificates.
std::vector<Scene> some_scenes(Random& random, int rounds);

}  // namespace voroproof::internal::testing
