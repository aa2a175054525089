// The leader of a history that is proved in parts under the exact truth: it computes the motion
// ahead of the parts' checkers, from the turns that are claimed (docs/certificate.md, Rule 3.23).
// It proves nothing.
#pragma once

#include <memory>
#include <vector>

#include "certify/exact_pairs.h"
#include "certify/options.h"
#include "certify/part_reader.h"
#include "certify/true_turns.h"
#include "filtered/computed/computed_motion.h"

namespace voroproof::internal {

// How the disks move when a part begins, and how they turn in it, if what is claimed before is
// right and this is.
struct LedPart {
  MotionSnapshot motion;
  MotionFacts facts;
  std::shared_ptr<MotionLog> log;
  Births births;
  std::vector<TrueTurn> turns;
};

class TurnLeader {
 public:
  // All outlive the leader; `input` is that of checked_input().
  TurnLeader(const Scene& scene, MotionInput input, const HistoryHeader& header,
             const CertifyOptions& options);
  TurnLeader(const TurnLeader&) = delete;
  TurnLeader& operator=(const TurnLeader&) = delete;

  // The part is the next: tells what it begins with, but for the diagram.
  std::shared_ptr<LedPart> begin(Part& part);
  // The turns of that part, of which these are the claims. False where they do not follow each
  // other as they are claimed: the leader is of no further use then.
  bool lead(const Part& part, HistorySource& claims, std::vector<TrueTurn>& turns);

 private:
  class Course;

  const Scene& scene_;
  const HistoryHeader& header_;
  CertifyOptions options_;
  ComputedMotion motion_;
  Births births_;  // after the parts so far
  Replay replay_;
};

}  // namespace voroproof::internal
