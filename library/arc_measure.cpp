#include "library/arc_measure.h"

#include <algorithm>
#include <array>
#include <limits>

namespace voroproof::internal {
namespace {

DoubleBall length(const BallPoint& a) { return sqrt(dot(a, a)); }
BallPoint scaled(const DoubleBall& k, const BallPoint& a) { return {k * a.x, k * a.y}; }
BallPoint operator+(const BallPoint& a, const BallPoint& b) { return {a.x + b.x, a.y + b.y}; }

// The area between the chord and the arc is f(z) of the triangle of the control points, with z the
// roundness, and its centroid is h(z) of the way from the middle of the chord to the middle point.
// For an arc of a circle, z = sin^2 of half its angle, elementary geometry gives both, and an
// affine map and analytic continuation the other arcs:
//
//   f = (2/3) (1 - z) 2F1(1, 2; 5/2; z) = 2/3 - z Q(z),   f h = (1 - z) Q(z),
//   Q = (2/15) 2F1(1, 2; 7/2; z) = sum of q_k z^k,   q_(k+1) / q_k = (k + 2) / (k + 7/2) < 1.
//
// So the terms from n on are at most q_n |z|^n / (1 - |z|); q_24 < 1/300.
constexpr double most_roundness = 0.25;

struct Segment {
  DoubleBall f, fh;
};

Segment segment(const DoubleBall& z) {
  constexpr int terms = 24;
  static const std::array<DoubleBall, terms> q = [] {
    std::array<DoubleBall, terms> all;
    all[0] = DoubleBall(2) / DoubleBall(15);
    for (int k = 0; k + 1 < terms; ++k) {
      all[k + 1] = all[k] * DoubleBall(2 * k + 4) / DoubleBall(2 * k + 7);
    }
    return all;
  }();
  DoubleBall sum = q[terms - 1];
  for (int k = terms - 2; k >= 0; --k) sum = sum * z + q[k];
  sum.rad += 0x1p-55;  // 4^-24 / (300 (1 - 1/4)) = 2^-55.8
  return {DoubleBall(2) / DoubleBall(3) - z * sum, (DoubleBall(1) - z) * sum};
}

// The length of an arc with the weights 1, w, 1 is the integral over h from -1/2 to 1/2 of
//
//   2 |V| / D^2,   V = (1 + w)/4 (e + g) + h w (g - e) + h^2 (w - 1) (e + g),
//                  D = (1 + w)/2 + 2 h^2 (1 - w),
//
// where e and g are the legs from the start to the middle point and on to the end.
struct Speed {
  Speed(const BallPoint& e, const BallPoint& g, const DoubleBall& w)
      : d0(DoubleBall(0.5) * (DoubleBall(1) + w)), d2(DoubleBall(2) * (DoubleBall(1) - w)) {
    const BallPoint chord = e + g, v0 = scaled(DoubleBall(0.5) * d0, chord), v1 = scaled(w, g - e),
                    v2 = scaled(w - DoubleBall(1), chord);
    n = {dot(v0, v0), DoubleBall(2) * dot(v0, v1), dot(v1, v1) + DoubleBall(2) * dot(v0, v2),
         DoubleBall(2) * dot(v1, v2), dot(v2, v2)};
  }

  DoubleBall at(const DoubleBall& h) const {
    const DoubleBall square = n[0] + h * (n[1] + h * (n[2] + h * (n[3] + h * n[4])));
    const DoubleBall d = d0 + h * h * d2;
    return DoubleBall(2) * sqrt(square) / (d * d);
  }

  // Where it is analytic for all |h| <= r a bound of its absolute value, else infinity.
  double bound(double r) const {
    double off = 0, power = 1;
    for (int k = 1; k < 5; ++k) off += (power *= r) * (std::fabs(n[k].mid) + n[k].rad);
    off *= 1 + 0x1p-40;
    const double least = (d0.mid - d0.rad - (std::fabs(d2.mid) + d2.rad) * r * r) * (1 - 0x1p-40);
    if (!(off < lower(n[0]) && least > 0)) return std::numeric_limits<double>::infinity();
    return 2 * std::sqrt(upper(n[0]) + off) / (least * least) * (1 + 0x1p-40);
  }

