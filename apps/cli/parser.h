// Reads a command line by what its verbs say of themselves.
#pragma once

#include <string>
#include <vector>

#include "apps/cli/verb.h"

namespace voroproof::internal {

// Hands on what the command line gives to the options of the verb that it names, in the order in
// which they were added, and returns the verb. Where it asks for help or for the version, that is
// written to stdout, and null is returned. Throws UsageError where it does not parse.
const Verb* parse(Verb& program, int argc, const char* const* argv);

// The help of the verb that `words` name from the program on; of the program without any. Throws
// UsageError where there is no such verb.
std::string help_text(Verb& program, const std::vector<std::string>& words);

}  // namespace voroproof::internal
