// Proofs about one pair of generators over an interval of time, in doubles with error bounds.
#pragma once

#include "filtered/motion.h"

namespace voroproof {

// Whether i and j, apart or parting at a, provably do not begin to overlap in (a, b], under their
// present motion. Says nothing when false.
bool proved_apart(const Motion& motion, GenId i, GenId j, double a, double b);

}  // namespace voroproof
