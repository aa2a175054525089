// JSON, read strictly, and the numbers in it. Where a text is not as it must be all throw Stop
// (invalid).
#pragma once

#include <map>
#include <nlohmann/json.hpp>

#include "certify/kernel/files.h"

namespace voroproof_kernel {

// The floating-point numbers are binary64; that of nlohmann is wider only so that it does not
// refuse the integers of a seed.
using Json = nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t,
                                  std::uint64_t, long double>;
Json parse(const char* begin, const char* end);

using Names = std::initializer_list<const char*>;
// Requires that an object has all fields of the first list, and of others only those of the second
// and, where it may have them, extensions.
void expect_fields(const Json& object, Names required, Names optional = {}, bool extensible = true);
// Asked before the other fields: a newer version may have some that are not known here.
int version_of(const Json& object, const char* format);

const std::string& string_of(const Json& json);
std::int64_t whole(const Json& json, std::int64_t least, std::int64_t most);
const Json& list(const Json& json, std::size_t least, std::size_t most);
// Within the limits of scenes, and of histories.
Rat scene_number(const Json& json);
Rat history_number(const Json& json);
Vec vec(const Json& json, Rat read(const Json&), int coordinates = 2);

// Fields that scenes of all kinds have; then scenes of version 2.
void read_remarks(const Json& json);
void read_maneuvers(const Json& json, Scene& scene);
Scene read_billiard(const Json& json);

}  // namespace voroproof_kernel
