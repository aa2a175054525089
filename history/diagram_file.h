// Diagram files: the diagram at one instant, with coordinates (docs/formats.md).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "history/events.h"
#include "history/extensions.h"

namespace voroproof::internal {

struct DiagramDisk {
  Vec2 center;
  double radius;
  Vec2 velocity;
};

// The centre and the radius of the vertex's empty tangent circle.
struct DiagramVertex {
  Triple generators;
  Vec2 center;
  double radius;
};

// Coordinates are rounded to nearest. The topology is exact.
struct DiagramFile {
  std::string t_text;  // the exact instant where t is not: "1/3"; else empty
  double t = 0;
  std::string scene_sha256;
  Vec2 container_center{};
  double container_radius = 0;
  std::vector<DiagramDisk> disks;
  std::vector<DiagramVertex> vertices;  // canonical, sorted by generators
  std::vector<Quad> edges;              // canonical, sorted
  Extensions extensions;
};

inline constexpr std::size_t max_diagram_bytes = std::size_t{1} << 30;

// Writes the file, whole or not at all; vertices and edges are written canonical and sorted.
// Throws OutputError.
void write_diagram(const std::string& path, const DiagramFile& diagram);

// Reads a diagram file and checks its form and that vertices and edges belong together: their
// numbers, that each edge's ends are vertices, and that three edges end in each vertex. It does not
// check the geometry. Throws InputError.
DiagramFile read_diagram(const std::string& path);
DiagramFile parse_diagram(std::string_view bytes, const std::string& file_name);

}  // namespace voroproof::internal
