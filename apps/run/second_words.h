// Second checkers are asked beside the certifier, up to a limit.
#pragma once

#include <string>
#include <vector>

#include "apps/cli/interruption.h"
#include "apps/run/second_checker.h"
#include "library/shard_file.h"

namespace voroproof::internal {

// Makes it that of a history that is not judged to its end. What it says of the files stays.
void undecide(Certificate& certificate, const std::string& reason, std::int64_t prefix_events,
              double prefix_t);

// Asks them of the files that the certificate names, and makes it that of all checkers, undecided
// at a limit. Throws Interrupted.
SecondWords second_words(const std::vector<SecondChecker>& seconds, const CertifyOptions& options,
                         const CooperativeInterruption& interruption, ShardFile& file);

}  // namespace voroproof::internal
