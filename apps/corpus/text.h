// The cases of the corpus in words.
#pragma once

#include <string>
#include <vector>

#include "apps/corpus/case.h"

namespace voroproof::internal {

// A table of the cases, a line each. Throws InputError where a scene cannot be read.
std::string list_text(const std::vector<CorpusCase>& cases);

// Everything about a case: its story, its scene, its events, what is expected, where it is.
// Throws InputError where one of its files cannot be read.
std::string case_text(const CorpusCase& c);

}  // namespace voroproof::internal
