// The five data sets of the paper's experiments (section 7.1).
#pragma once

#include <string>

#include "corpus/generate.h"

namespace voroproof::internal {

//   reference    10: 1000 k disks, speed 1, radii uniform over [1, 10], density 0.05, elastic
//   speed        10: 1000 disks of speed k
//   size         10: 1000 disks of radii uniform over [1, k]
//   density      10: 1000 disks at density k / 20
//   restitution   5: 300 disks, restitution (k + 5) / 10 between disks; section 7.1 tells of 1000,
//                    Fig. 22, which shows the experiment, of 300
//
// in all else like the members of `reference`, up to time 1000. The paper leaves open what random
// numbers members share; here those of one seed.
//
// Member k (from 1) of a set. Throws std::invalid_argument for a name or a number that is none.
ReferenceOptions paper_set_member(const std::string& name, int k);

}  // namespace voroproof::internal
