// A diagram whose edges are found by their quadruplets.
#pragma once

#include <array>
#include <cstddef>
#include <unordered_map>
#include <utility>

#include "exact/topology/diagram.h"

namespace voroproof::internal {

class NamedDiagram {
 public:
  explicit NamedDiagram(Diagram diagram);

  const Diagram& diagram() const { return diagram_; }
  Diagram take() { return std::move(diagram_); }

  // The half-edge that is named [l,r,s,e] in this direction, or -1.
  Diagram::HalfEdge find(const Quad& q) const;
  bool has(const Quad& q) const { return find(q) >= 0; }

  bool has_vertex(const Triple& v) const { return corners_.contains(v); }

  // Flips the edge of this name and returns it: the half-edge that was so named. A flip is taken
  // back by the flip of flipped(q). Takes O(1) expected time. Throws std::invalid_argument, with
  // the reason, where that is no flip of the diagram.
  Diagram::HalfEdge flip(const Quad& q);

 private:
  struct TripleHash {
    std::size_t operator()(const Triple& v) const;
  };

  // The three generators of the vertex on the left of h, from the start of h: no other half-edge
  // has them.
  Triple corner(Diagram::HalfEdge h) const {
    return {diagram_.org(h), diagram_.dest(h), diagram_.apex(h)};
  }
  // The half-edges of the two dual triangles at h.
  std::array<Diagram::HalfEdge, 6> sides(Diagram::HalfEdge h) const;

  Diagram diagram_;
  std::unordered_map<Triple, Diagram::HalfEdge, TripleHash> corners_;
};

}  // namespace voroproof::internal
