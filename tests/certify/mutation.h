// Single faults in a right history, and changes that keep its meaning.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "tests/certify/claimed_history.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {

enum class Mutation {
  time_beyond_tolerance,
  swapped_neighbours,
  dropped_flip,
  duplicated_flip,
  inserted_flip,
  shadow_flip_as_real,
  flip_and_its_reversal,
  wrong_quadruple,
  rotated_quadruple,
  mirrored_quadruple,
  same_four_generators,
  dropped_flip_and_return,
  missed_three_to_two,
  dropped_collision,
  inserted_collision,
  wrong_pair,
  velocity_off,
  energy_preserving_response,
  exchanged_velocities,
  center_off,
  wrong_initial_diagram,
  dropped_tail,
  wrong_counts,
  dropped_maneuver,
  changed_maneuver,
  count
};
inline constexpr std::array<std::string_view, static_cast<int>(Mutation::count)> mutation_names{
    "time beyond the tolerance",
    "swapped neighbours",
    "dropped flip",
    "duplicated flip",
    "inserted flip",
    "shadow flip as real",
    "inserted flip and its reversal",
    "wrong quadruple",
    "rotated quadruple",
    "mirrored quadruple",
    "other edge of the same four",
    "dropped flip and its return",
    "missed 3-to-2",
    "dropped collision",
    "inserted collision",
    "wrong pair",
    "velocity off by 1e-6",
    "energy-preserving wrong response",
    "exchanged velocities",
    "centre off",
    "wrong initial diagram",
    "dropped tail",
    "wrong counts",
    "dropped maneuver",
    "changed maneuver"};

// One such fault at a random place, or nothing where the history has no place for it. `slack`: how
// far the true times may lie from those of `right`.
std::optional<ClaimedHistory> mutate(const Scene& scene, const ClaimedHistory& right, Mutation kind,
                                     double tolerance, double slack, Random& random);

}  // namespace voroproof::internal::testing
