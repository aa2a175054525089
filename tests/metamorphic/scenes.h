// Families of scenes for exact maps, in rational numbers: what tests/adversary has no place for.
#pragma once

#include <string_view>
#include <vector>

#include "history/scene.h"
#include "tests/adversary/families.h"

namespace voroproof::internal::metamorphic {

Rational power_of_two(int exponent);

struct SceneFamily {
  std::string_view name;
  bool generic;
  Scene (*make)(adversary::Random& random);
};

const std::vector<SceneFamily>& scene_families();

}  // namespace voroproof::internal::metamorphic
