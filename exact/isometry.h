// Isometries of the plane over the rationals.
#pragma once

#include <span>
#include <vector>

#include "exact/rational.h"

namespace voroproof::internal {

struct Vector {
  Rational x, y;
  bool operator==(const Vector& o) const { return x == o.x && y == o.y; }
};

// x -> (a, -b; b, a) x + shift, a rotation or translation; or, if it reflects,
// x -> (a, b; b, -a) x + shift. a^2 + b^2 = 1.
struct Isometry {
  Rational a, b;
  bool reflects;
  Vector shift;

  // The image of a difference of points.
  Vector turn(const Vector& v) const;
  Vector operator()(const Vector& p) const;
};

// A pair of vectors or points: the isometry is to carry `from` onto `to`.
struct Image {
  Vector from, to;
};

// The isometries that carry all points and all vectors (velocities, say) onto their
// images: at most one that reflects and one that does not. Where these leave more freedom
// (one point, no vector but zero) it gives one of each kind. Precondition: a point.
std::vector<Isometry> isometries(std::span<const Image> points, std::span<const Image> vectors);

// Whether one point is fixed by all.
bool have_fixed_point(std::span<const Isometry> all);

}  // namespace voroproof::internal
