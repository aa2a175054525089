// When a tunnel is open for a probe and when a void is there: along a V-edge and at a V-vertex,
// over a window of time. See paths.h for the motion meant; which edges there are is what the
// history says.
//
// While the four generators of an edge move on lines, the least clearance along it can pass the
// probe's radius only where the gap of its two generators is twice that radius, or where the circle
// at one of its ends has that radius: where three circles around the generators, widened by the
// probe, meet in a point. These are roots of polynomials of degree 2 and 6, isolated exactly;
// between two of them one exact decision at a rational time tells for all.
#pragma once

#include <array>
#include <vector>

#include "exact/enclosure.h"
#include "library/queries/history_cursor.h"
#include "library/queries/over_time.h"
#include "library/queries/paths.h"

namespace voroproof::internal {

// Open in between; the ends are enclosed. Instants at which the probe just fits and no longer are
// left out.
struct Opening {
  Enclosure from, to;
};

// When some V-edge between the two generators lets the probe pass from end to end. Moves the
// cursor. Throws Undecided where a decision needs more than the budget.
std::vector<Opening> tunnel_openings(const Paths& paths, HistoryCursor& history, GenId i, GenId j,
                                     const Rational& probe, const Window& window);

// When the diagram has the vertex and the probe fits there.
std::vector<Opening> void_openings(const Paths& paths, HistoryCursor& history, const Triple& vertex,
                                   const Rational& probe, const Window& window);

}  // namespace voroproof::internal
