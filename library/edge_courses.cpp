#include "library/edge_courses.h"

#include <algorithm>
#include <cmath>

#include "filtered/search/collapse.h"
#include "library/diagram_geometry.h"
#include "library/resting_disks.h"
#include "library/values.h"

namespace voroproof::internal {
namespace {

Vec2 scaled(const Vec2& a, double unit) { return {a[0] / unit, a[1] / unit}; }
// Without functions of the mathematical library, so that no byte depends on it.
double at_least_length(const Vec2& a) { return std::fabs(a[0]) + std::fabs(a[1]); }
double rounded_length(const Vec2& a) { return std::sqrt(dot(a, a)); }

// a b + c d. Not inlined: g++ 12 makes one fused instruction of two such sums side by side, also
// without contraction, and bytes would depend on the processor.
[[gnu::noinline]] double sum_of_products(double a, double b, double c, double d) {
  return a * b + c * d;
}

}  // namespace

EdgeCourses::EdgeCourses(const StaticDiagram& diagram, const Box& box, double unit)
    : plane_(!diagram.frame() && !diagram.walls()),
      framed_(RestingFrame{diagram.frame(), diagram.walls()}.framed(diagram.disks().size())),
      far_(0) {
  if (const auto& frame = diagram.frame()) {
    file_.container_center = scaled(frame->center, unit);
    file_.container_radius = frame->radius / unit;
  }
  const auto reach = [&](const Vec2& at, double radius) {
    far_ = std::max(far_, 16 * (at_least_length(at) + std::fabs(radius)));
  };
  reach(scaled(box.low, unit), 0);
  reach(scaled(box.high, unit), 0);
  for (const Circle& d : diagram.disks()) {
    file_.disks.push_back({scaled(d.center, unit), d.radius / unit, {}});
    reach(file_.disks.back().center, file_.disks.back().radius);
  }
  if (const auto& walls = diagram.walls()) {
    for (int quarter = 0; quarter < wall_count; ++quarter) {
      const Vec2 at = scaled(RestingFrame{{}, walls}.place(quarter), unit);
      file_.disks.push_back({at, 0, {}});
      reach(at, 0);
    }
  }
  for (const Edge& e : diagram.edges()) file_.edges.push_back(quad(e));
  for (const Vertex& v : diagram.vertices()) {
    const Vec2 center = scaled(v.center, unit);
    finite_.emplace_hint(finite_.end(), v.generators, center);
    far_ = std::max(far_, 4 * at_least_length(center));
  }
  if (framed_.has_walls()) add_corners();
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

// Beyond the corners: on their bisectors, as far out in both coordinates.
void EdgeCourses::add_corners() {
  for (int quarter = 0; quarter < wall_count; ++quarter) {
    const GenId a = framed_.wall(quarter), b = framed_.wall((quarter + 1) & 3);
    const bool turned = (quarter & 1) == 1;  // a is the bottom or the top
    const Vec2 corner{center(file_, turned ? b : a)[0], center(file_, turned ? a : b)[1]};
    infinite_.emplace(
        canonical(Triple{b, a, container_id}),
        corner + framed_.reflected<double>(a, 0, -far_) + framed_.reflected<double>(b, 0, -far_));
  }
}

WallLine EdgeCourses::wall(GenId g) const {
  return {center(file_, g), framed_.reflected<double>(g, 0, 1)};
}

GeneratorRow<double> EdgeCourses::wall_row(const Quad& q) const {
  const auto at = [this](GenId g) {
    const Vec2& c = center(file_, g);
    return Site<double>{c[0], c[1], signed_radius(file_, g)};
  };
  return framed_.row_of(at, q.l, q.r);
}

Vec2 EdgeCourses::place(const Triple& name) const {
  const auto found = finite_.find(name);
  return found != finite_.end() ? found->second : infinite_.at(name);
}

EdgeCourse EdgeCourses::course(const Quad& q) const {
  const Triple start = start_vertex(q), end = end_vertex(q);
  if (is_wall(q.l)) return {{place(start), place(end)}};
  if (plane_ && q.r == container_id) return {rim(q)};
  const auto from = finite_.find(start), to = finite_.find(end);
  const bool begins = from != finite_.end(), ends = to != finite_.end();
  // The edge leads along its whole bisector, or from a vertex at infinity to the same place.
  if (!begins && !ends && is_left(start, q) == is_left(end, q)) {
    return {{infinite_.at(start), infinite_.at(end)}};
  }
  // At a vertex at infinity of three disks their edges, which are parallel there, are joined.
  EdgeCourse course;
  course.curve = {begins ? from->second : far_end(q, false), ends ? to->second : far_end(q, true),
                  !begins, !ends};
  if (!begins && start[0] != container_id) course.before = {infinite_.at(start)};
  if (!ends && end[0] != container_id) course.after = {infinite_.at(end)};
  return course;
}

// On the bisector, a point in direction n from l is p / (2 (d.n + s)) away (edge_curves.cpp); the
// edge runs counterclockwise around l.
Vec2 EdgeCourses::far_end(const Quad& q, bool at_end) const {
  const Vec2 c = center(file_, q.l), d = center(file_, q.r) - c;
  const double s = signed_radius(file_, q.r) - signed_radius(file_, q.l);
  const double p = dot(d, d) - s * s, away = far_ + at_least_length(c), between = rounded_length(d);
  const double cosine = std::clamp((p / (2 * away) - s) / between, -1.0, 1.0);
  const double sine = std::sqrt((1 - cosine) * (1 + cosine)) * (at_end ? 1 : -1);
  const double stretch = away / between;
  return {c[0] + stretch * sum_of_products(cosine, d[0], -sine, d[1]),
          c[1] + stretch * sum_of_products(cosine, d[1], sine, d[0])};
}

// The line of a vertex at infinity.
template <class T, class Number>
TangentTriple<T> EdgeCourses::line(const Triple& name, const Number& number) const {
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
bool EdgeCourses::is_left(const Triple& name, const Quad& q) const {
  const TangentTriple<Rational> t = line<Rational>(name, to_rational);
  const Vec2 &l = center(file_, q.l), &r = center(file_, q.r);
  const Rational x = to_rational(r[0]) - to_rational(l[0]),
                 y = to_rational(r[1]) - to_rational(l[1]);
  const Rational u = t.sp * (y * t.xp - x * t.yp), v = x * t.xp + y * t.yp;
  return sign_with_root(sign(u), sign(v), sign(Rational(u * u - gamma(t) * v * v))) ==
         Sign::positive;
}

// A place beyond the far ends of edges in that direction.
Vec2 EdgeCourses::joint(const Triple& name) const {
  const auto t = line<double>(name, [](double x) { return x; });
  const auto way = circle_direction(t, [](double x) { return std::sqrt(std::max(x, 0.0)); });
  const Vec2 c{t.base.x, t.base.y};
  return c + (2 * (far_ + at_least_length(c)) / rounded_length(way)) * way;
}

// The rim between the far ends of the edges beside that of a disk and infinity, counterclockwise
// around the disk by quarter turns, twice as far away.
Points EdgeCourses::rim(const Quad& q) const {
  const Vec2 c = center(file_, q.l), start = infinite_.at(start_vertex(q)),
             end = infinite_.at(end_vertex(q)), to = end - c;
  Vec2 way = start - c;
  const double from = rounded_length(way), stretch = 2 * std::max(from, rounded_length(to)) / from;
  Points points{start};
  const auto is_last = [&] { return way[0] * to[1] - way[1] * to[0] > 0 && dot(way, to) >= 0; };
  for (int quarters = 0; quarters < 4 && !is_last(); ++quarters) {
    way = {-way[1], way[0]};
    points.push_back(c + stretch * way);
  }
  points.push_back(end);
  return points;
}

}  // namespace voroproof::internal
