#include "voroproof/static_diagram.h"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

#include "engine/resting_diagram.h"
#include "filtered/numbers/dd_ball.h"
#include "filtered/search/collapse.h"
#include "library/diagram_geometry.h"
#include "library/places.h"
#include "library/polylines.h"
#include "library/values.h"

namespace voroproof {
namespace internal {
namespace {

using Points = std::vector<Vec2>;

void require_number(double x, const char* name, std::size_t disk) {
  const double size = std::fabs(x);
  if (std::isfinite(x) && (x == 0 || (size >= 1e-100 && size <= 1e100))) return;
  throw std::invalid_argument("disk " + std::to_string(disk) + ": " + name +
                              ": not finite, or beyond 1e-100 to 1e100 in magnitude");
}

void require_disks(const std::vector<Circle>& disks, bool framed) {
  for (std::size_t k = 0; k < disks.size(); ++k) {
    const auto& [center, radius] = disks[k];
    require_number(center[0], "center", k);
    require_number(center[1], "center", k);
    require_number(radius, "radius", k);
    if (framed && radius < 0) {
      throw std::invalid_argument("disk " + std::to_string(k) + ": radius: negative, in a frame");
    }
  }
}

// In the plane radii may be made larger by one number: by that of the least, which is negative.
MotionInput motion_input(const std::vector<Circle>& disks, const std::optional<Circle>& frame) {
  MotionInput input;
  Rational least = 0;
  if (frame) {
    input.container_x = to_rational(frame->center[0]);
    input.container_y = to_rational(frame->center[1]);
    input.container_radius = to_rational(frame->radius);
  } else if (!disks.empty()) {
    // Any place near the disks.
    input.container_x = to_rational(disks[0].center[0]);
    input.container_y = to_rational(disks[0].center[1]);
    input.container_radius = 1;
    for (const Circle& d : disks) least = std::min(least, to_rational(d.radius));
  }
  input.disks.reserve(disks.size());
  for (const auto& [center, radius] : disks) {
    input.disks.push_back({to_rational(center[0]), to_rational(center[1]),
                           Rational(to_rational(radius) - least), 0, 0, 1});
  }
  return input;
}

// The double to which all values of the ball round.
std::optional<double> nearest(const DdBall& b) {
  const double off = b.rad * (1 + 0x1p-40) + std::fabs(b.lo) * 0x1p-51;
  const double low = b.hi + (b.lo - off), high = b.hi + (b.lo + off);
  if (!(low == high) || !std::isfinite(low)) return std::nullopt;
  return low == 0 ? 0 : low;
}

// The circles of vertices, rounded to nearest.
class Circles {
 public:
  Circles(const std::vector<Circle>& disks, const std::optional<Circle>& frame)
      : disks_(disks), frame_(frame) {}

  Vertex of(const Triple& name) {
    const auto site = [&](GenId g) {
      const auto& [c, r] = g == container_id ? *frame_ : disks_[g];
      return Site<DdBall>{c[0], c[1], g == container_id ? -r : r};
    };
    const auto [i, j, k] = disk_first(name[0], name[1], name[2]);
    const auto at = tangent_circle(
        TangentTriple<DdBall>(site(i), site(j), site(k), j == container_id || k == container_id));
    const auto x = nearest(at[0]), y = nearest(at[1]), r = nearest(at[2]);
    if (x && y && r) return {name, {*x, *y}, *r};
    const Places::Rounded circle = exactly().circle(name);
    return {name, circle.center, circle.radius};
  }

 private:
  // All generators with more bits, and exactly.
  Places& exactly() {
    if (places_) return *places_;
    const auto site = [](const Circle& c, int sign) {
      return MovingSite<Rational>{to_rational(c.center[0]), to_rational(c.center[1]), 0, 0,
                                  to_rational(sign * c.radius)};
    };
    std::vector<MovingSite<Rational>> sites{site(frame_.value_or(Circle{{}, 1}), -1)};
    for (const Circle& d : disks_) sites.push_back(site(d, 1));
    return places_.emplace(std::move(sites));
  }

