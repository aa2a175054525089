#include "apps/cli/suggestion.h"

#include <algorithm>
#include <cstddef>

namespace voroproof::internal {
namespace {

// The distance of Damerau and Levenshtein without repeated changes of one place.
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> least(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        least[i][j] = i + j;
        continue;
      }
      least[i][j] = std::min({least[i - 1][j] + 1, least[i][j - 1] + 1,
                              least[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        least[i][j] = std::min(least[i][j], least[i - 2][j - 2] + 1);
      }
    }
  }
  return least[a.size()][b.size()];
}

std::size_t dashes(const std::string& text) {
  return std::min(text.find_first_not_of('-'), text.size());
}

}  // namespace

std::string nearest_word(const std::string& text, const std::vector<std::string>& words) {
  constexpr std::size_t longest = 64;  // no word of ours is longer
  const std::size_t letters = text.size() - dashes(text);
  if (text.size() > longest || letters < 2) return {};
  std::string nearest;
  std::size_t least = std::max<std::size_t>(1, letters / 3) + 1;
  for (const std::string& word : words) {
    const std::size_t apart = word.starts_with(text) ? 1 : distance(text, word);
    if (apart < least) {
      least = apart;
      nearest = word;
    }
  }
  return nearest;
}

std::string suggestion(const std::string& text, const std::vector<std::string>& words) {
  const std::string nearest = nearest_word(text, words);
  return nearest.empty() ? "" : "; did you mean " + nearest + "?";
}

}  // namespace voroproof::internal
