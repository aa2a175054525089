// Arcs of conics with bounds of all errors.
#pragma once

#include <array>

#include "filtered/numbers/double_ball.h"

namespace voroproof::internal {

struct BallPoint {
  DoubleBall x, y;
};
inline BallPoint operator-(const BallPoint& a, const BallPoint& b) {
  return {a.x - b.x, a.y - b.y};
}
inline DoubleBall dot(const BallPoint& a, const BallPoint& b) { return a.x * b.x + a.y * b.y; }
inline DoubleBall cross(const BallPoint& a, const BallPoint& b) { return a.x * b.y - a.y * b.x; }

// The true value is in [lower, upper].
inline double lower(const DoubleBall& a) {
  return (a.mid - a.rad) - std::fabs(a.mid - a.rad) * 0x1p-52;
}
inline double upper(const DoubleBall& a) {
  return (a.mid + a.rad) + std::fabs(a.mid + a.rad) * 0x1p-52;
}

// A rational quadratic Bezier curve: the homogeneous control points (x, y, weight) are combined by
// the Bernstein polynomials of degree 2 in t from 0 to 1. A weight of 0 at an end is a place at
// infinity. The true arc has some numbers of the balls, and a parameter t means the true arc's.
class ConicArc {
 public:
  struct Control {
    DoubleBall x, y, weight;
  };

  explicit ConicArc(const std::array<Control, 3>& controls) : controls_(controls) {}
  // Straight. Places far from the origin get small weights, so that they do not blur the others.
  static ConicArc segment(const BallPoint& start, const BallPoint& end);

  const Control& control(int k) const { return controls_[k]; }
  // Precondition: the weight is certainly not 0.
  BallPoint point(int k) const;
  std::array<BallPoint, 3> points() const { return {point(0), point(1), point(2)}; }
  bool is_straight() const { return straight_; }
  // Whether all weights are certainly positive, so that the arc is in the triangle of its points.
  bool is_proper() const;
  // Whether halves may be proper, or those of them, where the arc is not.
  bool has_proper_ends() const;

  std::array<ConicArc, 2> halves() const;
  // From t = `from` to t = `to`, multiples of 2^-50.
  ConicArc part(double from, double to) const;
  ConicArc reversed() const;

  // 1 - w^2, w the weight of the middle one where those of the ends are made 1: 0 for a parabola,
  // less for a hyperbola, more for an ellipse. Precondition: the arc is proper.
  DoubleBall roundness() const;

 private:
  Control blossom(double s, double t) const;

  std::array<Control, 3> controls_;
  bool straight_ = false;
};

}  // namespace voroproof::internal