  const std::vector<Circle>& disks_;
  const std::optional<Circle>& frame_;
  std::optional<Places> places_;
};

// All vertices that are not at infinity.
std::vector<Vertex> vertices_of(const std::vector<Circle>& disks,
                                const std::optional<Circle>& frame,
                                const std::vector<Quad>& edges) {
  std::vector<Triple> names;
  for (const Quad& q : edges) {
    for (const Triple& name : {start_vertex(q), end_vertex(q)}) {
      if (frame || name[0] != container_id) names.push_back(name);
    }
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  Circles circles(disks, frame);
  std::vector<Vertex> vertices;
  vertices.reserve(names.size());
  for (const Triple& name : names) vertices.push_back(circles.of(name));
  return vertices;
}

// The diagram as a file has it, for its curves. In the plane a vertex at infinity is put on the
// edge of its two disks, `far` away.
class Drawn {
 public:
  Drawn(const StaticDiagram& diagram, double far) : diagram_(diagram) {
    const auto& frame = diagram.frame();
    if (frame) {
      file_.container_center = frame->center;
      file_.container_radius = frame->radius;
    }
    for (const Circle& d : diagram.disks()) file_.disks.push_back({d.center, d.radius, {}});
    for (const Vertex& v : diagram.vertices()) {
      file_.vertices.push_back({v.generators, v.center, v.radius});
      far = std::max(far, 4 * std::hypot(v.center[0], v.center[1]));
    }
    for (const Edge& e : diagram.edges()) file_.edges.push_back(quad(e));
    if (frame) return;
    for (const Quad& q : file_.edges) {
      if (q.l == container_id) continue;
      if (q.s == container_id) put(start_vertex(q), q, -1, far);
      if (q.e == container_id) put(end_vertex(q), q, 1, far);
    }
  }

  const DiagramFile& file() const { return file_; }

  // The rim between the far ends of the edges beside that of a disk and infinity, counterclockwise
  // around the disk.
  Points rim(const Quad& q) const {
    const Vec2 c = center(file_, q.l), start = far_.at(start_vertex(q)),
               end = far_.at(end_vertex(q));
    const double from = angle(start - c), radius = std::max(length(start - c), length(end - c));
    double sweep = angle(end - c) - from;
    if (sweep <= 0) sweep += 2 * pi;
    Points points{start};
    const int steps = std::max(1, static_cast<int>(std::ceil(sweep / (pi / 8))));
    for (int k = 1; k < steps; ++k)
      points.push_back(c + 2 * radius * direction(from + k * sweep / steps));
    points.push_back(end);
    return points;
  }

 private:
  // On the bisector, a point in direction n from l is p / (2 (d.n + s)) away (edge_curves.cpp); the
  // edge runs counterclockwise around l.
  void put(const Triple& name, const Quad& q, int side, double far) {
    const Vec2 c = center(file_, q.l), d = center(file_, q.r) - c;
    const double s = signed_radius(file_, q.r) - signed_radius(file_, q.l);
    const double p = dot(d, d) - s * s, away = far + length(c);
    const double cosine = std::clamp((p / (2 * away) - s) / length(d), -1.0, 1.0);
    far_[name] = c + away * direction(angle(d) + side * std::acos(cosine));
    file_.vertices.push_back({name, far_[name], 0});
  }

  const StaticDiagram& diagram_;
  DiagramFile file_;
  std::map<Triple, Vec2> far_;
};

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

// Each disk's cell as one polygon, whole.
std::vector<Points> whole_cells(const StaticDiagram& diagram, double far, double tolerance) {
  const Drawn drawn(diagram, far);
  const DiagramFile& file = drawn.file();
  std::map<Triple, Vec2> places;
  for (const DiagramVertex& v : file.vertices) places.emplace(v.generators, v.center);
  std::vector<Points> sides;
  for (const Quad& q : file.edges) {
    const bool turned = q.l == container_id;
    const Quad side = turned ? reversed(q) : q;
    if (side.r == container_id && !diagram.frame()) {
      sides.push_back(drawn.rim(side));
    } else {
      sides.push_back(EdgePoints(file, side, tolerance)
                          .between(places.at(start_vertex(side)), places.at(end_vertex(side))));
    }
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
  Polygon polygon;
  for (const Vec2& p : cell) polygon.outer().emplace_back(p[0], p[1]);
  std::vector<Polygon> pieces;
  bg::intersection(
      polygon, bg::model::box<Point>{{box.low[0], box.low[1]}, {box.high[0], box.high[1]}}, pieces);
  std::vector<Points> all;
  for (const Polygon& piece : pieces) {
    all.emplace_back();
    for (const Point& p : piece.outer()) all.back().push_back({p.x(), p.y()});
  }
  return all;
}

}  // namespace
}  // namespace internal

StaticDiagram::StaticDiagram(std::vector<Circle> disks, std::optional<Circle> frame)
    : disks_(std::move(disks)), frame_(frame) {
  internal::with_public_errors([&] {
    internal::require_disks(disks_, frame_.has_value());
    if (frame_) {
      internal::require_disks({*frame_}, true);
      if (!(frame_->radius > 0)) throw std::invalid_argument("frame: no radius");
    }
    internal::TierCounts counts;
    internal::RestingDiagram diagram = internal::resting_diagram(
        internal::motion_input(disks_, frame_),
        frame_ ? internal::Frame::circle : internal::Frame::plane, {}, counts);
    vertices_ = internal::vertices_of(disks_, frame_, diagram.edges);
    hosts_ = std::move(diagram.host);
    for (const internal::Quad& q : diagram.edges) edges_.push_back(internal::edge_value(q));
  });
}

Box StaticDiagram::box() const {
  if (frame_) {
    const auto& [c, r] = *frame_;
    return {{c[0] - r, c[1] - r}, {c[0] + r, c[1] + r}};
  }
  Box box;
  bool first = true;
  for (std::size_t k = 0; k < disks_.size(); ++k) {
    if (hosts_[k] != visible) continue;
    const auto& [c, radius] = disks_[k];
    const double r = std::max(radius, 0.0);
    for (const int axis : {0, 1}) {
      box.low[axis] = first ? c[axis] - r : std::min(box.low[axis], c[axis] - r);
      box.high[axis] = first ? c[axis] + r : std::max(box.high[axis], c[axis] + r);
    }
    first = false;
  }
  const double size = std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]);
  const double margin = size > 0 ? size / 10 : 1;
  return {{box.low[0] - margin, box.low[1] - margin}, {box.high[0] + margin, box.high[1] + margin}};
}

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
