// The recorded truth, in parts.
//
// Under the recorded truth the motion before a time is known from the claims alone, so that the
// parts of a history are proved independently: each that its claims are right and that nothing is
// missing between its two ends, given that the diagram at its beginning is right. The parts depend
// on the file only, not on the number of threads.
#pragma once

#include "certify/recorded_certifier.h"

namespace voroproof::internal {

// Certifies as certify() does for options.truth == Truth::recorded, but for what the whole file
// says.
Certificate certify_in_parts(const Scene& scene, const MotionInput& input, HistorySource& history,
                             const CertifyOptions& options);

// The same for the parts that the task names. Throws InputError where the history cannot be read as
// far as the shard, OtherHistory where it does not come to the place at which the task goes on.
Shard certify_in_parts(const Scene& scene, const MotionInput& input, HistorySource& history,
                       const CertifyOptions& options, const ShardTask& task);

// The place at which the first part begins.
Cut start_of(const Scene& scene, const MotionInput& input, HistorySource& history,
             const CertifyOptions& options);

}  // namespace voroproof::internal
