// Where the edges of a diagram of disks at rest lead. In the plane those of vertices at infinity
// are cut beyond a box.
#pragma once

#include <map>
#include <optional>

#include "filtered/search/framed.h"
#include "history/diagram_file.h"
#include "library/bisector_arcs.h"
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

  // Precondition: l is a disk or, with another wall or infinity, a wall. The edge between a disk
  // and infinity leads around the disk.
  EdgeCourse course(const Quad& q) const;

  // The walls follow the disks in the file, each as a place on it.
  bool is_wall(GenId g) const { return framed_.is_wall(g); }
  WallLine wall(GenId g) const;
  // That of r as seen from the disk l.
  GeneratorRow<double> wall_row(const Quad& q) const;
  // Where a vertex is, which is not at infinity or is one of the walls' there.
  Vec2 place(const Triple& name) const;

 private:
  Vec2 far_end(const Quad& q, bool at_end) const;
  template <class T, class Number>
  TangentTriple<T> line(const Triple& name, const Number& number) const;
  bool is_left(const Triple& name, const Quad& q) const;
  Vec2 joint(const Triple& name) const;
  Points rim(const Quad& q) const;

  void add_corners();

  bool plane_;
  Framed framed_;
  double far_;
  DiagramFile file_;
  std::map<Triple, Vec2> finite_, infinite_;
};

}  // namespace voroproof::internal
