// The verb certify, for billiards.
#pragma once

#include "apps/cli/verb.h"
#include "apps/verbs/certify_request.h"

namespace voroproof::internal {

// Judges the collisions of a scene of version 2 whose disks bounce, under the recorded truth.
ExitCode certify_billiard(const CertifyRequest& request);

}  // namespace voroproof::internal
