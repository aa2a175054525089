#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "exact/names.h"
#include "library/diagram_geometry.h"
#include "library/edge_curves.h"
#include "library/polylines.h"
#include "library/values.h"
#include "voroproof/diagram.h"

namespace voroproof {
namespace internal {
namespace {

using Points = std::vector<Vec2>;

// Chords of the curve within the tolerance, without its first point. In n equal steps of the
// parameter a chord is off by at most max|B''| / (8 n^2), and |B''| is at most 6 times the second
// differences of the control points.
void append_chords(const Cubic& c, double tolerance, Points& out) {
  const double bend = std::max(length(c[0] - 2 * c[1] + c[2]), length(c[1] - 2 * c[2] + c[3]));
  const int steps = std::max(1, static_cast<int>(std::ceil(std::sqrt(0.75 * bend / tolerance))));
  for (int k = 1; k < steps; ++k) {
    const double t = static_cast<double>(k) / steps, u = 1 - t;
    out.push_back((u * u * u) * c[0] + (3 * u * u * t) * c[1] + (3 * u * t * t) * c[2] +
                  (t * t * t) * c[3]);
  }
  out.push_back(c[3]);
}

Points chords(const std::vector<Cubic>& chain, double tolerance) {
  Points points{chain.front()[0]};
  for (const Cubic& curve : chain) append_chords(curve, tolerance, points);
  return points;
}

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

// Half of the tolerance is for the curves and half for their chords.
std::vector<Points> edge_points(const DiagramFile& file, double tolerance) {
  const EdgeCurves curves(file, tolerance / 2);
  std::vector<Points> all;
  all.reserve(file.edges.size());
  for (const Quad& edge : file.edges) all.push_back(chords(curves.of(edge), tolerance / 2));
  return all;
}

// The sides of cells: each edge twice, once for the generator on either side, by the vertex where
// it starts. At a vertex one side of each of its three cells starts.
struct Side {
  Triple end;
  const Points* points;
  bool backwards;
};
using Sides = std::map<Triple, Side>;

// The polygon of the sides around one cell.
Points polygon(const Sides& sides) {
  Points points;
  Triple at = sides.begin()->first;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const auto found = sides.find(at);
    if (found == sides.end()) throw std::invalid_argument("diagram: a cell is not closed");
    const auto& [end, side, backwards] = found->second;
    // The last point is the first of the next side.
    if (backwards) {
      points.insert(points.end(), side->rbegin(), side->rend() - 1);
    } else {
      points.insert(points.end(), side->begin(), side->end() - 1);
    }
    at = end;
  }
  return points;
}

std::vector<Points> only_cell(const DiagramFile& file, double tolerance) {
  Points disk = chords(EdgeCurves(file, tolerance / 2).only_cell(), tolerance / 2);
  disk.pop_back();
  return {disk, Points(disk.rbegin(), disk.rend())};
}

std::vector<Points> cells(const DiagramFile& file, double tolerance) {
  if (file.disks.size() == 1) return only_cell(file, tolerance);
  return polygons(file.disks.size(), file.edges, edge_points(file, tolerance));
}

}  // namespace

std::vector<Points> polygons(std::size_t disks, const std::vector<Quad>& edges,
                             const std::vector<Points>& sides) {
  std::vector<Sides> around(disks + 1);
  const auto cell_of = [&](GenId g) { return g == container_id ? disks : g; };
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const Quad &q = edges[k], back = reversed(q);
    around[cell_of(q.l)][start_vertex(q)] = {end_vertex(q), &sides[k], false};
    around[cell_of(q.r)][start_vertex(back)] = {end_vertex(back), &sides[k], true};
  }
  std::vector<Points> all;
  for (const Sides& cell : around) all.push_back(cell.empty() ? Points() : polygon(cell));
  return all;
}

Points only_cell(const Circle& disk, const Circle& frame, double tolerance) {
  DiagramFile file;
  file.container_center = frame.center;
  file.container_radius = frame.radius;
  file.disks.push_back({disk.center, disk.radius, {}});
  return only_cell(file, tolerance)[0];
}
}  // namespace internal

std::vector<std::vector<Vector>> edge_polylines(const Diagram& diagram, double tolerance) {
  internal::require_meaningful(diagram, tolerance);
  return internal::edge_points(internal::diagram_file(diagram), tolerance);
}

std::vector<std::vector<Vector>> cell_polygons(const Diagram& diagram, double tolerance) {
  internal::require_meaningful(diagram, tolerance);
  return internal::cells(internal::diagram_file(diagram), tolerance);
}

}  // namespace voroproof
