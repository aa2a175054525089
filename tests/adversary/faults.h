// What may go wrong in a world, once, before it goes on.
#pragma once

#include <array>
#include <string_view>

namespace voroproof::internal::adversary {

enum class FaultKind {
  none,
  // Collisions.
  miss_collision,    // the disks pass through each other
  late_collision,    // by `amount`
  early_collision,   // by `amount`
  false_collision,   // of a pair that passes at a distance of at most `amount`
  twice_collision,   // the line is written twice
  collision_at_end,  // one after the horizon, by less than `amount`, is claimed at it
  miss_at_start,     // a pair that touches and approaches at 0 is left out
  late_at_start,     // collisions of 0 are claimed at `amount`, after a diagram made without them
  miss_at_maneuver,  // a pair that touches and approaches from a maneuver on
  miss_several,      // each collision with probability one half
  all_late,          // all collisions, by `amount`
  // The law.
  restitution,        // another, by `amount`, at one collision
  mass,               // of one disk times 1 + amount
  radius,             // of one disk times 1 + amount
  masses_exchanged,   // of one pair
  old_normal,         // the normal of `amount` before
  float_velocities,   // rounded to binary32
  stranger_velocity,  // one collision's velocities are off by `amount`
  // Flips.
  miss_flip,       // the edge stays
  late_flip,       // by `amount`
  all_flips_late,  // by `amount`
  early_flip,      // by `amount`
  shadow_flip,     // a root of the cotangency that is no flip
  other_edge,      // of two with the same CDP or TDP
  back_and_forth,  // an edge flips and flips back
  // Order and start.
  wrong_order,    // an event is taken after the next one, at that one's time
  mirrored,       // all quadruples are of the mirror image
  mirrored_flip,  // those of some flips
  wrong_initial,  // edges of the first diagram are flipped
  later_initial,  // the diagram of `amount` later
  // Maneuvers.
  forget_maneuver,  // no line, no turn
  silent_maneuver,  // a line, no turn
  late_maneuver,    // by `amount`
  early_maneuver,   // by `amount`
  twice_maneuver,   // the line is written twice
  count
};

inline constexpr std::array<std::string_view, static_cast<int>(FaultKind::count)> fault_names{
    "none",
    "miss collision",
    "late collision",
    "early collision",
    "false collision",
    "twice collision",
    "collision at end",
    "miss at start",
    "late at start",
    "miss at maneuver",
    "miss several",
    "all late",
    "restitution",
    "mass",
    "radius",
    "masses exchanged",
    "old normal",
    "float velocities",
    "stranger velocity",
    "miss flip",
    "late flip",
    "all flips late",
    "early flip",
    "shadow flip",
    "other edge",
    "back and forth",
    "wrong order",
    "mirrored",
    "mirrored flip",
    "wrong initial",
    "later initial",
    "forget maneuver",
    "silent maneuver",
    "late maneuver",
    "early maneuver",
    "twice maneuver"};

inline std::string_view name(FaultKind kind) { return fault_names[static_cast<std::size_t>(kind)]; }

struct Fault {
  FaultKind kind = FaultKind::none;
  int nth = 0;        // of the events that it could befall: this one, from 0
  double amount = 0;  // see above; of times, lengths or a ratio
};

}  // namespace voroproof::internal::adversary
