// The parts of scenes as text, in the one way in which this project writes them.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <variant>

#include "exact/rational.h"
#include "history/extensions.h"
#include "history/json_text.h"

namespace voroproof::internal {

// "[x, y]"
std::string pair_text(const Rational& x, const Rational& y);

std::string seed_text(const std::variant<std::string, Integer>& seed);

// Those of the disk or maneuver of that index, as members of its object.
std::string members_of(const std::map<std::size_t, Extensions>& extensions, std::size_t index);

// The lines of the members for people, those that there are: in scenes and worlds alike.
template <class SceneLike>
std::string lines_for_people(const SceneLike& scene) {
  std::string lines;
  if (!scene.name.empty()) lines += " \"name\": " + string_text(scene.name) + ",\n";
  if (!scene.comment.empty()) lines += " \"comment\": " + string_text(scene.comment) + ",\n";
  if (scene.seed) lines += " \"seed\": " + seed_text(*scene.seed) + ",\n";
  return lines;
}

}  // namespace voroproof::internal
