// The proof of parts by the exact truth (docs/certificate.md, Rules 3.23 to 3.25).
#pragma once

#include <optional>

#include "certify/parts.h"
#include "certify/turn_leader.h"

namespace voroproof::internal {

class ExactParts {
 public:
  // All outlive the parts.
  ExactParts(const Scene& scene, const MotionInput& input, const HistoryHeader& header,
             const CertifyOptions& options)
      : scene_(scene), input_(checked_input(input, header)), header_(header), options_(options) {}

  PartTruth truth();

 private:
  bool lead(Part& part, HistorySource& turns, const CertifyOptions& options);
  Certificate prove(Part& part, const CertifyOptions& options) const;
  Certificate rest(Part& part, const CertifyOptions& options) const;

  const Scene& scene_;
  const MotionInput input_;
  const HistoryHeader& header_;
  const CertifyOptions& options_;
  std::optional<TurnLeader> leader_;  // a history of several parts has one
};

}  // namespace voroproof::internal
