// The cells of a diagram of disks at rest, as polygons.
#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>
#include <map>
#include <stdexcept>

#include "exact/predicates.h"
#include "filtered/search/collapse.h"
#include "library/diagram_geometry.h"
#include "library/edge_points.h"
#include "library/values.h"
#include "voroproof/static_diagram.h"

namespace voroproof {
namespace internal {
namespace {

// The edges of a diagram as chains of points. In the plane those of vertices at infinity are `far`
// away.
class Drawn {
 public:
  Drawn(const StaticDiagram& diagram, double far, double tolerance)
      : plane_(!diagram.frame()), far_(far), tolerance_(tolerance) {
    if (const auto& frame = diagram.frame()) {
      file_.container_center = frame->center;
      file_.container_radius = frame->radius;
    }
    for (const Circle& d : diagram.disks()) file_.disks.push_back({d.center, d.radius, {}});
    for (const Edge& e : diagram.edges()) file_.edges.push_back(quad(e));
    for (const Vertex& v : diagram.vertices()) {
      finite_.emplace(v.generators, v.center);
      far_ = std::max(far_, 4 * std::hypot(v.center[0], v.center[1]));
    }
    for (const Quad& q : file_.edges) {
      if (!plane_ || q.l == container_id) continue;
      for (const bool at_end : {false, true}) {
        const Triple name = at_end ? end_vertex(q) : start_vertex(q);
        if (finite_.contains(name)) continue;
        const bool is_of_three = name[0] != container_id;
        infinite_.emplace(name, is_of_three ? joint(name) : far_end(q, at_end));
      }
    }
  }

  const DiagramFile& file() const { return file_; }

  // The edge from its start to its end; l is a disk.
  Points edge(const Quad& q) const {
    const Triple start = start_vertex(q), end = end_vertex(q);
    if (plane_ && q.r == container_id) return rim(q);
    const auto from = finite_.find(start), to = finite_.find(end);
    const bool begins = from != finite_.end(), ends = to != finite_.end();
    // The edge leads along its whole bisector, or from a vertex at infinity to the same place.
    if (!begins && !ends && is_left(start, q) == is_left(end, q)) {
      return {infinite_.at(start), infinite_.at(end)};
    }
    // At a vertex at infinity of three disks their edges, which are parallel there, are joined.
    Points points = edge_points(file_, q, begins ? from->second : far_end(q, false),
                                ends ? to->second : far_end(q, true), tolerance_);
    if (!ends && end[0] != container_id) points.push_back(infinite_.at(end));
    if (!begins && start[0] != container_id) points.insert(points.begin(), infinite_.at(start));
    return points;
  }

 private:
  // On the bisector, a point in direction n from l is p / (2 (d.n + s)) away (edge_curves.cpp); the
  // edge runs counterclockwise around l.
  Vec2 far_end(const Quad& q, bool at_end) const {
    const Vec2 c = center(file_, q.l), d = center(file_, q.r) - c;
    const double s = signed_radius(file_, q.r) - signed_radius(file_, q.l);
    const double p = dot(d, d) - s * s, away = far_ + length(c);
    const double off = std::acos(std::clamp((p / (2 * away) - s) / length(d), -1.0, 1.0));
    return c + away * direction(angle(d) + (at_end ? off : -off));
  }

  // The line of a vertex at infinity.
  template <class T, class Number>
  TangentTriple<T> line(const Triple& name, const Number& number) const {
    const auto v = disk_first(name[0], name[1], name[2]);
    const auto site = [&](GenId g) {
      const Vec2& c = center(file_, g);
      return Site<T>{number(c[0]), number(c[1]), number(signed_radius(file_, g))};
    };
    const auto seen = [&](GenId g) {
      return g == container_id ? GeneratorRow<T>{0, 0, 0, 1} : row(site(v[0]), site(g));
    };
    return {site(v[0]), seen(v[1]), seen(v[2]), false};
  }

  // Whether that line touches l and r on the left of the way from l to r, exactly. It is in the
  // direction n of circle_direction(), and d x n = u + sqrt(Gamma) v for d from l to r.
  bool is_left(const Triple& name, const Quad& q) const {
    const TangentTriple<Rational> t = line<Rational>(name, to_rational);
    const Vec2 &l = center(file_, q.l), &r = center(file_, q.r);
    const Rational x = to_rational(r[0]) - to_rational(l[0]),
                   y = to_rational(r[1]) - to_rational(l[1]);
    const Rational u = t.sp * (y * t.xp - x * t.yp), v = x * t.xp + y * t.yp;
    return sign_with_root(sign(u), sign(v), sign(Rational(u * u - gamma(t) * v * v))) ==
           Sign::positive;
  }

  // A place beyond the far ends of edges in that direction.
  Vec2 joint(const Triple& name) const {
    const auto t = line<double>(name, [](double x) { return x; });
    const auto way = circle_direction(t, [](double x) { return std::sqrt(std::max(x, 0.0)); });
    const Vec2 c{t.base.x, t.base.y};
    return c + (2 * (far_ + length(c)) / length(way)) * way;
  }

  // The rim between the far ends of the edges beside that of a disk and infinity, counterclockwise
  // around the disk.
  Points rim(const Quad& q) const {
    const Vec2 c = center(file_, q.l), start = infinite_.at(start_vertex(q)),
               end = infinite_.at(end_vertex(q));
    const double from = angle(start - c), radius = std::max(length(start - c), length(end - c));
    double sweep = angle(end - c) - from;
    if (sweep <= 0) sweep += 2 * pi;
    Points points{start};
    const int steps = std::max(1, static_cast<int>(std::ceil(sweep / (pi / 8))));
    for (int k = 1; k < steps; ++k) {
      points.push_back(c + 2 * radius * direction(from + k * sweep / steps));
    }
    points.push_back(end);
    return points;
  }

  bool plane_;
  double far_, tolerance_;
  DiagramFile file_;
  std::map<Triple, Vec2> finite_, infinite_;
};

// Each disk's cell as one polygon, whole.
std::vector<Points> whole_cells(const StaticDiagram& diagram, double far, double tolerance) {
  const Drawn drawn(diagram, far, tolerance);
  const DiagramFile& file = drawn.file();
  std::vector<Points> sides;
  for (const Quad& q : file.edges) {
    const bool turned = q.l == container_id;
    sides.push_back(drawn.edge(turned ? reversed(q) : q));
    if (turned) std::reverse(sides.back().begin(), sides.back().end());
  }
  std::vector<Points> cells = cells_between(file, sides);
  cells.pop_back();  // that of the frame
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
  if (!(high[0] > low[0] && high[1] > low[1] && std::isfinite(size))) {
    throw std::invalid_argument("box: no area");
  }
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
  double far = 16 * size;
  for (const Circle& d : disks_) {
    far = std::max(far, 16 * (std::hypot(d.center[0], d.center[1]) + std::fabs(d.radius)));
  }
  for (const Vector& corner : {low, high})
    far = std::max(far, 16 * std::hypot(corner[0], corner[1]));
  const std::vector<internal::Points> cells = internal::whole_cells(*this, far, tolerance);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (!cells[k].empty()) all[k] = internal::clipped(cells[k], box);
  }
  return all;
}

}  // namespace voroproof
