// The Voronoi diagram of any disks at rest: they may overlap, lie in each other and coincide, in a
// circle, in a rectangle or in the plane.
#pragma once

#include <memory>
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

// A part of an edge as an arc of a conic, the rational quadratic Bezier curve
// ((1-t)^2 start + 2 t (1-t) weight control + t^2 end) / ((1-t)^2 + 2 t (1-t) weight + t^2) for t
// from 0 to 1. A straight one has the weight 1 and its control in the middle.
struct Arc {
  Vector start{}, control{}, end{};
  double weight = 1;
  // No point of the curve is further than this from the true edge.
  double error = 0;
};

// The size of a cell in a box. No number is further from the true one than its error.
struct Measure {
  double area = 0, perimeter = 0;
  Vector centroid{};
  double area_error = 0, perimeter_error = 0, centroid_error = 0;
};

// The generator whose cell a point is in, and its distance: from the disk's boundary, negative
// inside; from the frame or the wall inwards, negative outside.
struct Nearest {
  int generator = 0;
  double distance = 0;
};

// A circle that no disk and no frame enters, and the generators that it touches, sorted.
struct EmptyCircle {
  Vector center{};
  double radius = 0;
  std::vector<int> generators;
};

// The additively weighted (Apollonius) diagram: the cell of a disk is where its boundary is nearer
// than any other, with a sign inside of disks. A disk is hidden, and has no cell, where another one
// contains it (of equal ones the one of larger id), or where it lies outside of the frame or behind
// a wall, touching it or not.
class VOROPROOF_API StaticDiagram {
 public:
  // In the plane only differences of radii count, which may be negative. In a frame, whose cell is
  // what lies beyond it and of which the id is `container`, radii are >= 0. Numbers are exactly
  // what the doubles are; all decisions are exact. n disks take O(n log n) time where few are
  // hidden by many, and some 600 bytes each. Throws std::invalid_argument, naming the disk, for
  // numbers that are not finite or in magnitude beyond 1e-100 to 1e100, and for negative radii in a
  // frame.
  explicit StaticDiagram(std::vector<Circle> disks, std::optional<Circle> frame = std::nullopt);

  // In a rectangle, the four walls of which are generators, too: the left, the bottom, the right
  // and the top one have the ids n to n+3 for n disks. To a wall the distance is that to its line,
  // positive inside, everywhere in the plane. So cells are cut off by no wall; `cells`, `arcs` and
  // `measures` cut them by their box. Beyond each corner two walls have a vertex at infinity,
  // `container`, of which disks are no neighbours. Edges and vertices there are for any number of
  // disks. Throws as the constructor does in a frame, and for a rectangle without area.
  static StaticDiagram between_walls(std::vector<Circle> disks, const Box& walls);

  const std::vector<Circle>& disks() const { return disks_; }
  const std::optional<Circle>& frame() const { return frame_; }
  const std::optional<Box>& walls() const { return walls_; }

  // By disk: `visible`, else one that hides it and is not hidden itself, or the frame, or the wall
  // of largest id that it is behind.
  static constexpr int visible = -2;
  const std::vector<int>& hosts() const { return hosts_; }
  // Canonical and sorted. Without a circle the id `container` is infinity: the ends of edges that
  // have none, and the edges of cells without end.
  const std::vector<Edge>& edges() const { return edges_; }
  // The vertices, without those at infinity; their circles rounded to nearest. Inside of disks that
  // overlap a circle has a negative radius. They are computed when somebody first asks for them.
  const std::vector<Vertex>& vertices() const;

  // The cells in the box, by disk: closed polygons (the first point is not repeated) that run
  // counterclockwise, whose chords keep within about `tolerance` of the true arcs. A cell that the
  // box cuts in pieces has several; a hidden one, or one that the box misses, none. Throws
  // std::invalid_argument for a box without area or beyond 1e100, and a tolerance less than 1e-9 of
  // its size.
  std::vector<std::vector<std::vector<Vector>>> cells(const Box& box, double tolerance) const;
  // That of all visible disks, and a tenth of its size on each side; in a frame, that of the frame;
  // the walls.
  Box box() const;
  // A thousandth of the box's size.
  static double tolerance(const Box& box);

