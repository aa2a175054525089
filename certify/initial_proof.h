// The proof that a set of edges is the Voronoi diagram of the disks at one instant.
//
// docs/certificate.md (section 4, Lemma 6.10) proves that the following is enough:
//   0. no two neighbours have a tangency of the wrong sign, or none;
//   1. the incidences are those of a triangulation of the sphere by all generators;
//   2. the tangent circle of every vertex exists;
//   3. around every generator the vertices of its cell turn once, counterclockwise seen from a
//      disk's centre, clockwise seen from the container's; beside a wall they follow each other
//      along it from its one vertex at infinity to the other;
//   4. every edge is locally legal; where its four generators are cotangent, legal just after.
#pragma once

#include <optional>
#include <string>

#include "exact/topology/diagram.h"
#include "filtered/motion/motion.h"
#include "filtered/numbers/stats.h"
#include "filtered/search/framed.h"

namespace voroproof::internal {

struct InitialFault {
  std::string truth;         // states the fault in words
  std::optional<Quad> edge;  // the edge or, below, the vertex or the cell it is about
  std::optional<Triple> vertex;
  std::optional<GenId> conflict;  // the generator inside the vertex's circle
  std::optional<GenId> cell;
};

// Checks 0 and 2 to 4 for the sites at time t of a diagram of motion.size() >= 2 disks, whose
// incidences (point 1) are valid. Where no fault is found, there provably is none. `motion` is the
// motion just after t. So many threads work on it, which changes nothing that is found. Throws
// Undecided, also where point 0 fails: there is no diagram then.
std::optional<InitialFault> initial_fault(const Diagram& diagram, Motion& motion, const Rational& t,
                                          TierCounts& counts, int threads);

// The same at t = 0 for disks that rest for ever and of which none lies in another or outside of
// the frame, touching it from inside or not. They may overlap. Edges of which both circles touch
// all four generators are not judged: other edges in their place are as right.
std::optional<InitialFault> resting_fault(const Diagram& diagram, Frame frame, const Motion& motion,
                                          TierCounts& counts, int threads);

}  // namespace voroproof::internal
