// A history in parts.
//
// The parts of a history are proved independently: each that its claims are right and that nothing
// is missing between its two ends, given that the diagram and the motion at its beginning are. The
// motion is known from the claims before, under the recorded truth; under the exact truth a leader
// has computed it from them. The parts depend on the file only, not on the number of threads.
#pragma once

#include <functional>

#include "certify/part_reader.h"
#include "certify/recorded_certifier.h"

namespace voroproof::internal {

// How parts are proved, by one of the truths.
struct PartTruth {
  // Proves a part, on any thread.
  std::function<Certificate(Part& part, const CertifyOptions& options)> prove;
  // Comes to the parts in their order before that; `turns`: PartReader::turns(). False where the
  // part is to be judged by `rest`. Null where nothing is to be known before.
  std::function<bool(Part& part, HistorySource& turns, const CertifyOptions& options)> lead{};
  // Where `lead` is: judges a part that is not proved right, and all that follows it. It is the
  // last part now: its claims are all that the history has from its beginning on. Without it the
  // certificate of the part is the last word.
  std::function<Certificate(Part& part, const CertifyOptions& options)> rest{};
};

// Certifies as certify() does of all events, but for what the whole file says.
Certificate certify_in_parts(const Scene& scene, const MotionInput& input, HistorySource& history,
                             const CertifyOptions& options, const PartTruth& truth);

// The same by the recorded truth.
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
