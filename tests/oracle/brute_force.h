// The Voronoi diagram of disks in a container at one instant, straight from its definition:
// every circle tangent to three generators that is empty of all others is a vertex, and walking
// around each generator joins vertices by edges.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "tests/oracle/circle.h"

namespace voroproof::oracle {

// An empty tangent circle and all generators that touch it, in counterclockwise order of their
// contact points, smallest id first. Three of them make one vertex, more a cotangent class that
// a diagram resolves into (contacts - 2) vertices at the same place.
struct CotangentClass {
  Circle circle;
  std::vector<int> contacts;
};

struct BruteDiagram {
  int disk_count = 0;
  // Whether some class has more than three contacts.
  bool degenerate = false;
  // Sorted by contacts.
  std::vector<CotangentClass> classes;
  // Edges between distinct classes: [l, r, a, b] goes from class a to class b (indices) with
  // generator l on its left and r on its right; the smaller of [l, r, a, b] and [r, l, b, a].
  std::set<std::array<int, 4>> links;
  // Canonical edges [l,r,s,e]. Empty when degenerate: then they are not determined.
  std::set<Quadruple> edges;

  // The vertices when not degenerate.
  std::set<Triple> vertices() const;
};

// The diagram of `disks` (ids 0 ... n-1) in `container` (id -1), which must be pairwise disjoint
// or touching. Radii may be 0, but then the point must not touch anything. Contacts closer than
// 1e-60 of the container's radius count as exact. With fewer than two disks there is nothing.
// Throws std::invalid_argument on other input, and std::logic_error when the result fails its
// own checks: Euler's formula, and each edge found from both of its sides.
// Costs O(n^3) circles, each dismissed by at most O(n) operations in double.
BruteDiagram brute_force_diagram(const std::vector<Circle>& disks, const Circle& container);

// Whether `edges`, each under either of its names, is the diagram `truth`. In the degenerate
// case: whether the vertices that the edges name triangulate every cotangent class, the edges
// join each vertex to three others, and the edges between classes are those of the truth.
// `why`, when given, receives the first difference.
bool agrees(const BruteDiagram& truth, const std::vector<Quadruple>& edges, std::string* why);

}  // namespace voroproof::oracle
