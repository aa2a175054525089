// The voids of a probe over a window of time: when each comes about and out of which others, when
// it ends and in which others. See paths.h for the motion meant; which edges there are is what the
// history says.
//
// Every void has a vertex of the diagram in it, or a far point (clearance.h): its widest place is
// one. So the voids are the components of a graph of those nodes at which the probe fits, joined
// where it passes along a V-edge from one to the next. Along an edge that graph changes only at
// roots of the polynomials of lines.h. All changes of all edges are put in order exactly, and
// voids before and after each are the same where they have a node in common; at a flip the four
// vertices of the edge, before and after, are one point.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "library/queries/clearance.h"
#include "library/queries/history_cursor.h"
#include "library/queries/over_time.h"
#include "library/queries/paths.h"

namespace voroproof::internal {

struct VoidLife {
  Enclosure from, to;
  // The voids, as indices, out of which it came about: two or more have joined, or one has parted;
  // none where it is there from the start of the window, or where a place has opened for the probe.
  std::vector<std::size_t> before;
  // The voids into which it goes; none at the end of the window, or where it has vanished.
  std::vector<std::size_t> after;
  // A node in it at the beginning, the smallest; none without disks.
  std::optional<ClearanceNode> at;
};

// The lives of the voids in the order in which they come about, at one time by their smallest
// nodes. Instants at which a probe just fits and no longer are left out. The window is not empty.
// Moves the cursor. Throws Undecided where a decision needs more than the budget. For k events and
// d changes of the graph: O(k) isolations of roots and O(d log d) comparisons of them; and at each
// change steps as many as the smaller part has nodes, or the way around the place of the change
// (changing_components.h).
std::vector<VoidLife> void_lives(const Paths& paths, HistoryCursor& history, const Rational& probe,
                                 const Window& window);

}  // namespace voroproof::internal
