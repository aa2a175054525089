// The Voronoi diagram of the disks at one instant, from scratch.
//
// Randomized incremental insertion in O(n log n) expected time (spatially coherent
// rounds). A new disk i starts as a cell of two edges on an edge that i's cell
// certainly meets: the ray from a near generator j through the centre of i leaves the
// cell of j there. The part of the old edges in conflict with i is a tree; it is absorbed
// edge by edge, and one edge is absorbed by one flip. All decisions are signs of
// expressions in at most two square roots, behind the same tiers as elsewhere.
// (Conflict regions: Karavelas & Yvinec, "Dynamic additively weighted Voronoi diagrams
// in 2D", ESA 2002.)
#pragma once

#include "exact/topology/diagram.h"
#include "filtered/motion/motion.h"
#include "filtered/numbers/stats.h"
#include "filtered/search/collapse.h"
#include "filtered/search/framed.h"

namespace voroproof::internal {

// The diagram at the exact time t. Where more than three generators touch one empty
// circle it is one of the possible diagrams: see settle().
// Throws Undecided, with the pair, where a point (radius 0) touches another generator: its cell
// has no area, and there is no diagram (of two or more disks).
// Precondition: the states of `motion` are in force at t, the disks do not overlap.
Diagram static_diagram(const Motion& motion, const Rational& t, TierCounts& counts);

// The same of disks that may overlap, but of which none lies in another or outside of the frame,
// touching it from inside or not.
Diagram overlapping_diagram(const Motion& motion, Frame frame, TierCounts& counts);

// Turns a diagram that is right at the instant into the one just after it: flips
// edges with cotangent generators, smallest quadruplet first, until all are legal.
// Returns the number of flips.
long settle(Diagram& diagram, Motion& motion, const Moment& now, TierCounts& counts);

}  // namespace voroproof::internal
