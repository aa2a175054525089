// The cells of a diagram of disks at rest, as polygons.
#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>
#include <stdexcept>

#include "library/box_parts.h"
#include "library/diagram_geometry.h"
#include "library/edge_courses.h"
#include "library/edge_points.h"
#include "voroproof/static_diagram.h"

namespace voroproof {
namespace internal {
namespace {

// The edge from its start to its end; l is a disk or a wall.
Points points_of(const EdgeCourses& courses, const Quad& q, double tolerance) {
  EdgeCourse course = courses.course(q);
  Points points = std::move(course.before);
  if (const auto& curve = course.curve) {
    const Points arc = courses.is_wall(q.r)
                           ? wall_points(q, center(courses.file(), q.l), courses.wall_row(q),
                                         curve->start, curve->end, tolerance)
                           : edge_points(courses.file(), q, curve->start, curve->end, tolerance);
    points.insert(points.end(), arc.begin(), arc.end());
  }
  points.insert(points.end(), course.after.begin(), course.after.end());
  return points;
}

// Each disk's cell as one polygon, whole.
std::vector<Points> whole_cells(const StaticDiagram& diagram, const Box& box, double tolerance) {
  const EdgeCourses courses(diagram, box);
  const DiagramFile& file = courses.file();
  std::vector<Points> sides;
  for (const Quad& q : file.edges) {
    const bool turned = q.l == container_id;
    sides.push_back(points_of(courses, turned ? reversed(q) : q, tolerance));
    if (turned) std::reverse(sides.back().begin(), sides.back().end());
  }
  std::vector<Points> cells = cells_between(file, sides);
  cells.resize(diagram.disks().size());  // without those of walls and of the frame
  return cells;
}

namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<double>;
using Polygon = bg::model::polygon<Point, false, false>;

std::vector<Points> clipped(const Points& cell, const Box& box) {
  const auto& [low, high] = box;
  const bool is_inside =
      std::all_of(cell.begin(), cell.end(), [&, low = low, high = high](auto& p) {
        return low[0] <= p[0] && p[0] <= high[0] && low[1] <= p[1] && p[1] <= high[1];
      });
  if (is_inside) return {cell};
  // In units of the box: no tolerance of the intersection depends on those of the caller.
  const double unit = std::max(high[0] - low[0], high[1] - low[1]);
  Polygon polygon;
  for (const Vec2& p : cell) {
    polygon.outer().emplace_back((p[0] - low[0]) / unit, (p[1] - low[1]) / unit);
  }
  std::vector<Polygon> pieces;
  const bg::model::box<Point> whole{{0, 0}, {(high[0] - low[0]) / unit, (high[1] - low[1]) / unit}};
  bg::intersection(polygon, whole, pieces);
  std::vector<Points> all;
  for (const Polygon& piece : pieces) {
    all.emplace_back();
    for (const Point& p : piece.outer()) {
      all.back().push_back({std::clamp(low[0] + unit * p.x(), low[0], high[0]),
                            std::clamp(low[1] + unit * p.y(), low[1], high[1])});
    }
  }
  return all;
}

}  // namespace
}  // namespace internal

std::vector<std::vector<std::vector<Vector>>> StaticDiagram::cells(const Box& box,
                                                                   double tolerance) const {
  const auto& [low, high] = box;
  const double size = std::max(high[0] - low[0], high[1] - low[1]);
  internal::require_area(box);
  if (!(tolerance >= 1e-9 * size) || !std::isfinite(tolerance)) {
    throw std::invalid_argument("tolerance: less than 1e-9 of the box's size");
  }
  std::vector<std::vector<std::vector<Vector>>> all(disks_.size());
  if (edges_.empty()) {
    for (std::size_t k = 0; k < disks_.size(); ++k) {
      if (hosts_[k] != visible) continue;
      const internal::Points whole = {low, {high[0], low[1]}, high, {low[0], high[1]}};
      all[k] = {whole};
      if (frame_) {
        internal::DiagramFile file;
        file.container_center = frame_->center;
        file.container_radius = frame_->radius;
        file.disks.push_back({disks_[k].center, disks_[k].radius, {}});
        all[k] = internal::clipped(internal::only_cell(file, tolerance), box);
      }
    }
    return all;
  }
  const std::vector<internal::Points> cells = internal::whole_cells(*this, box, tolerance);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (!cells[k].empty()) all[k] = internal::clipped(cells[k], box);
  }
  return all;
}

}  // namespace voroproof
