// Where the edges of a diagram of disks at rest lead. In the plane those of vertices at infinity
// are cut beyond a box.
#pragma once

#include <map>
#include <optional>

#include "exact/predicates.h"
#include "history/diagram_file.h"
#include "library/edge_points.h"
#include "voroproof/static_diagram.h"

namespace voroproof::internal {

// From the start of an edge to its end: straight from point to point of `before`, then along the
// bisector from `start` to `end`, and straight on to the points of `after`. All points but vertices
// are beyond the box, and so are the ways between them; cut ends are about on the bisector.
struct EdgeCourse {
  struct Curve {
    Vec2 start, end;
    bool start_is_cut, end_is_cut;
  };
  Points before{};
  std::optional<Curve> curve{};
  Points after{};
};

class EdgeCourses {
 public:
  // All coordinates are divided by `unit`, a power of two.
  EdgeCourses(const StaticDiagram& diagram, const Box& box, double unit = 1);

  const DiagramFile& file() const { return file_; }
  // Cut ends are this far away from the origin at least, 16 times as far as the box and the
  // disks.
  double far() const { return far_; }

  // Precondition: l is a disk. The edge between it and infinity leads around the disk.
  EdgeCourse course(const Quad& q) const;

 private:
  Vec2 far_end(const Quad& q, bool at_end) const;
  template <class T, class Number>
  TangentTriple<T> line(const Triple& name, const Number& number) const;
  bool is_left(const Triple& name, const Quad& q) const;
  Vec2 joint(const Triple& name) const;
  Points rim(const Quad& q) const;

  bool plane_;
  double far_;
  DiagramFile file_;
  std::map<Triple, Vec2> finite_, infinite_;
};

}  // namespace voroproof::internal
