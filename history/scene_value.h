// The numbers that scenes and plans allow.
#pragma once

#include <string>
#include <variant>

#include "exact/compact_rational.h"
#include "history/json_reader.h"

namespace voroproof::internal {

// Reads a number within the limits of a scene (docs/formats.md). Throws InputError.
CompactRational scene_value(JsonReader& json);

// Reads the seed of a scene: a string, or an integer of at most 1000 digits. Throws InputError.
std::variant<std::string, Integer> read_seed(JsonReader& json);

}  // namespace voroproof::internal
