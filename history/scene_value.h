// The numbers that scenes and plans allow.
#pragma once

#include "exact/compact_rational.h"
#include "history/json_reader.h"

namespace voroproof::internal {

// Reads a number within the limits of a scene (docs/formats.md). Throws InputError.
CompactRational scene_value(JsonReader& json);

}  // namespace voroproof::internal
