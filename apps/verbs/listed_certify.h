// certify --list: what one run of the list is.
#pragma once

#include "apps/run/list_run.h"

namespace voroproof::internal {

// The command line of a run, and what its report says of how far the history is proved.
extern const ListedVerb listed_certify;

}  // namespace voroproof::internal
