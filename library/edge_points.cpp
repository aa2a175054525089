#include "library/edge_points.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>

#include "library/diagram_geometry.h"

namespace voroproof::internal {
namespace {

// The bisector of a disk, the base, and another generator: in direction n from the centre of the
// base it is p / (2 (d.n + s)) away (library/edge_curves.cpp).
class Bisector {
 public:
  Bisector(const DiagramFile& diagram, GenId base, GenId other, double tolerance)
      : c_(center(diagram, base)),
        other_(center(diagram, other)),
        d_(*other_ - c_),
        s_(signed_radius(diagram, other) - signed_radius(diagram, base)),
        p_(dot(d_, d_) - s_ * s_),
        tolerance_(tolerance) {}

  // The bisector of a disk and a wall. The points follow each other along the wall, too.
  Bisector(const Vec2& center, const GeneratorRow<double>& wall, double tolerance)
      : c_(center), d_{wall.x, wall.y}, s_(wall.s), p_(wall.p), tolerance_(tolerance) {}

  Vec2 point(double angle) const { return c_ + distance(angle) * direction(angle); }

  // Counterclockwise around the base; `bent`: by one point between the ends at least.
  Points arc(const Vec2& start, const Vec2& end, bool bent) const {
    const double from = angle(start - c_);
    double sweep = angle(end - c_) - from;
    if (sweep < 0) sweep += 2 * pi;
    if (sweep > 2 * pi - least_angle) sweep = 0;  // the ends coincide but for their rounding
    Points points{start};
    append(start, end, from, sweep, bent, most_halvings, points);
    return points;
  }

 private:
  static constexpr int most_halvings = 24;
  static constexpr double least_angle = 1e-9, most_angle = pi / 4;

  double distance(double angle) const { return p_ / (2 * (dot(d_, direction(angle)) + s_)); }

  void append(const Vec2& start, const Vec2& end, double from, double sweep, bool bent,
              int halvings, Points& out) const {
    const double half = sweep / 2, rho = distance(from + half);
    const Vec2 middle = c_ + rho * direction(from + half);
    const bool is_fine = !bent && sweep <= most_angle && turned(start, end) <= most_angle &&
                         is_straight(start, middle, end);
    // Where the vertices of a file are not on the bisector the middle may be nowhere.
    if (is_fine || halvings == 0 || sweep <= least_angle || !(rho > 0) || !std::isfinite(rho)) {
      out.push_back(end);
      return;
    }
    append(start, middle, from, half, false, halvings - 1, out);
    append(middle, end, from + half, half, false, halvings - 1, out);
  }

  bool is_straight(const Vec2& a, const Vec2& m, const Vec2& b) const {
    const Vec2 chord = b - a, off = m - a;
    const double far = length(chord);
    const double bend = std::fabs(chord[0] * off[1] - chord[1] * off[0]);
    return far > 0 ? bend <= tolerance_ * far : length(off) <= tolerance_;
  }
  // The angle between the two, seen from the other side.
  double turned(const Vec2& a, const Vec2& b) const {
    if (!other_) return 0;
    const Vec2 u = a - *other_, v = b - *other_;
    return std::fabs(std::atan2(u[0] * v[1] - u[1] * v[0], dot(u, v)));
  }

  Vec2 c_;
  std::optional<Vec2> other_{};
  Vec2 d_;
  double s_, p_, tolerance_;
};

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

}  // namespace

Points edge_points(const DiagramFile& diagram, const Quad& q, const Vec2& start, const Vec2& end,
                   double tolerance) {
  // The two edges of a cell that has no more must not be one chord.
  const bool bent = q.s == q.e;
  if (q.l != container_id) return Bisector(diagram, q.l, q.r, tolerance).arc(start, end, bent);
  Points points = Bisector(diagram, q.r, q.l, tolerance).arc(end, start, bent);
  std::reverse(points.begin(), points.end());
  return points;
}

Points wall_points(const Quad& q, const Vec2& center, const GeneratorRow<double>& row,
                   const Vec2& start, const Vec2& end, double tolerance) {
  return Bisector(center, row, tolerance).arc(start, end, q.s == q.e);
}

Points only_cell(const DiagramFile& diagram, double tolerance) {
  const Bisector ellipse(diagram, 0, container_id, tolerance);
  Points all;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const Points arc = ellipse.arc(ellipse.point(quarter * pi / 2),
                                   ellipse.point((quarter + 1) % 4 * pi / 2), false);
    all.insert(all.end(), arc.begin(), arc.end() - 1);
  }
  return all;
}

std::vector<Points> cells_between(const DiagramFile& diagram, const std::vector<Points>& edges) {
  const std::size_t disks = diagram.disks.size();
  std::vector<Sides> around(disks + 1);
  const auto cell_of = [&](GenId g) { return g == container_id ? disks : g; };
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const Quad &q = diagram.edges[k], back = reversed(q);
    around[cell_of(q.l)][start_vertex(q)] = {end_vertex(q), &edges[k], false};
    around[cell_of(q.r)][start_vertex(back)] = {end_vertex(back), &edges[k], true};
  }
  std::vector<Points> all;
  for (const Sides& cell : around) all.push_back(cell.empty() ? Points() : polygon(cell));
  return all;
}

}  // namespace voroproof::internal
