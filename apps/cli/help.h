// voroproof help: the help of a verb, or of all verbs as data.
#pragma once

#include "apps/cli/verb.h"

namespace voroproof::internal {

// Adds the verb to the program, about which it tells.
void add_help(Verb& program);

}  // namespace voroproof::internal
