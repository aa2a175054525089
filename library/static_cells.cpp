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
#include "library/polylines.h"
#include "library/values.h"
#include "voroproof/static_diagram.h"

namespace voroproof {
namespace internal {
namespace {

using Points = std::vector<Vec2>;

// The edge q between a disk, l, and another generator as points on it. Seen from either side its
// points follow each other in angle, as those of the edge do, so that the polygon of a cell is
// simple however few they are.
class EdgePoints {
 public:
  EdgePoints(const DiagramFile& file, const Quad& q, double tolerance)
      : c_(center(file, q.l)),
        other_(center(file, q.r)),
        d_(other_ - c_),
        s_(signed_radius(file, q.r) - signed_radius(file, q.l)),
        p_(dot(d_, d_) - s_ * s_),
        tolerance_(tolerance),
        is_one_of_two_(q.s == q.e) {}

  Points between(const Vec2& start, const Vec2& end) const {
    const double from = angle(start - c_);
    double sweep = angle(end - c_) - from;
    if (sweep < 0) sweep += 2 * pi;
    if (sweep > 2 * pi - least_angle) sweep = 0;  // the ends coincide but for their rounding
    Points points{start};
    append(start, end, from, sweep, 0, points);
    return points;
  }

 private:
  static constexpr int most_halvings = 24;
  static constexpr double least_angle = 1e-9, most_angle = pi / 4;

  void append(const Vec2& start, const Vec2& end, double from, double sweep, int depth,
              Points& out) const {
    const double rho = p_ / (2 * (dot(d_, direction(from + sweep / 2)) + s_));
    const Vec2 middle = c_ + rho * direction(from + sweep / 2);
    // The two edges of a cell that has no more must not be one chord.
    const bool is_fine = is_straight(start, middle, end) && sweep <= most_angle &&
                         turned(start, end) <= most_angle && !(is_one_of_two_ && depth == 0);
    if (is_fine || depth == most_halvings || sweep <= least_angle || !(rho > 0) ||
        !std::isfinite(rho)) {
      out.push_back(end);
      return;
    }
    append(start, middle, from, sweep / 2, depth + 1, out);
    append(middle, end, from + sweep / 2, sweep / 2, depth + 1, out);
  }

  bool is_straight(const Vec2& a, const Vec2& m, const Vec2& b) const {
    const Vec2 chord = b - a, off = m - a;
    const double far = length(chord);
    const double bend = std::fabs(chord[0] * off[1] - chord[1] * off[0]);
    return far > 0 ? bend <= tolerance_ * far : length(off) <= tolerance_;
  }
  // The angle between the two, seen from the other side.
  double turned(const Vec2& a, const Vec2& b) const {
    const Vec2 u = a - other_, v = b - other_;
    return std::fabs(std::atan2(u[0] * v[1] - u[1] * v[0], dot(u, v)));
  }

  Vec2 c_, other_, d_;
  double s_, p_, tolerance_;
  bool is_one_of_two_;  // edges of a cell
};

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
        const Vec2 n = normal(name), c = center(file_, q.l);
        const bool is_of_three = name[0] != container_id;
        const Vec2 joint = c + 2 * (far_ + length(c)) * n;
        infinite_.emplace(name, Infinite{n, is_of_three ? joint : far_end(q, at_end)});
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
    if (!begins && !ends) {
      const Infinite &a = infinite_.at(start), &b = infinite_.at(end);
      if (length(a.normal - b.normal) < 1e-9) return {a.place, b.place};  // all of it is there
    }
    // At a vertex at infinity of three disks their edges, which are parallel there, are joined.
    Points points = EdgePoints(file_, q, tolerance_)
                        .between(begins ? from->second : far_end(q, false),
                                 ends ? to->second : far_end(q, true));
    if (!ends && end[0] != container_id) points.push_back(infinite_.at(end).place);
    if (!begins && start[0] != container_id) {
      points.insert(points.begin(), infinite_.at(start).place);
    }
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

  // The direction in which a vertex at infinity is.
  Vec2 normal(const Triple& name) const {
    const auto v = disk_first(name[0], name[1], name[2]);
    const auto site = [&](GenId g) {
      return Site<double>{center(file_, g)[0], center(file_, g)[1], signed_radius(file_, g)};
    };
    const auto seen = [&](GenId g) {
      return g == container_id ? GeneratorRow<double>{0, 0, 0, 1} : row(site(v[0]), site(g));
    };
    const TangentTriple<double> line(site(v[0]), seen(v[1]), seen(v[2]), false);
    const auto n = circle_direction(line, [](double x) { return std::sqrt(std::max(x, 0.0)); });
    return (1 / length(n)) * n;
  }

  // The rim between the far ends of the edges beside that of a disk and infinity, counterclockwise
  // around the disk.
  Points rim(const Quad& q) const {
    const Vec2 c = center(file_, q.l), start = infinite_.at(start_vertex(q)).place,
               end = infinite_.at(end_vertex(q)).place;
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

  struct Infinite {
    Vec2 normal, place;
  };
  bool plane_;
  double far_, tolerance_;
  DiagramFile file_;
  std::map<Triple, Vec2> finite_;
  std::map<Triple, Infinite> infinite_;
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
  std::vector<Points> cells = polygons(file.disks.size(), file.edges, sides);
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
      if (frame_)
        all[k] = internal::clipped(internal::only_cell(disks_[k], *frame_, tolerance), box);
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
