#include "apps/draw/static_curves.h"

#include <algorithm>
#include <cmath>

#include "library/diagram_geometry.h"

namespace voroproof::internal {
namespace {

// Appends cubics with the tangents of the arc at their ends. They are the arc where its weight is
// 1, and halves of an arc have weights nearer to it.
void append(const Arc& arc, double tolerance, int halvings, std::vector<Cubic>& out) {
  const auto& [a, b, c, w, error] = arc;
  const double pull = 4 * w / (3 * (1 + w));
  const Cubic cubic{a, a + pull * (b - a), c + pull * (b - c), c};
  // At a quarter of the way.
  const Vec2 there = (1 / (10 + 6 * w)) * (9 * a + (6 * w) * b + c);
  const Vec2 here = (1.0 / 64) * (27 * cubic[0] + 27 * cubic[1] + 9 * cubic[2] + cubic[3]);
  if (halvings == 0 || !(length(here - there) > tolerance)) {
    out.push_back(cubic);
    return;
  }
  const Vec2 left = (1 / (1 + w)) * (a + w * b), right = (1 / (1 + w)) * (c + w * b);
  const Vec2 middle = 0.5 * (left + right);
  const double weight = std::sqrt((1 + w) / 2);
  append({a, left, middle, weight, error}, tolerance, halvings - 1, out);
  append({middle, right, c, weight, error}, tolerance, halvings - 1, out);
}

// The pieces of the ellipse of a lone disk that may meet the box.
std::vector<std::vector<Cubic>> lone_cell(const StaticDiagram& diagram, const Box& box,
                                          double tolerance) {
  const auto host =
      std::find(diagram.hosts().begin(), diagram.hosts().end(), StaticDiagram::visible);
  if (!diagram.frame() || host == diagram.hosts().end()) return {};
  const auto& [center, radius] = diagram.disks()[host - diagram.hosts().begin()];
  DiagramFile file;
  file.container_center = diagram.frame()->center;
  file.container_radius = diagram.frame()->radius;
  file.disks.push_back({center, radius, {}});
  std::vector<std::vector<Cubic>> near;
  for (const Cubic& cubic : EdgeCurves(file, tolerance).only_cell()) {
    const auto is_beyond = [&](int axis) {
      const auto all = [&](const auto& beyond) {
        return std::all_of(cubic.begin(), cubic.end(), beyond);
      };
      return all([&](const Vec2& p) { return p[axis] < box.low[axis]; }) ||
             all([&](const Vec2& p) { return p[axis] > box.high[axis]; });
    };
    if (!is_beyond(0) && !is_beyond(1)) near.push_back({cubic});
  }
  return near;
}

}  // namespace

std::vector<std::vector<Cubic>> curves_in_box(const StaticDiagram& diagram, const Box& box,
                                              double tolerance) {
  if (diagram.edges().empty()) return lone_cell(diagram, box, tolerance);
  std::vector<std::vector<Cubic>> all;
  for (const std::vector<Arc>& edge : diagram.arcs(box)) {
    for (std::size_t k = 0; k < edge.size(); ++k) {
      if (k == 0 || edge[k].start != edge[k - 1].end) all.emplace_back();
      append(edge[k], tolerance, 20, all.back());
    }
  }
  return all;
}

}  // namespace voroproof::internal
