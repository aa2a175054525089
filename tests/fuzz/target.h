// What is fuzzed: each target takes any bytes, and ends with a verdict of its own.
#pragma once

#include <string_view>
#include <vector>

namespace voroproof::internal::fuzz {

struct Target {
  std::string_view name;
  // Whether the bytes are what they are taken for. Whatever it throws is a find.
  bool (*accepts)(std::string_view bytes);
  int runs;  // in the tests
};

// The readers of all formats, and `certify`.
const std::vector<Target>& targets();

// Throws std::invalid_argument where there is none of that name.
const Target& target(std::string_view name);

// A scene and a history in one text, with a line of `pair_separator` between them. A history that
// names 64 hexadecimal digits as its scene's hash gets the right ones: else none would be judged.
inline constexpr std::string_view pair_separator = "\n====\n";
bool certifies(std::string_view pair);

// A certificate of a shard; four at most, which are joined.
bool reads_shard(std::string_view bytes);
bool merges(std::string_view shards);
// An index of the history of shards.scene.json, with which certify --resume and snapshot go on.
bool reads_index(std::string_view bytes);
// What certify has left of its report of the history of shards.scene.json.
bool resumes_certificate(std::string_view begun);
// A scene, and a history of it that simulate has begun. The hash is made the right one.
bool resumes_history(std::string_view texts);

}  // namespace voroproof::internal::fuzz
