// The edges of a diagram file as curves for pictures.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "history/diagram_file.h"

namespace voroproof::internal {

// A cubic Bezier curve by its control points.
using Cubic = std::array<Vec2, 4>;

// The edges of a diagram as curves: arcs of hyperbolas between disks of different
// radii, of ellipses at the container, segments between disks of equal radii.
class EdgeCurves {
 public:
  // The curves keep within about `tolerance` (> 0) of the true arcs. The diagram
  // must outlive this object.
  EdgeCurves(const DiagramFile& diagram, double tolerance);

  // The edge from its start vertex to its end vertex, as a chain of cubics. Throws
  // std::invalid_argument when the diagram has no such generators or vertices.
  std::vector<Cubic> of(const Quad& edge) const;

  // The boundary of the cell of the only disk, counterclockwise: a closed ellipse
  // about the disk's centre and the container's. Precondition: there is one disk.
  std::vector<Cubic> only_cell() const;

 private:
  const DiagramFile& diagram_;
  double tolerance_;
  std::map<Triple, Vec2> vertices_;
};

}  // namespace voroproof::internal
