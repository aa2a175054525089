// The Voronoi diagram at one instant.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "voroproof/export.h"
#include "voroproof/extensions.h"
#include "voroproof/history.h"
#include "voroproof/number.h"
#include "voroproof/scene.h"

namespace voroproof {

// A generator at the instant.
struct PlacedDisk {
  Vector center{}, velocity{};
  double radius = 0;
};

// Three generators in counterclockwise order of their contact points, the smallest id first, and
// their empty tangent circle.
struct Vertex {
  std::array<int, 3> generators{};
  Vector center{};
  double radius = 0;
};

// The topology is exact; coordinates are rounded to nearest.
struct Diagram {
  Number t;
  std::string scene_sha256;
  Vector container_center{};
  double container_radius = 0;
  std::vector<PlacedDisk> disks;
  std::vector<Vertex> vertices;  // sorted by generators
  std::vector<Edge> edges;       // canonical and sorted
  Extensions extensions;
};

// The diagram just after all events at t >= 0, by the engine; t may lie beyond the scene's horizon.
// Throws InputError, and Undecided where the engine stops before t.
VOROPROOF_API Diagram diagram_at(const Scene& scene, const Number& t, int max_bits = 32768);

// The diagram at t according to a history of the scene: its initial diagram after its flips up to
// t, the disks where its recorded paths are. Throws InputError, also
// where the history does not cover t and, if `checked`, where an edge is illegal by more than
// tolerances explain. No such edge is no proof; certify the history first.
VOROPROOF_API Diagram diagram_at(const Scene& scene, const History& history, const Number& t,
                                 int max_bits = 32768, bool checked = true);

// The generators whose cells share an edge with that of `generator`, sorted.
VOROPROOF_API std::vector<int> neighbours(const Diagram& diagram, int generator);

// The edges of the diagram, in their order, as chains of points from the start vertex to the end
// vertex, whose chords keep within about `tolerance` of the true arcs. Throws std::invalid_argument
// for a tolerance less than 1e-9 of the container's radius, and where it is no diagram: a vertex is
// missing, say.
VOROPROOF_API std::vector<std::vector<Vector>> edge_polylines(const Diagram& diagram,
                                                              double tolerance);
// The boundaries of the cells of the disks, by their ids, and last of the container, likewise:
// closed polygons (the first point is not repeated) with the cell on the left. That of a disk runs
// counterclockwise, that of the container clockwise, for its cell lies outside of it. Without disks
// it is empty. Throws like edge_polylines().
VOROPROOF_API std::vector<std::vector<Vector>> cell_polygons(const Diagram& diagram,
                                                             double tolerance);

// Reads and writes diagram files (docs/formats.md). Throw InputError, OutputError.
VOROPROOF_API Diagram read_diagram(const std::string& path);
VOROPROOF_API void write_diagram(const std::string& path, const Diagram& diagram);

}  // namespace voroproof
