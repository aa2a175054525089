// The cells of a diagram of disks at rest, as polygons.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

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

// A side of a box: the line on which a coordinate has a value, and the half-plane inside.
struct Side {
  int axis;
  double at;
  bool is_least;

  bool has_inside(const Vec2& p) const { return is_least ? p[axis] > at : p[axis] < at; }
  // How far a point is along the side, counterclockwise around the box.
  double along(const Vec2& p) const { return is_least == (axis == 0) ? -p[1 - axis] : p[1 - axis]; }
  // Where the way from p to q, one of which is inside and the other not, meets the line.
  Vec2 crossing(const Vec2& p, const Vec2& q) const {
    const int other = 1 - axis;
    const double part = (at - p[axis]) / (q[axis] - p[axis]);
    const auto [least, most] = std::minmax(p[other], q[other]);
    Vec2 c;
    c[axis] = at;
    c[other] = std::clamp(p[other] + part * (q[other] - p[other]), least, most);
    return c;
  }
};

// The ways of a polygon through the half-plane, each from the line to the line. Precondition: a
// corner of it is not inside.
std::vector<Points> ways_inside(const Points& polygon, const Side& side) {
  const std::size_t n = polygon.size();
  std::size_t first = 0;
  while (side.has_inside(polygon[first])) ++first;
  std::vector<Points> ways;
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 &p = polygon[(first + k) % n], &q = polygon[(first + k + 1) % n];
    const bool leaves = side.has_inside(p), enters = side.has_inside(q);
    if (!leaves && enters) ways.push_back({side.crossing(p, q)});
    if (enters) ways.back().push_back(q);
    if (leaves && !enters) ways.back().push_back(side.crossing(p, q));
  }
  return ways;
}

// The parts of a polygon in the half-plane, all counterclockwise. Along the side its ways end and
// begin in turn: the first end is followed by the first begin, and so on, also where some of them
// are in one place.
std::vector<Points> clipped(const Points& polygon, const Side& side) {
  const auto has_inside = [&](const Vec2& p) { return side.has_inside(p); };
  if (std::all_of(polygon.begin(), polygon.end(), has_inside)) return {polygon};
  const std::vector<Points> ways = ways_inside(polygon, side);
  std::vector<std::size_t> ends(ways.size());
  std::iota(ends.begin(), ends.end(), std::size_t{0});
  std::vector<std::size_t> begins = ends, next(ways.size());
  std::sort(ends.begin(), ends.end(), [&](std::size_t a, std::size_t b) {
    return side.along(ways[a].back()) < side.along(ways[b].back());
  });
  std::sort(begins.begin(), begins.end(), [&](std::size_t a, std::size_t b) {
    return side.along(ways[a].front()) < side.along(ways[b].front());
  });
  for (std::size_t k = 0; k < ways.size(); ++k) next[ends[k]] = begins[k];
  std::vector<Points> parts;
  std::vector<bool> is_taken(ways.size(), false);
  for (std::size_t k = 0; k < ways.size(); ++k) {
    if (is_taken[k]) continue;
    Points part;
    for (std::size_t w = k; !is_taken[w]; w = next[w]) {
      is_taken[w] = true;
      part.insert(part.end(), ways[w].begin(), ways[w].end());
    }
    part.erase(std::unique(part.begin(), part.end()), part.end());
    if (part.front() == part.back()) part.pop_back();
    if (part.size() > 2) parts.push_back(std::move(part));
  }
  return parts;
}

std::vector<Points> clipped(const Points& cell, const Box& box) {
  const auto& [low, high] = box;
  const bool is_inside =
      std::all_of(cell.begin(), cell.end(), [&, low = low, high = high](auto& p) {
        return low[0] <= p[0] && p[0] <= high[0] && low[1] <= p[1] && p[1] <= high[1];
      });
  std::vector<Points> parts{cell};
  if (is_inside) return parts;
  for (const Side& side :
       {Side{0, low[0], true}, {0, high[0], false}, {1, low[1], true}, {1, high[1], false}}) {
    std::vector<Points> all;
    for (const Points& part : parts) {
      for (Points& piece : clipped(part, side)) all.push_back(std::move(piece));
    }
    parts = std::move(all);
  }
  // A cell that only touches the box leaves a part as small as the roundings.
  const double least = 0x1p-40 * std::max(high[0] - low[0], high[1] - low[1]);
  std::erase_if(parts, [&](const Points& part) {
    return std::all_of(part.begin(), part.end(), [&](const Vec2& p) {
      return std::fabs(p[0] - part[0][0]) < least && std::fabs(p[1] - part[0][1]) < least;
    });
  });
  return parts;
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
