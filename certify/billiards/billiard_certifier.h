// The certifier of billiards: whether the collisions and maneuvers of a history are those of its
// recorded paths, or those of the true motion of the scene (docs/claim.md, section 9).
//
// The claims are read in windows of time. Each is held against the truth, and then all pairs that
// may meet are followed through the window (billiard_truth.h).
#pragma once

#include <string>

#include "certify/certificate.h"
#include "certify/options.h"
#include "history/billiard_history.h"

namespace voroproof::internal {

// Throws InputError, naming `scene_file`, where disks overlap at the start or leave the frame, and
// Undecided where there are too many images to tell.
void require_placement(const Billiard& billiard, const std::string& scene_file);

// Judges the history to its end. Options: the truth, tolerances, the monitor, the bits of numbers,
// and whether doubles decide where they can; all events are judged. Throws what
// require_placement() does, and CertificationInterrupted.
Certificate certify_billiard(const Billiard& billiard, const std::string& scene_file,
                             BilliardHistoryReader& history, const CertifyOptions& options);

}  // namespace voroproof::internal
