// The Voronoi diagram of any disks at rest: they may overlap, lie in each other and coincide, in a
// circle or in the plane.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "voroproof/diagram.h"
#include "voroproof/export.h"

namespace voroproof {

struct Circle {
  Vector center{};
  double radius = 0;
};

// Its lower left corner and its upper right one.
struct Box {
  Vector low{}, high{};
};

// The additively weighted (Apollonius) diagram: the cell of a disk is where its boundary is nearer
// than any other, with a sign inside of disks. A disk is hidden, and has no cell, where another one
// contains it (of equal ones the one of larger id), or where it lies outside of the frame.
class VOROPROOF_API StaticDiagram {
 public:
  // In the plane only differences of radii count, which may be negative. In a frame, whose cell is
  // what lies beyond it and of which the id is `container`, radii are >= 0. Numbers are exactly
  // what the doubles are; all decisions are exact. n disks take O(n log n) time where few are
  // hidden by many, and some 600 bytes each. Throws std::invalid_argument, naming the disk, for
  // numbers that are not finite or in magnitude beyond 1e-100 to 1e100, and for negative radii in a
  // frame.
  explicit StaticDiagram(std::vector<Circle> disks, std::optional<Circle> frame = std::nullopt);

  const std::vector<Circle>& disks() const { return disks_; }
  const std::optional<Circle>& frame() const { return frame_; }

  // By disk: `visible`, else one that hides it and is not hidden itself, or the frame.
  static constexpr int visible = -2;
  const std::vector<int>& hosts() const { return hosts_; }
  // Canonical and sorted. In the plane the id `container` is infinity: the ends of edges that have
  // none, and the edges of cells without end.
  const std::vector<Edge>& edges() const { return edges_; }
  // The vertices, without those at infinity; their circles rounded to nearest. Inside of disks that
  // overlap a circle has a negative radius.
  const std::vector<Vertex>& vertices() const { return vertices_; }

  // The cells in the box, by disk: closed polygons (the first point is not repeated) that run
  // counterclockwise, whose chords keep within about `tolerance` of the true arcs. A cell that the
  // box cuts in pieces has several; a hidden one, or one that the box misses, none. Throws
  // std::invalid_argument for a box without area, and a tolerance less than 1e-9 of its size.
  std::vector<std::vector<std::vector<Vector>>> cells(const Box& box, double tolerance) const;
  // That of all visible disks, and a tenth of its size on each side; in a frame, that of the frame.
  Box box() const;
  // A thousandth of the box's size.
  static double tolerance(const Box& box);

  // The cells as a feature collection of GeoJSON (RFC 7946), a feature a disk, without geometry
  // where it has no cell in the box. Properties are `disk`, `x`, `y`, `radius`, `hidden_by` of a
  // hidden disk, and further columns: names, and a text for each disk. Throws as cells() does, and
  // std::invalid_argument for a column of another length.
  using Column = std::pair<std::string, std::vector<std::string>>;
  std::string geojson(const Box& box, double tolerance,
                      const std::vector<Column>& columns = {}) const;

 private:
  std::vector<Circle> disks_;
  std::optional<Circle> frame_;
  std::vector<int> hosts_;
  std::vector<Edge> edges_;
  std::vector<Vertex> vertices_;
};

}  // namespace voroproof
