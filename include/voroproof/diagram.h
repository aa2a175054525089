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
// t, the disks where its last recorded centres and velocities put them. Throws InputError, also
// where the history does not cover t and, if `checked`, where an edge is illegal by more than
// tolerances explain. No such edge is no proof; certify the history first.
VOROPROOF_API Diagram diagram_at(const Scene& scene, const History& history, const Number& t,
                                 int max_bits = 32768, bool checked = true);

// The generators whose cells share an edge with that of `generator`, sorted.
VOROPROOF_API std::vector<int> neighbours(const Diagram& diagram, int generator);

// Reads and writes diagram files (docs/formats.md). Throw InputError, OutputError.
VOROPROOF_API Diagram read_diagram(const std::string& path);
VOROPROOF_API void write_diagram(const std::string& path, const Diagram& diagram);

}  // namespace voroproof
