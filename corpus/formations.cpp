#include "corpus/formations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>

#include "corpus/generate_shared.h"

namespace voroproof::internal {
namespace {

using Places = std::vector<Point2>;

Rational ratio(long p, long q) {
  Rational value(p, q);
  value.canonicalize();
  return value;
}

// ---- Lattices and straight strokes, in units of the spacing. ----

Places square(int n) {
  const Lattice lattice(n, 1);
  Places places;
  for (int i = 0; i < n; ++i)
    places.push_back({ratio(lattice.across(i), 2), ratio(lattice.up(i), 2)});
  return places;
}

Places staggered(int n) {
  const Lattice lattice(n, 1);
  Places places = square(n);
  for (int i = 0; i < n; ++i) places[i].x += ratio(lattice.row(i) % 2 == 0 ? -1 : 1, 4);
  return places;
}

Places frame(int n) {
  const int side = (n + 3) / 4;
  Places places;
  for (int i = 0; i < n; ++i) {
    // The places lie along the lower side, then the others, each the one before turned by a right
    // angle.
    Point2 place{ratio(2 * (i % side) - (side - 1), 2), ratio(-(side + 1), 2)};
    for (int turn = 0; turn < i / side; ++turn) place = {-place.y, place.x};
    places.push_back(place);
  }
  return places;
}

Places letter_h(int n) {
  const int post = (7 * n + 9) / 19, bar = n - 2 * post;
  Places places;
  for (const int side : {-1, 1}) {
    for (int k = 0; k < post; ++k)
      places.push_back({ratio(side * (bar + 1), 2), ratio(2 * k - (post - 1), 2)});
  }
  for (int k = 0; k < bar; ++k) places.push_back({ratio(2 * k - (bar - 1), 2), 0});
  return places;
}

Places letter_y(int n) {
  const int arm = (6 * n + 9) / 19, stem = n - 2 * arm;
  Places places;
  for (int k = 0; k < stem; ++k) places.push_back({0, -k});
  // Steps of (3, 4) / 5 have length 1.
  for (const int side : {-1, 1}) {
    for (int k = 1; k <= arm; ++k) places.push_back({ratio(side * 3 * k, 5), ratio(4 * k, 5)});
  }
  const Rational middle = (ratio(4 * arm, 5) - (stem - 1)) / 2;
  for (Point2& place : places) place.y -= middle;
  return places;
}

// ---- Circles. ----

struct LatticePoint {
  std::int64_t x, y;
};

// The Gaussian primes above 5, 13, 17, 29, 37, 41 and 53. For each choice, prime by prime, of its
// square, its conjugate's square or the product of both, the product of all is a point of integers
// whose distance from the origin is 5 * 13 * ... * 53; with their quarter turns there are 8748.
constexpr std::array<LatticePoint, 7> gaussian_primes{
    {{2, 1}, {3, 2}, {4, 1}, {5, 2}, {6, 1}, {5, 4}, {7, 2}}};
constexpr std::int64_t circle_radius = 5LL * 13 * 17 * 29 * 37 * 41 * 53;

const std::vector<LatticePoint>& points_on_circle() {
  static const std::vector<LatticePoint> points = [] {
    const auto product = [](LatticePoint a, LatticePoint b) {
      return LatticePoint{a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
    };
    std::vector<LatticePoint> all{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    for (const LatticePoint prime : gaussian_primes) {
      const LatticePoint conjugate{prime.x, -prime.y};
      std::vector<LatticePoint> next;
      for (const LatticePoint p : all) {
        for (const LatticePoint factor :
             {product(prime, prime), product(prime, conjugate), product(conjugate, conjugate)})
          next.push_back(product(p, factor));
      }
      all = std::move(next);
    }
    return all;
  }();
  return points;
}

// The points nearest to n evenly spread directions. They are turned by half a step where one would
// lie between the axes, where there is no point and two are equally near: what can be symmetric is.
std::vector<LatticePoint> spread_on_circle(int n) {
  const double offset = n % 8 == 0 ? 0.5 : 0;
  std::vector<LatticePoint> chosen;
  for (int i = 0; i < n; ++i) {
    const Vec direction = polar(two_pi * ((i + offset) / n), 1);
    const auto along = [&](LatticePoint p) {
      return direction.x * static_cast<double>(p.x) + direction.y * static_cast<double>(p.y);
    };
    const auto& points = points_on_circle();
    chosen.push_back(*std::max_element(points.begin(), points.end(),
                                       [&](auto p, auto q) { return along(p) < along(q); }));
  }
  return chosen;
}

// The least distance between neighbours.
double shortest_chord(const std::vector<LatticePoint>& points) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const LatticePoint p = points[i], q = points[(i + 1) % points.size()];
    const auto dx = static_cast<double>(p.x - q.x), dy = static_cast<double>(p.y - q.y);
    if (points.size() > 1) least = std::min(least, std::sqrt(dx * dx + dy * dy));
  }
  return least;
}

// A factor that makes the length at least 1, with few bits, for short coordinates.
double stretch(double length) {
  if (!(length > 0))
    throw std::invalid_argument("generate: too many disks for a circle of exact points");
  int exponent = 0;
  const double significand = std::frexp((1 + gap_margin) / length, &exponent);
  return std::ldexp(std::ceil(significand * 0x1p12), exponent - 12);
}

void add_scaled(Places& places, const std::vector<LatticePoint>& points, const Rational& scale) {
  for (const LatticePoint p : points)
    places.push_back({scale * Rational(p.x), scale * Rational(p.y)});
}

Places circle(int n) {
  const std::vector<LatticePoint> points = spread_on_circle(n);
  Places places;
  add_scaled(places, points, to_rational(n > 1 ? stretch(shortest_chord(points)) : 0));
  return places;
}

Places rings(int n) {
  Places places;
  if (n > 0) places.push_back({0, 0});
  std::vector<std::vector<LatticePoint>> circles;
  for (int left = n - 1; left > 0; left -= static_cast<int>(circles.back().size()))
    circles.push_back(spread_on_circle(std::min(left, 8 * (static_cast<int>(circles.size()) + 1))));
  if (circles.empty()) return places;
  // The k-th ring has k times the radius of the first; two are at least a spacing apart.
  auto least = static_cast<double>(circle_radius);
  for (std::size_t k = 0; k < circles.size(); ++k)
    least = std::min(least, static_cast<double>(k + 1) * shortest_chord(circles[k]));
  const Rational scale = to_rational(stretch(least));
  for (std::size_t k = 0; k < circles.size(); ++k) add_scaled(places, circles[k], scale * (k + 1));
  return places;
}

const std::map<std::string, Places (*)(int), std::less<>>& formations() {
  static const std::map<std::string, Places (*)(int), std::less<>> by_name{
      {"square", &square}, {"staggered", &staggered}, {"frame", &frame}, {"circle", &circle},
      {"rings", &rings},   {"h", &letter_h},          {"y", &letter_y}};
  return by_name;
}

}  // namespace

std::vector<Point2> formation_places(std::string_view name, int n, const Rational& spacing) {
  const auto formation = formations().find(name);
  if (formation == formations().end())
    throw std::invalid_argument("generate: no formation is called '" + std::string(name) + "'");
  Places places = formation->second(n);
  for (Point2& place : places) {
    place.x *= spacing;
    place.y *= spacing;
  }
  return places;
}

bool is_formation(std::string_view name) { return formations().contains(name); }

}  // namespace voroproof::internal
