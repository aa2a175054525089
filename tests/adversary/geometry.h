// Plane geometry of the adversary's worlds, in long double: tangent circles, in-circle functions,
// roots of polynomials. Written anew: nothing here is the project's arithmetic.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "tests/adversary/claims.h"

namespace voroproof::internal::adversary {

using Real = long double;
inline constexpr Real never = std::numeric_limits<Real>::infinity();

struct Vec {
  Real x = 0, y = 0;
};
inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y}; }
inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }
inline Vec operator*(Real s, Vec a) { return {s * a.x, s * a.y}; }
inline Real dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y; }
inline Real cross(Vec a, Vec b) { return a.x * b.y - a.y * b.x; }
inline Real length(Vec a) { return std::sqrt(dot(a, a)); }

// A generator at one instant: signed radius, -R of the container.
struct Site {
  Vec at;
  Real r = 0;
  bool container() const { return r < 0; }
};

struct Circle {
  Vec at;
  Real r = 0;
};

// |c_a - c_b|^2 - (r_a - r_b)^2
inline Real tangency(const Site& a, const Site& b) {
  const Vec d = a.at - b.at;
  return dot(d, d) - (a.r - b.r) * (a.r - b.r);
}

// How far the generator is from touching the circle; negative: it enters it.
inline Real clearance(const Site& g, const Circle& c) {
  const Real d = length(g.at - c.at);
  return g.container() ? -g.r - d - c.r : d - g.r - c.r;
}

// The circle that i, j, k touch counterclockwise in this order, if there is one.
std::optional<Circle> tangent_circle(const Site& i, const Site& j, const Site& k);

// The in-circle function of the circle of i, j, k and the site e: positive outside. Formal: also
// where no circle exists. NaN where a tangency has the wrong sign.
Real in_circle(Site i, Site j, Site k, const Site& e);

// A polynomial of degree at most 8, lowest power first.
struct Poly {
  std::array<Real, 9> c{};
  int degree = 0;
  Real operator()(Real t) const {
    Real sum = 0;
    for (int k = degree; k >= 0; --k) sum = sum * t + c[static_cast<std::size_t>(k)];
    return sum;
  }
};
Poly operator*(const Poly& a, const Poly& b);
Poly operator+(const Poly& a, const Poly& b);
Poly operator-(const Poly& a, const Poly& b);
Poly operator*(Real s, Poly a);

// The places in (0, 1) where p changes its sign, in order.
void roots(const Poly& p, std::vector<Real>& found);

// A generator that moves on a line: centre at the reference time and velocity.
struct MovingSite {
  Vec at, v;
  Real r = 0;
};

// Zero where the four have a common tangent circle; of four equal radii the determinant that
// vanishes where the centres lie on one circle. In units of w of the time.
Poly cotangency(const std::array<MovingSite, 4>& g, Real w);

// All generators with the container first.
using Sites = std::vector<Site>;
inline const Site& site(const Sites& sites, int id) {
  return sites[static_cast<std::size_t>(id + 1)];
}

// A V-vertex and its circle.
struct Vertex {
  std::array<int, 3> g{};
  Circle circle;
};

// The edges that join the vertices, cell by cell; none where the vertices are not those of a
// diagram.
std::vector<Edge> edges_between(const std::vector<Vertex>& vertices, const Sites& sites);

// The diagram by trying all circles. `margin`, where given, receives the least clearance of a
// fourth generator from a vertex's circle: near zero the result means nothing. Empty where no
// diagram was found.
std::vector<Edge> diagram_of_sites(const Sites& sites, Real* margin);

}  // namespace voroproof::internal::adversary
