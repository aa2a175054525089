// A small simulator that errs once and goes on consistently in its own world.
//
// Its numbers are long double. Times and velocities are rounded to binary64 as they come about and
// it lives with these, so that without a fault its history is right of the motion that it records,
// to within 1e-17 of the scene's extent. Flips are formal, as in a careless engine: an edge flips
// where both its in-circle functions change from positive to negative, whether it was legal or
// its circles exist or not; so the world goes on where disks overlap.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tests/adversary/claims.h"
#include "tests/adversary/faults.h"
#include "tests/adversary/geometry.h"

namespace voroproof::internal::adversary {

struct WorldResult {
  History history;
  bool struck = false;        // whether the fault found its place
  std::vector<double> hints;  // instants at which to look
  bool overflow = false;      // more events than allowed: the history ends before the horizon
};

// The history that a world with this fault writes of the scene; nothing where it finds no diagram
// at 0. The scene's horizon is moved where the fault asks for that, and where there would be more
// than `most_lines` lines before it.
std::optional<WorldResult> live(SceneData& scene, const Fault& fault, std::size_t most_lines);

}  // namespace voroproof::internal::adversary
