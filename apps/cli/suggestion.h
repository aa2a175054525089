// "Did you mean": the word that was probably meant.
#pragma once

#include <string>
#include <vector>

namespace voroproof::internal {

// The word nearest to `text` of those near to it, by the number of letters that are to be inserted,
// left out, replaced or exchanged with their neighbour; the first of several; empty without one.
// A word is near that takes no more than a third of the text's letters, or begins with the text.
std::string nearest_word(const std::string& text, const std::vector<std::string>& words);

// "; did you mean WORD?", or nothing where no word is near.
std::string suggestion(const std::string& text, const std::vector<std::string>& words);

}  // namespace voroproof::internal
