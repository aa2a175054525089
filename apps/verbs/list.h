// --list: a verb for many scenes.
#pragma once

#include <memory>

#include "apps/cli/verb.h"
#include "apps/run/list_run.h"

namespace voroproof::internal {

// Adds --list, --json, --csv and --jobs to a verb that has the arguments `scene` and, or -o for,
// the history; `single` are its outputs of a single run, which do not go with a list.
std::shared_ptr<ListRequest> add_list_options(Verb& verb, const std::vector<std::string>& single);

// Runs the verb for the list, with the options that the verb was given, and says what came out. The
// exit code is that of the worst run.
ExitCode run_listed(const Verb& verb, ListRequest request, const ListedVerb& listed);

}  // namespace voroproof::internal