  DoubleBall d0, d2;
  std::array<DoubleBall, 5> n;  // |V|^2 by powers of h
};

// Gauss's quadrature with 10 points is exact for polynomials of degree 19. In [-1, 1] one of that
// degree is within 2 M rho^-19 / (rho - 1) of a function that is analytic and at most M in the
// ellipse of Bernstein of the parameter rho (Trefethen, "Approximation Theory and Approximation
// Practice", theorem 8.2), so that the error is at most 4 times that; for h it is half of it. With
// rho = 3 the ellipse lies in |h| <= (rho + 1/rho) / 4 = 5/6.
constexpr double analytic_radius = 0.8334, quadrature_error = 0x1p-29;  // 2 3^-19 = 2^-29.1

DoubleBall quadrature(const Speed& speed, double bound) {
  struct Node {
    double h, weight;
  };
  // In [-1, 1], rounded to nearest.
  constexpr std::array<Node, 5> nodes{{{0.14887433898163121088, 0.29552422471475287017},
                                       {0.43339539412924719079, 0.26926671930999635509},
                                       {0.67940956829902440623, 0.21908636251598204400},
                                       {0.86506336668898451073, 0.14945134915058059315},
                                       {0.97390652851717172008, 0.06667134430868813759}}};
  DoubleBall sum = 0;
  for (const auto& [h, weight] : nodes) {
    const DoubleBall at(h / 2, 0x1p-54), half_weight(weight / 2, 0x1p-54);
    sum = sum + half_weight * (speed.at(at) + speed.at(-at));
  }
  sum.rad += quadrature_error * bound;
  return sum;
}

// Whether halving brings nothing, since rounding hides how the arc bends.
bool is_blurred(const std::array<BallPoint, 3>& points, double size) {
  double blur = 0;
  for (const BallPoint& p : points) blur = std::max({blur, p.x.rad, p.y.rad});
  return !(size > 0x1p10 * blur);
}

// Some number from 0 to 1.
DoubleBall unit_interval() { return {0.5, 0.5}; }

}  // namespace

bool measure_piece(const ConicArc& arc, bool at_any_rate, ArcMeasure& measure) {
  const double infinity = std::numeric_limits<double>::infinity();
  if (!arc.is_proper()) {
    const DoubleBall any(0, infinity);
    measure = {{any, any}, {any, any}, any, {any, any}, any};
    return at_any_rate || !arc.has_proper_ends();
  }
  const std::array<BallPoint, 3> points = arc.points();
  const BallPoint chord = points[2] - points[0], e = points[1] - points[0],
                  g = points[2] - points[1];
  measure = {points[0], points[2], 0, {0, 0}, length(chord)};
  if (arc.is_straight()) return true;

  const DoubleBall z = arc.roundness();
  const bool is_flat = std::fabs(z.mid) + z.rad <= most_roundness;
  double bound = infinity;
  if (is_flat) {
    const Speed speed(e, g, sqrt(DoubleBall(1) - z));
    bound = speed.bound(analytic_radius);
    if (bound < infinity) measure.length = quadrature(speed, bound);
  }
  if (!(bound < infinity)) {
    const DoubleBall legs = length(e) + length(g);
    if (!at_any_rate && !is_blurred(points, legs.mid)) return false;
    // Gravesen, "Adaptive subdivision and the length and energy of Bezier curves" (1997).
    measure.length = DoubleBall::hull(std::fmax(lower(measure.length), 0), upper(legs));
  }
  const Segment part = is_flat ? segment(z) : Segment{unit_interval(), unit_interval()};
  const DoubleBall triangle = DoubleBall(0.5) * cross(e, chord);
  measure.area = triangle * part.f;
  measure.moment = scaled(triangle * part.fh * DoubleBall(0.5), e - g);
  return true;
}

}  // namespace voroproof::internal
