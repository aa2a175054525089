#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

#include "exact/names.h"
#include "library/edge_points.h"
#include "library/values.h"
#include "voroproof/diagram.h"

namespace voroproof {
namespace internal {
namespace {

void require_meaningful(const voroproof::Diagram& diagram, double tolerance) {
  // Finer than that, points differ by their rounding.
  constexpr double least = 1e-9;
  if (!(tolerance >= least * diagram.container_radius) || !std::isfinite(tolerance)) {
    throw std::invalid_argument("tolerance: less than 1e-9 of the container's radius");
  }
  const int disks = static_cast<int>(diagram.disks.size());
  for (const voroproof::Edge& edge : diagram.edges) {
    for (const int g : {edge.l, edge.r, edge.s, edge.e}) {
      if (g < container_id || g >= disks) {
        throw std::invalid_argument("diagram: there is no generator " + std::to_string(g));
      }
    }
  }
}

std::vector<Points> edges_of(const DiagramFile& file, double tolerance) {
  std::map<Triple, Vec2> vertices;
  for (const DiagramVertex& v : file.vertices) vertices.emplace(canonical(v.generators), v.center);
  std::vector<Points> all;
  all.reserve(file.edges.size());
  for (const Quad& edge : file.edges) {
    const auto start = vertices.find(start_vertex(edge)), end = vertices.find(end_vertex(edge));
    if (start == vertices.end() || end == vertices.end())
      throw std::invalid_argument("diagram: edge " + text_of(edge) + " ends at no vertex");
    all.push_back(edge_points(file, edge, start->second, end->second, tolerance));
  }
  return all;
}

}  // namespace
}  // namespace internal

std::vector<std::vector<Vector>> edge_polylines(const Diagram& diagram, double tolerance) {
  internal::require_meaningful(diagram, tolerance);
  return internal::edges_of(internal::diagram_file(diagram), tolerance);
}

std::vector<std::vector<Vector>> cell_polygons(const Diagram& diagram, double tolerance) {
  internal::require_meaningful(diagram, tolerance);
  const internal::DiagramFile file = internal::diagram_file(diagram);
  if (file.disks.size() == 1) {
    const internal::Points disk = internal::only_cell(file, tolerance);
    return {disk, {disk.rbegin(), disk.rend()}};
  }
  return internal::cells_between(file, internal::edges_of(file, tolerance));
}

}  // namespace voroproof
