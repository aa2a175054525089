#include "library/edge_curves.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "exact/names.h"
#include "library/diagram_geometry.h"

namespace voroproof::internal {
namespace {

Vec2 at(const Cubic& curve, double t) {
  const double u = 1 - t;
  return (u * u * u) * curve[0] + (3 * u * u * t) * curve[1] + (3 * u * t * t) * curve[2] +
         (t * t * t) * curve[3];
}

// The bisector of a disk, the base, and another generator, in polar coordinates
// about the centre c of the base. With n a unit vector, d and s the differences of
// centres and signed radii (other minus base; the container's is negative) and
// p = d.d - s^2, it is the conic
//
//   rho(n) = p / (2 (d.n + s))   where that is positive,
//
// which has c as a focus. Two of its tangents, at directions n -+ delta/2, meet in
// direction n at the distance tau = p / (2 (d.n + s cos(delta/2))), and the arc
// between them is the rational quadratic Bezier curve of the weight
// sqrt(rho_0 rho_1) / tau over these three points.
class Bisector {
 public:
  Bisector(const Vec2& base, double base_radius, const Vec2& other, double other_radius)
      : c_(base),
        d_(other - base),
        s_(other_radius - base_radius),
        p_(dot(d_, d_) - s_ * s_),
        sign_(other_radius < 0 ? -1 : 1) {}

  // The arc from `start` to `end`, `sweep` (positive: counterclockwise) of angle
  // apart as seen from the base.
  void append_arc(const Vec2& start, const Vec2& end, double sweep, double tolerance,
                  std::vector<Cubic>& out) const {
    append(start, end, angle(start - c_), sweep, tolerance, max_halvings, out);
  }

  Vec2 point(double angle) const {
    const Vec2 n = direction(angle);
    return c_ + (p_ / (2 * (dot(d_, n) + s_))) * n;
  }

 private:
  static constexpr int max_halvings = 20;
  // Where the vertices of a file are not on the bisector no number of pieces is enough.
  static constexpr std::size_t max_pieces = 4096;

  void append(const Vec2& start, const Vec2& end, double from, double sweep, double tolerance,
              int halvings, std::vector<Cubic>& out) const {
    const Vec2 n = direction(from + sweep / 2);
    const double rho = p_ / (2 * (dot(d_, n) + s_));
    // Rounding can put the ends of a very short edge in the wrong order: then the
    // sweep leads through directions without a point.
    if (halvings == 0 || out.size() >= max_pieces || !(rho > 0 && std::isfinite(rho))) {
      out.push_back({start, start, end, end});
      return;
    }
    if (std::abs(sweep) < pi / 2) {
      const double tau = p_ / (2 * (dot(d_, n) + s_ * std::cos(sweep / 2)));
      const double weight = std::sqrt(length(start - c_) * length(end - c_)) / tau;
      if (tau > 0 && std::isfinite(weight)) {
        // The cubic with the same tangents and the same point half-way.
        const Vec2 apex = c_ + tau * n;
        const double pull = 4 * weight / (3 * (1 + weight));
        const Cubic cubic{start, start + pull * (apex - start), end + pull * (apex - end), end};
        if (distance(at(cubic, 0.25)) <= tolerance && distance(at(cubic, 0.75)) <= tolerance) {
          out.push_back(cubic);
          return;
        }
      }
    }
    const Vec2 middle = c_ + rho * n;
    append(start, middle, from, sweep / 2, tolerance, halvings - 1, out);
    append(middle, end, from + sweep / 2, sweep / 2, tolerance, halvings - 1, out);
  }

  // Distance of a point near the bisector from it, to first order: the difference
  // of the distances from the two generators over the length of its gradient.
  double distance(const Vec2& x) const {
    const Vec2 from_base = x - c_, from_other = from_base - d_;
    const double a = length(from_base), b = length(from_other);
    const double difference = std::abs(a - sign_ * b + s_);
    const double slope = length((1 / a) * from_base - (sign_ / b) * from_other);
    return difference == 0 ? 0 : difference / slope;
  }

  Vec2 c_, d_;
  double s_, p_, sign_;
};

Bisector bisector(const DiagramFile& diagram, GenId base, GenId other) {
  return {center(diagram, base), signed_radius(diagram, base), center(diagram, other),
          signed_radius(diagram, other)};
}

}  // namespace

EdgeCurves::EdgeCurves(const DiagramFile& diagram, double tolerance)
    : diagram_(diagram), tolerance_(tolerance) {
  for (const DiagramVertex& vertex : diagram.vertices)
    vertices_.emplace(canonical(vertex.generators), vertex.center);
}

std::vector<Cubic> EdgeCurves::of(const Quad& edge) const {
  const auto start = vertices_.find(start_vertex(edge));
  const auto end = vertices_.find(end_vertex(edge));
  if (start == vertices_.end() || end == vertices_.end())
    throw std::invalid_argument("diagram: edge " + text_of(edge) + " ends at no vertex");
  // The edge runs counterclockwise around the generator on its left and clockwise
  // around the one on its right.
  const bool base_is_left = edge.l != container_id;
  const GenId base = base_is_left ? edge.l : edge.r, other = base_is_left ? edge.r : edge.l;
  const Vec2& c = center(diagram_, base);
  double sweep = angle(end->second - c) - angle(start->second - c);
  if (!base_is_left) sweep = -sweep;
  // Ends closer than this coincide: rounding, not the edge, makes the rest of a turn.
  constexpr double least_angle = 1e-9;
  if (sweep < 0) sweep += 2 * pi;
  if (sweep > 2 * pi - least_angle) sweep -= 2 * pi;
  if (!base_is_left) sweep = -sweep;

  std::vector<Cubic> chain;
  bisector(diagram_, base, other).append_arc(start->second, end->second, sweep, tolerance_, chain);
  return chain;
}

std::vector<Cubic> EdgeCurves::only_cell() const {
  const Bisector ellipse = bisector(diagram_, 0, container_id);
  std::vector<Cubic> chain;
  for (int quarter = 0; quarter < 4; ++quarter) {
    ellipse.append_arc(ellipse.point(quarter * pi / 2), ellipse.point((quarter + 1) % 4 * pi / 2),
                       pi / 2, tolerance_, chain);
  }
  return chain;
}

}  // namespace voroproof::internal
