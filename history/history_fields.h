// The values in histories that have one form in all versions.
#pragma once

#include <string>
#include <vector>

#include "exact/generators.h"
#include "exact/rational.h"
#include "history/json_reader.h"

namespace voroproof::internal {

// These read a value and throw InputError where it is none of its kind. `last_id` is the largest id
// of a disk.
int read_id(JsonReader& json, int lowest, int last_id);
Quad read_edge(JsonReader& json, int last_id);  // as it is named
Number read_time(JsonReader& json);             // >= 0

// The time of an end line, which must be that of the horizon.
void read_end_time(JsonReader& json, const Rational& horizon);

// The hash in lower case; it must be the wanted one, where that is not empty.
std::string read_scene_sha256(JsonReader& json, const std::string& wanted);

// The edges of a diagram, canonical and sorted.
std::vector<Quad> read_initial(JsonReader& json, int last_id);

}  // namespace voroproof::internal
