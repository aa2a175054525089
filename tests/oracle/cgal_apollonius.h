// The Voronoi diagram of disks without a container by CGAL's Apollonius_graph_2, every decision
// of which is made in exact rational arithmetic.
//
// A disk inside another is hidden for CGAL, so the container cannot be a generator there. What
// can be compared is what the container leaves alone: it removes exactly the vertices whose
// circle it does not contain, and adds only vertices of its own.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "tests/oracle/circle.h"

namespace voroproof::oracle {

struct CgalVertex {
  // Counterclockwise by contact points, smallest id first; checked against the circle.
  Triple generators;
  Circle circle;
};

struct CgalDiagram {
  std::vector<CgalVertex> vertices;
  // Canonical edges between two finite vertices.
  std::set<Quadruple> edges;
};

// The diagram of the disks, which must be pairwise disjoint or touching (points may not touch).
// Where four or more disks are cotangent, CGAL's own perturbation chooses. The container only
// sets the scale of the computation of the circles. Throws std::invalid_argument on other
// input, and std::logic_error if some face has no circle with its contacts counterclockwise.
CgalDiagram cgal_diagram(const std::vector<ExactCircle>& disks, const ExactCircle& container);

// Whether `edges`, a diagram of the disks in the container, fits CGAL's:
// - its vertices without the container are CGAL's, but for the choice among cotangent disks;
// - at every circle strictly inside the container both have the same number of vertices;
// - its edges that join two CGAL vertices and do not involve the container are CGAL's;
// - CGAL's edges that join two of its vertices whose circles are strictly inside are all there.
// The last holds because the container never cuts such an edge in its middle. If it took a point
// m of the edge of l and r, it would take the ray from m away from O, since the region it leaves
// to the disks is a union of ellipses that all contain O. But the segments from the edge's ends
// to the centres of l and r, which the disks keep, surround m.
// `why`, when given, receives the first difference.
bool agrees_with_cgal(const std::vector<ExactCircle>& disks, const ExactCircle& container,
                      const std::vector<Quadruple>& edges, std::string* why);

}  // namespace voroproof::oracle
