// The output of `certify` about a certificate.
#pragma once

#include <ostream>
#include <string>

#include "apps/cli/verb.h"
#include "apps/run/second_checker.h"
#include "library/shard_file.h"

namespace voroproof::internal {

ExitCode exit_code(Verdict verdict);

// Says what was found, the verdict last, and the reason of a verdict other than CERTIFIED to
// stderr. `shard`: which one it is, as its verdict says it ("SHARD 2/8 "), for the verdict of a
// shard is none of the history; empty for the whole. What the verdict is about and each reservation
// are said also if `quiet`.
void tell(std::ostream& out, const ShardFile& file, const SecondWords& second,
          const std::string& shard, bool quiet);

}  // namespace voroproof::internal
