// Several files in one text, with lines of `pair_separator` between them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "history/sha256.h"
#include "tests/fuzz/target.h"

namespace voroproof::internal::fuzz {

// `count` of them; the last one takes what is left, and those that are not there are empty.
inline std::vector<std::string> pieces_of(std::string_view bytes, std::size_t count) {
  std::vector<std::string> pieces;
  while (pieces.size() + 1 < count) {
    const std::size_t at = bytes.find(pair_separator);
    pieces.emplace_back(bytes.substr(0, at));
    bytes = at == std::string_view::npos ? "" : bytes.substr(at + pair_separator.size());
  }
  pieces.emplace_back(bytes);
  return pieces;
}

// Puts the scene's hash in the place of the first one in the text, where that has 64 characters:
// else none of what belongs to a changed scene would be looked at.
inline void name_scene(std::string& text, const std::string& scene) {
  constexpr std::size_t digits = 64;
  const std::string name = "\"scene_sha256\":";
  std::size_t at = text.find(name);
  if (at == std::string::npos) return;
  at = text.find('"', at + name.size());
  if (at == std::string::npos || text.find('"', at + 1) != at + 1 + digits) return;
  text.replace(at + 1, digits, sha256_hex(scene));
}

}  // namespace voroproof::internal::fuzz
