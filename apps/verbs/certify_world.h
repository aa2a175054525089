// The verb certify, for worlds.
#pragma once

#include "apps/cli/verb.h"
#include "apps/verbs/certify_request.h"

namespace voroproof::internal {

// Judges the history of a scene of version 2, whose exact truth is also the recorded one.
ExitCode certify_world(const CertifyRequest& request);

}  // namespace voroproof::internal
