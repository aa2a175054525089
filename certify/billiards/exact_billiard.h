// The exact truth of billiards: the true motion of the scene (docs/claim.md, section 9).
//
// The claims say who touches next, and are not believed. The disks move on true lines
// (billiard_motion.h), in fractions or in balls of as many bits as it takes:
//
//  1. A claim of a collision is of the first contact of the two on the lines on which they are. Its
//     time, velocities and centres are held against the true ones, and the two turn by the law. A
//     claim of a maneuver is of the one that is scheduled.
//  2. Each pair whose boxes meet in a window of time is followed over all lines that both keep in
//     it: they touch nowhere but where a collision of theirs is claimed (true_lives.h). So the
//     paths obey the law everywhere, and there is one motion that does, where no more than two
//     touch at an instant.
//  3. Where more do, the format has an order, and the same happens to each disk in it as the claims
//     say (true_instant.h). That more than two touch is told in fractions only.
//
// Claims are taken in the order of the file. Those of different disks may be out of order by the
// tolerance: no line depends on it. Where balls do not tell, all is computed anew with twice the
// bits, and nothing that has been found changes.
#pragma once

#include <memory>

#include "certify/billiards/billiard_truth.h"
#include "certify/options.h"

namespace voroproof::internal {

// Both must outlive it. `horizon`: the history's.
std::unique_ptr<BilliardTruth> exact_billiard(const Billiard& billiard, const Rational& horizon,
                                              const CertifyOptions& options);

}  // namespace voroproof::internal
