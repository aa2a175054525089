// The proof that edges are the diagram of disks at rest, which may overlap and hide each other.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "certify/initial_proof.h"
#include "exact/motion_input.h"

namespace voroproof::internal {

// A claim: the disks as they are at t = 0, in the plane, in the container or, with the four walls
// after the disks (framed.h), in a box.
struct RestingClaim {
  MotionInput input;
  Frame frame = Frame::circle;
  // By disk: `visible_disk`, or a visible one that hides it, or the container. Empty where the
  // claim says nothing of it.
  std::vector<GenId> hosts;
  std::vector<Quad> edges;
};

struct RestingProof {
  std::optional<InitialFault> fault;  // none: the claim is proved
  std::vector<bool> hidden;           // by disk
  int visible = 0;
  // Edges without length, in whose place others are as right; and of these the ones that the rule
  // of the largest id (docs/formats.md, section 3) does not choose.
  std::int64_t points = 0, chosen_otherwise = 0;
};

// Proves or refutes the claim. Throws Undecided where a predicate needs more than the budget.
RestingProof resting_proof(const RestingClaim& claim, const MotionOptions& options,
                           TierCounts& counts, int threads);

}  // namespace voroproof::internal
