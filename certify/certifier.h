// The certifier: proves a claimed history, refutes it with evidence, or says what it cannot decide.
//
// It does not simulate. It replays the claimed flips on the claimed initial diagram, moves the
// disks as the truth asked for says, and proves of every edge that it collapses where a flip is
// claimed and nowhere else in its life, and of every adjacent pair that it touches where a
// collision is claimed and nowhere else. docs/certificate.md proves that nothing can be missing
// then. It shares with the engine numbers, predicates, motion and, where doubles do not decide, the
// searches of filtered/search/; not the queue, nor the order of events, nor the first diagram.
#pragma once

#include "certify/recorded_certifier.h"

namespace voroproof::internal {

// Certifies the history against the scene. Throws InputError where the history is not one of its
// format or not of this scene.
Certificate certify(const Scene& scene, HistorySource& history, const CertifyOptions& options);

}  // namespace voroproof::internal
