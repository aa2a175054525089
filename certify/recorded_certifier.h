// The certifier of the recorded truth. It computes no motion: each disk is on the line that its
// last claim gives it.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "certify/certificate.h"
#include "certify/options.h"
#include "certify/shard.h"
#include "history/history_source.h"
#include "history/scene.h"

namespace voroproof::internal {

// The history's horizon and the scene's, where they differ by more than the file can say: what a
// certificate tells of them (Certificate::other_horizon).
std::optional<std::array<Rational, 2>> other_horizon(const Rational& of_scene,
                                                     const HistoryHeader& header);

// Does what certify() does (certify/certifier.h) for options.truth == Truth::recorded.
Certificate certify_recorded(const Scene& scene, HistorySource& history,
                             const CertifyOptions& options);

// Does what certify() does around the proof of the claims.
Certificate certify_by(
    const Scene& scene, HistorySource& history, const CertifyOptions& options,
    const std::function<Certificate(const MotionInput&, const CertifyOptions&)>& prove);

// The history read is not the one of which something is known already, or not with these options.
struct OtherHistory {};

// Certifies one shard of the history, under the recorded truth and of all events (else
// std::invalid_argument). What is before the shard is read and taken at its word. Put together in
// their order (append), the certificates of all shards, up to the first that is not `certified`,
// are that of certify(), if each shard begins at the cut at which the one before it ends. Throws as
// certify(), and OtherHistory where the history does not lead to task.from.
Shard certify_shard(const Scene& scene, HistorySource& history, const CertifyOptions& options,
                    const ShardTask& task);

}  // namespace voroproof::internal
