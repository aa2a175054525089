#include "library/diagram_arcs.h"

#include <algorithm>
#include <cmath>

namespace voroproof::internal {
namespace {

double unit_of(const StaticDiagram& diagram, const Box& box) {
  double largest = 0;
  const auto look = [&](double x) { largest = std::max(largest, std::fabs(x)); };
  for (const int axis : {0, 1}) {
    look(box.low[axis]);
    look(box.high[axis]);
    for (const Circle& d : diagram.disks()) look(d.center[axis]);
    if (diagram.frame()) look(diagram.frame()->center[axis]);
    if (diagram.walls())
      look(std::max(std::fabs(diagram.walls()->low[axis]), std::fabs(diagram.walls()->high[axis])));
  }
  for (const Circle& d : diagram.disks()) look(d.radius);
  if (diagram.frame()) look(diagram.frame()->radius);
  int exponent = 0;
  std::frexp(largest, &exponent);
  return std::ldexp(1.0, exponent - 1);  // at most the largest
}

Box scaled(const Box& box, double unit) {
  return {{box.low[0] / unit, box.low[1] / unit}, {box.high[0] / unit, box.high[1] / unit}};
}

// Straight from point to point, all of which are doubles.
void append_ways(const Points& points, const Vec2& origin, std::vector<ConicArc>& arcs) {
  const auto offset = [&](const Vec2& p) {
    return BallPoint{DoubleBall(p[0]) - DoubleBall(origin[0]),
                     DoubleBall(p[1]) - DoubleBall(origin[1])};
  };
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    arcs.push_back(ConicArc::segment(offset(points[k]), offset(points[k + 1])));
  }
}

}  // namespace

DiagramArcs::DiagramArcs(const StaticDiagram& diagram, const Box& box)
    : unit_(unit_of(diagram, box)), box_(scaled(box, unit_)), courses_(diagram, box, unit_) {}

Circle DiagramArcs::disk(GenId id) const {
  return {center(courses_.file(), id), signed_radius(courses_.file(), id)};
}

Circle DiagramArcs::frame() const {
  return {courses_.file().container_center, courses_.file().container_radius};
}

std::vector<Quad> DiagramArcs::edges() const {
  std::vector<Quad> all = courses_.file().edges;
  for (Quad& q : all) {
    if (q.l == container_id) q = reversed(q);
  }
  return all;
}

ArcChain DiagramArcs::chain(const Quad& q) const {
  if (courses_.is_wall(q.l)) {
    if (q.r == container_id) return {};
    return straight_arc(courses_.place(start_vertex(q)), courses_.place(end_vertex(q)));
  }
  EdgeCourse course = courses_.course(q);
  const Circle left = disk(q.l);
  ArcChain chain{left.center};
  if (!course.curve) {
    append_ways(course.before, chain.origin, chain.arcs);
    return chain;
  }
  const auto& [start, end, start_is_cut, end_is_cut] = *course.curve;
  if (q.r == container_id) {
    return frame_arcs(left, frame(), start, end);
  }
  if (courses_.is_wall(q.r)) return wall_arcs(left, courses_.wall(q.r), start, end);
  const double far = courses_.far() + std::fabs(left.center[0]) + std::fabs(left.center[1]);
  chain = plane_arcs(left, disk(q.r), {start, start_is_cut}, {end, end_is_cut}, far);
  std::vector<ConicArc> before;
  if (start_is_cut) {
    course.before.push_back(start);
    append_ways(course.before, chain.origin, before);
  }
  chain.arcs.insert(chain.arcs.begin(), before.begin(), before.end());
  if (end_is_cut) {
    course.after.insert(course.after.begin(), end);
    append_ways(course.after, chain.origin, chain.arcs);
  }
  return chain;
}

}  // namespace voroproof::internal
