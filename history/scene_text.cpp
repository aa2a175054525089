#include "history/scene_text.h"

namespace voroproof::internal {

std::string pair_text(const Rational& x, const Rational& y) {
  return '[' + number_text(x) + ", " + number_text(y) + ']';
}

std::string seed_text(const std::variant<std::string, Integer>& seed) {
  if (const auto* text = std::get_if<std::string>(&seed)) return string_text(*text);
  return std::get<Integer>(seed).get_str();
}

std::string members_of(const std::map<std::size_t, Extensions>& extensions, std::size_t index) {
  const auto found = extensions.find(index);
  return found == extensions.end() ? std::string() : members_text(found->second, true);
}

}  // namespace voroproof::internal
