// Which isometries carry the states of some disks onto those of others, by the pasts they came of.
#pragma once

#include <span>
#include <vector>

#include "exact/isometry.h"
#include "filtered/computed/computed_motion.h"
#include "filtered/search/symmetry.h"

namespace voroproof::internal {

// Isometries that certainly carry the motion of from[k] onto that of to[k], for every k: of each
// kind one, if there are any. Precondition: as many states in both, at least one.
std::vector<Isometry> carry(const ComputedMotion& motion, std::span<const DiskState> from,
                            std::span<const DiskState> to);

// Whether a generator in this state certainly is at rest: it was when it last had a rational
// velocity, and has been no more than the middle of cradles since.
bool at_rest(const ComputedMotion& motion, DiskState s);

// The state in which generator g was just before the log's records beyond the first `records`.
DiskState state_before(const ComputedMotion& motion, DiskState s, int records);

// Looks at the collisions beyond the log's first `records`, all of one instant between lo and hi.
// Finds those that share a disk and whose outcome certainly does not depend on their order, and
// notes them in the motion; from then on the outcome is carried in whichever order they were
// processed.
//   - Their normals are at right angles, because a quarter turn carries the one pair onto the
//   other.
//   - They make a cradle (Cradle, filtered/computed/collision_relations.h), as a half turn about
//   the middle shows.
void note_relations(ComputedMotion& motion, int records, double lo, double hi);

}  // namespace voroproof::internal
