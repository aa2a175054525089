// Facts over a window of time: neighbours, least gaps. See paths.h for the motion meant.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "exact/enclosure.h"
#include "library/queries/history_cursor.h"
#include "library/queries/paths.h"

namespace voroproof::internal {

// A window of time, from a time >= 0 to one within what the history covers.
struct Window {
  Rational from, to;
};

struct Neighbourhood {
  GenId generator;
  Rational from, to;  // as the history records them, or an end of the window
};

// The spells in which each generator's cell shares an edge with that of the disk, by generator and
// time; spells of no length within several flips at one time are left out. Moves the cursor.
// O(k + n) steps for k events and degree d: O(k d).
std::vector<Neighbourhood> neighbours_over(HistoryCursor& history, GenId disk,
                                           const Window& window);

struct LeastGap {
  GenId i, j;  // i < j
  Rational t;  // the first time at which it is reached
  // The squared distance of the centres then; the gap is its root less the radii (for the container
  // the container's radius less the disk's and it). At a contact of the paths it is zero.
  Rational distance2;
  bool contact;
};

LeastGap least_gap(const Paths& paths, GenId i, GenId j, const Window& window);

Enclosure gap_of(const Paths& paths, const LeastGap& least);

// The gap of two generators on their paths at t >= 0, rounded to nearest, or next to that where
// 1024 bits do not say which of two binary64 is nearer.
double gap_at(const Paths& paths, GenId i, GenId j, const Rational& t);

}  // namespace voroproof::internal
