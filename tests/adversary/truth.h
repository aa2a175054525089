// What is true of a history, by brute force: the oracle that judges beside the certifier.
//
// It shares nothing with the certifier, and only the formula of a tangent circle with the worlds.
// Paths are 113-bit; diagrams are looked at between claims, by empty circles in long double and,
// where that is near or a finding is to be confirmed, by the brute force of tests/oracle in 200
// digits.
#pragma once

#include <string>
#include <vector>

#include "tests/adversary/claims.h"

namespace voroproof::internal::adversary {

enum class Finding {
  right,    // nothing wrong was found where it was looked
  wrong,    // a rule is broken, beyond all tolerances
  unclear,  // within rounding of a bound, or of what brute force cannot decide
};

struct Opinion {
  Finding finding = Finding::right;
  std::string why;
};

inline constexpr double tolerance = 1e-6;      // of times
inline constexpr double law_tolerance = 1e-9;  // of velocities

// Judges under the motion that the history records. `hints`: instants at which to look, besides.
Opinion judge_recorded(const SceneData& scene, const History& history,
                       const std::vector<double>& hints);

// Judges under the true motion.
Opinion judge_exact(const SceneData& scene, const History& history,
                    const std::vector<double>& hints);

}  // namespace voroproof::internal::adversary
