// Where the centre of a probe, a disk of a given radius, can be: the points whose clearance is at
// least that radius (touching is allowed). Its boundary is the offset of the disks and of the
// container; the arcs of that end on V-edges. Its components are the voids; each can be shrunk onto
// the parts of V-edges in it, which is how they are found. A V-edge that the probe can go along
// from end to end is a tunnel. (The paper's section 1 and Fig. 2.)
#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "library/queries/clearance.h"

namespace voroproof::internal {

// The point at which the edge between disk i and generator j has the probe's clearance: on the left
// (side = 1) or the right (-1) of the axis that leads from the centre of i to its gate with j.
struct OffsetPoint {
  GenId i, j;
  int side;
};

// A part of an edge that is free, in the direction of the half-edge: from its start or from a
// point, to its end or to a point.
struct FreePiece {
  Diagram::HalfEdge edge;  // -1: the closed edge around a lone disk
  std::optional<OffsetPoint> from, to;
  std::vector<ClearanceNode> nodes;  // the ends and extremes of the edge in it, in order
};

// An arc of the circle at the probe's distance from a generator, counterclockwise around its
// centre; all of the circle without end points.
struct OffsetArc {
  GenId generator;
  std::optional<OffsetPoint> from, to;
};

struct Void {
  std::vector<Triple> vertices;  // sorted
  std::vector<Quad> tunnels;     // canonical, sorted
  // Where the void's clearance is greatest (the smallest such node): the void vanishes for probes
  // beyond that. Nothing where there are no disks: then that place is the container's centre.
  std::optional<ClearanceNode> widest;
};

class FreeSpace {
 public:
  // The free space of the probe of `clearance`, which must outlive this object. Decides everything;
  // O(n) predicates.
  explicit FreeSpace(Clearance& clearance);

  // The pieces of every even half-edge, or of the one closed edge.
  const std::vector<FreePiece>& pieces() const { return pieces_; }
  // The arcs by generator, the container first; along a generator's circle from one edge to the
  // next.
  std::vector<OffsetArc> offset() const;
  // The voids in the order of their smallest vertices; those without a vertex last.
  std::vector<Void> voids();

  std::array<Enclosure, 2> position(const OffsetPoint& point) const;

 private:
  std::vector<FreePiece> pieces_of(Diagram::HalfEdge h, const std::vector<ClearanceNode>& nodes);
  std::vector<OffsetArc> arcs_of(GenId g) const;

  Clearance& clearance_;
  bool too_wide_ = false;  // without disks: for the container
  std::vector<FreePiece> pieces_;
  std::vector<std::vector<std::size_t>> of_edge_;  // indices into pieces_, by edge
};

// The even half-edges of the diagram by the canonical names of their edges.
std::map<Quad, Diagram::HalfEdge> edges_by_name(const Diagram& diagram);

// The V-edge as a tunnel: the node of its least clearance, beyond which no probe passes.
ClearanceNode narrowest(Clearance& clearance, Diagram::HalfEdge h);

// The nodes of locally greatest clearance, sorted: there a void vanishes as the probe grows. The
// smallest node stands for all that are at one place, or joined by an edge of constant clearance.
std::vector<ClearanceNode> widest_places(Clearance& clearance);

}  // namespace voroproof::internal
