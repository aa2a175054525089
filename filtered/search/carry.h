// Which isometries carry the states of some disks onto those of others, by the pasts they came of.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "exact/isometry.h"
#include "filtered/motion/motion.h"

namespace voroproof::internal {

// A state of a generator: the motion since a record of the log, or the initial one
// (Motion::state_id). The container has only the initial one.
struct DiskState {
  GenId g;
  int id;
  bool operator==(const DiskState&) const = default;
};
using QuadStates = std::array<DiskState, 4>;
using PairStates = std::array<DiskState, 2>;

// Isometries that certainly carry the motion of from[k] onto that of to[k], for every k: of each
// kind one, if there are any. Precondition: as many states in both, at least one.
std::vector<Isometry> carry(const Motion& motion, std::span<const DiskState> from,
                            std::span<const DiskState> to);

// Whether a generator in this state certainly is at rest: it was when it last had a rational
// velocity, and has been no more than the middle of cradles since.
bool at_rest(const Motion& motion, DiskState s);

// The state in which generator g was just before the log's records beyond the first `records`.
DiskState state_before(const Motion& motion, DiskState s, int records);

// Looks at the collisions beyond the log's first `records`, all of one instant between lo and hi.
// Finds those that share a disk and whose outcome certainly does not depend on their order, and
// notes them in the motion; from then on the outcome is carried in whichever order they were
// processed.
//   - Their normals are at right angles, because a quarter turn carries the one pair onto the
//   other.
//   - They make a cradle (Cradle, filtered/motion/collision_relations.h), as a half turn about the
//   middle shows.
void note_relations(Motion& motion, int records, double lo, double hi);

}  // namespace voroproof::internal
