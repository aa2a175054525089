// The true motion of a scene, replayed from the collisions of a history: no search is made.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "filtered/computed/computed_motion.h"
#include "history/events.h"
#include "history/scene.h"

namespace voroproof::internal {

struct ReplayedMotion {
  ComputedMotion motion;  // in force at the exact time t
  // The flips that the history records within a unit in the last place of t, in its order, and
  // whether at t or before it: rounding may have put them on the other side of t than the true
  // motion does.
  std::vector<std::pair<Quad, bool>> near_flips;
};

// The motion that is in force at t, just after what happens then. Every collision recorded up to t
// is proved to be a contact of the true motion next to its recorded time, and those recorded next
// to t are compared with it exactly; that none is missing is taken from the history. Takes O(k + n)
// steps for k events.
// Throws InputError as follow_history() does, and where a collision is not one of the true motion:
// histories in floating point soon leave it. Throws Undecided where a decision needs more than the
// budget.
ReplayedMotion replayed_motion(const Scene& scene, const std::string& history_path,
                               const Rational& t, const MotionOptions& options);

}  // namespace voroproof::internal
