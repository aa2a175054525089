// The kinetic Delaunay triangulation of moving points, straight from its definition: it changes
// where four points lie on one circle that is empty of all others.
#pragma once

#include <gmpxx.h>

#include <array>
#include <vector>

namespace voroproof::oracle {

struct MovingPoint {
  mpq_class x, y, vx, vy;
};

// Coefficients, from the constant one on, of the in-circle determinant of four moving points: the
// rows (x, y, x^2 + y^2, 1). The degree is 4; leading zeros are cut off.
std::vector<mpq_class> incircle_polynomial(const std::array<MovingPoint, 4>& points);

struct DelaunayFlip {
  mpq_class lo, hi;           // the time lies in between; hi - lo <= 2^-200
  std::array<int, 4> points;  // ascending
};

// All changes in (0, horizon), in order, at circles that lie inside the circle around the origin of
// the given radius. Roots are isolated by Sturm's theorem. Throws std::logic_error where something
// is too near to tell (a double root, a fifth point on the circle, two changes at once): this is
// for points in general position. Costs O(n^5).
std::vector<DelaunayFlip> delaunay_flips(const std::vector<MovingPoint>& points,
                                         const mpq_class& container_radius,
                                         const mpq_class& horizon);

}  // namespace voroproof::oracle
