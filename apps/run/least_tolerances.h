// How far a history is from the truth: the least tolerances under which it is certified.
//
// They tell chaos from error. The numbers of an engine in doubles drift from the true motion while
// its events stay right, and wider tolerances certify it then; an event that is wrong stays wrong.
#pragma once

#include <functional>

#include "apps/cli/interruption.h"
#include "certify/certificate.h"
#include "certify/options.h"
#include "library/shard_file.h"

namespace voroproof::internal {

// The certificate of the same bytes under other options.
using JudgeAnew = std::function<Certificate(const CertifyOptions&)>;

// Finds the least powers of ten by judging anew, from the tolerances of the certificate in the file
// on: those of times up to a tenth of the horizon and down to the rounding of its times, those of
// velocities from 1e-16 to 1/10; the least of times first. Adds them to the file's run, and a
// remark about them to its certificate. Throws Interrupted.
void add_least_tolerances(ShardFile& file, const CooperativeInterruption& interruption,
                          const JudgeAnew& judge);

}  // namespace voroproof::internal