  // By edge, in the order of edges(), its parts in the box, from its start to its end: arcs of less
  // than a quarter turn and of weights near 1. Where one does not start at the end of the one
  // before the edge leaves the box in between. Ends are in the box, controls may be out of it by
  // the height of an arc. Errors are some roundings of the coordinates, more where disks nearly
  // touch each other from inside. The edges of infinity have no arcs. Throws std::invalid_argument
  // for a box without area or beyond 1e100.
  std::vector<std::vector<Arc>> arcs(const Box& box) const;
  // By disk, its cell in the box, in closed form for the true arcs. Errors are proved, roundings
  // and the quadrature of perimeters (some 1e-8) included. A cell that is hidden or misses the box
  // has zeros, and a centroid that is no number, and so has one whose area is not known to be more
  // than its error; its area and its perimeter are still less than their errors. Where an edge and
  // a side of the box seem to coincide the error of the perimeter may be their length. Powers of
  // two scale all exactly. O(n) time. Throws as arcs() does.
  std::vector<Measure> measures(const Box& box) const;

  // The nearest generator of each point, decided exactly: the disk of least |x - c| - r that is not
  // hidden, or `container` where R - |x - O| is less, O and R the frame's centre and radius, or a
  // wall; of several at one distance that of the largest id. Distances are rounded to nearest.
  // Neighbouring points follow each other through neighbouring cells, so that k points on n disks
  // take O(n + k log k) time and what it takes to look at the neighbours of their cells; ties that
  // doubles cannot compute take some microseconds each. Throws std::invalid_argument, naming the
  // point, for numbers that are not finite or beyond 1e100 in magnitude, and for points in the
  // plane where there is no disk.
  std::vector<Nearest> nearest(const std::vector<Vector>& points) const;

  // The clearance of a place is its distance from the nearest generator: the radius of the largest
  // circle about it that no disk and no frame enters, so that in a frame the circle lies in it.
  //
  // The places in the box at which the clearance is greater than anywhere near in the box, and at
  // least `probe`, the widest first: vertices and far points (docs/queries.md), and on the box's
  // sides corners, points of edges, and those nearest to the frame's centre. Within the box it is
  // decided exactly which places count, and by rounded centres whether they are within; circles
  // that are the same when rounded are one, and so are those of one clearance that an edge joins.
  // On the sides doubles decide, and places within 1e-12 of a side's length are one; the radius is
  // the clearance of the given centre, rounded to nearest. O(n log n) time where few edges meet the
  // sides. Throws std::invalid_argument for a box without area or with numbers beyond 1e100 in
  // magnitude, for a probe that is negative or no number, in the plane where there is no disk, and
  // between walls, for which this is not made.
  std::vector<EmptyCircle> voids(const Box& box, double probe) const;
  // The first of voids() for the probe 0, if there is one: none where disks cover the box. Up to
  // roundings of some 1e-12 of the largest coordinate, radius and side its circle is the largest
  // one. Throws as voids() does.
  std::optional<EmptyCircle> largest_empty_circle(const Box& box) const;

  // The cells as a feature collection of GeoJSON (RFC 7946), a feature a disk, without geometry
  // where it has no cell in the box. Properties are `disk`, `x`, `y`, `radius`, `hidden_by` of a
  // hidden disk, and further columns: names, and a text for each disk. Throws as cells() does, and
  // std::invalid_argument for a column of another length.
  using Column = std::pair<std::string, std::vector<std::string>>;
  std::string geojson(const Box& box, double tolerance,
                      const std::vector<Column>& columns = {}) const;

 private:
  StaticDiagram(std::vector<Circle> disks, std::optional<Circle> frame, std::optional<Box> walls);

  std::vector<Circle> disks_;
  std::optional<Circle> frame_;
  std::optional<Box> walls_;
  std::vector<int> hosts_;
  std::vector<Edge> edges_;
  struct Vertices;
  std::shared_ptr<Vertices> vertices_;
};

}  // namespace voroproof
