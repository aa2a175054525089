// The edges of a diagram of disks at rest as arcs with bounds of their errors.
#pragma once

#include "library/bisector_arcs.h"
#include "library/edge_courses.h"
#include "voroproof/static_diagram.h"

namespace voroproof::internal {

// All in units of `unit()`, a power of two near the largest coordinate of the disks and the box: so
// powers of two scale results exactly.
class DiagramArcs {
 public:
  DiagramArcs(const StaticDiagram& diagram, const Box& box);

  double unit() const { return unit_; }
  const Box& box() const { return box_; }
  Circle disk(GenId id) const;
  // Precondition: there is one.
  Circle frame() const;

  // The edges in the diagram's order, turned so that l is a disk, or else a wall.
  std::vector<Quad> edges() const;
  // From the start of the edge to its end; none between a wall and infinity. Precondition: l is a
  // disk or a wall.
  ArcChain chain(const Quad& q) const;

 private:
  double unit_;
  Box box_;
  EdgeCourses courses_;
};

}  // namespace voroproof::internal
