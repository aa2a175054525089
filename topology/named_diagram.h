// A diagram whose edges are found by their names, for who follows a history.
#pragma once

#include <array>
#include <cstddef>
#include <unordered_map>

#include "topology/diagram.h"

namespace voroproof {

class NamedDiagram {
 public:
  using HalfEdge = Diagram::HalfEdge;

  explicit NamedDiagram(Diagram diagram);

  // Flips the edge of this name and returns it: one half-edge of it. Throws std::invalid_argument,
  // with the reason, where that is no flip of the diagram.
  HalfEdge flip(const Quad& q);

  const Diagram& diagram() const { return diagram_; }
  Diagram take() { return std::move(diagram_); }

 private:
  struct TripleHash {
    std::size_t operator()(const Triple& v) const;
  };

  // The three generators of the vertex on the left of h, from the start of h.
  Triple corner(HalfEdge h) const { return {diagram_.org(h), diagram_.dest(h), diagram_.apex(h)}; }
  // The half-edges of the two dual triangles at h.
  std::array<HalfEdge, 6> sides(HalfEdge h) const;

  Diagram diagram_;
  std::unordered_map<Triple, HalfEdge, TripleHash> corners_;
};

}  // namespace voroproof
