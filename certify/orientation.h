// Quadruplets without orientation, [l,r,e,s] for [l,r,s,e], where both name an edge of the diagram.
#pragma once

#include "certify/replay.h"

namespace voroproof::internal {

// Recorded truth: whether a flip whose quadruplet names one edge means another one, `mirrored`, of
// the same crossing and traversing pairs: that one collapses within the tolerance of the claimed
// time, and the one named does not, on the paths of `replay`. Only a look ahead: whoever relies on
// the diagram that follows compares it with the one that is proved.
bool means_mirrored(const Replay& replay, const Scene& scene, const CertifyOptions& options,
                    const FlipEvent& claim, const Quad& mirrored);

}  // namespace voroproof::internal
