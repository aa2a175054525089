// Scenes in which an edge collapses at the very instant at which one of its generators turns.
#pragma once

#include "tests/adversary/families.h"

namespace voroproof::internal::adversary {

// Adds four to six disks and points that are tangent to one circle at an instant, with binary
// numbers throughout. Some of them have a maneuver then, or are hit by another disk. The instant
// may be 0, or the horizon.
void add_round(SceneData& s, Random& random);

}  // namespace voroproof::internal::adversary
