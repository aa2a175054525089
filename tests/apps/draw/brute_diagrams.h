// Diagrams found by brute force, in doubles, to be drawn.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <set>
#include <vector>

#include "history/diagram_file.h"

namespace voroproof::internal::testing {

inline constexpr double pi = std::numbers::pi;

inline Vec2 minus(const Vec2& a, const Vec2& b) { return {a[0] - b[0], a[1] - b[1]}; }
inline double norm(const Vec2& a) { return std::hypot(a[0], a[1]); }

inline const Vec2& center(const DiagramFile& d, GenId id) {
  return id == container_id ? d.container_center : d.disks[id].center;
}
inline double signed_radius(const DiagramFile& d, GenId id) {
  return id == container_id ? -d.container_radius : d.disks[id].radius;
}

// Distance of a point to a generator.
inline double gap(const DiagramFile& d, GenId id, const Vec2& x) {
  const double distance = norm(minus(x, center(d, id)));
  return id == container_id ? d.container_radius - distance : distance - d.disks[id].radius;
}

inline double nearest_gap(const DiagramFile& d, const Vec2& x) {
  double least = gap(d, container_id, x);
  for (std::size_t i = 0; i < d.disks.size(); ++i)
    least = std::min(least, gap(d, static_cast<GenId>(i), x));
  return least;
}

// The circles that touch i, j, k from outside (the container from inside).
inline std::vector<DiagramVertex> tangent_circles(const DiagramFile& d, GenId i, GenId j, GenId k) {
  // Differences to i, a disk, give two linear equations 2 dx.x + 2 ds rho = p in
  // the centre x about that of i and its distance rho from it: x = a + b rho.
  const Vec2 dj = minus(center(d, j), center(d, i)), dk = minus(center(d, k), center(d, i));
  const double sj = signed_radius(d, j) - signed_radius(d, i);
  const double sk = signed_radius(d, k) - signed_radius(d, i);
  const double pj = (dj[0] * dj[0] + dj[1] * dj[1] - sj * sj) / 2;
  const double pk = (dk[0] * dk[0] + dk[1] * dk[1] - sk * sk) / 2;
  const double det = dj[0] * dk[1] - dj[1] * dk[0];
  const Vec2 a{(pj * dk[1] - pk * dj[1]) / det, (pk * dj[0] - pj * dk[0]) / det};
  const Vec2 b{(-sj * dk[1] + sk * dj[1]) / det, (-sk * dj[0] + sj * dk[0]) / det};
  const double A = b[0] * b[0] + b[1] * b[1] - 1, B = a[0] * b[0] + a[1] * b[1];
  const double C = a[0] * a[0] + a[1] * a[1];
  std::vector<DiagramVertex> found;
  if (B * B < A * C) return found;
  for (double root : {std::sqrt(B * B - A * C), -std::sqrt(B * B - A * C)}) {
    const double rho = (-B + root) / A;
    const Vec2 x{center(d, i)[0] + a[0] + b[0] * rho, center(d, i)[1] + a[1] + b[1] * rho};
    const double radius = rho - d.disks[i].radius;
    const double tolerance = 1e-9 * d.container_radius;
    if (radius < 0 || std::abs(gap(d, j, x) - radius) > tolerance ||
        std::abs(gap(d, k, x) - radius) > tolerance)
      continue;
    const auto contact = [&](GenId id) {
      const Vec2 v = minus(center(d, id), x);
      return id == container_id ? std::atan2(-v[1], -v[0]) : std::atan2(v[1], v[0]);
    };
    const auto turn = [&](GenId id) {
      return std::fmod(contact(id) - contact(i) + 4 * pi, 2 * pi);
    };
    found.push_back({canonical(turn(j) < turn(k) ? Triple{i, j, k} : Triple{i, k, j}), x, radius});
  }
  return found;
}

// Vertices: all empty tangent circles. Edges: from each start the next vertex of
// the same two generators, counterclockwise around the left (clockwise around the
// right) one.
inline void complete(DiagramFile& d) {
  const int n = static_cast<int>(d.disks.size());
  for (GenId i = 0; i < n; ++i) {
    for (GenId j = container_id; j < i; ++j) {
      for (GenId k = container_id; k < j; ++k) {
        for (const DiagramVertex& v : tangent_circles(d, i, j, k)) {
          if (nearest_gap(d, v.center) > v.radius - 1e-9 * d.container_radius)
            d.vertices.push_back(v);
        }
      }
    }
  }
  std::set<Quad> edges;
  for (const DiagramVertex& start : d.vertices) {
    for (int turn = 0; turn < 3; ++turn) {
      const GenId l = start.generators[turn], s = start.generators[(turn + 1) % 3];
      const GenId r = start.generators[(turn + 2) % 3];
      const GenId base = l == container_id ? r : l;
      const auto direction = [&](const DiagramVertex& v) {
        const Vec2 from = minus(v.center, center(d, base));
        return (base == l ? 1 : -1) * std::atan2(from[1], from[0]);
      };
      GenId e = s;
      double least = 7;
      for (const DiagramVertex& end : d.vertices) {
        for (int other = 0; other < 3; ++other) {
          if (end.generators[other] != l || end.generators[(other + 1) % 3] != r) continue;
          const double sweep = std::fmod(direction(end) - direction(start) + 4 * pi, 2 * pi);
          if (sweep < least) {
            least = sweep;
            e = end.generators[(other + 2) % 3];
          }
        }
      }
      edges.insert(canonical(Quad{l, r, s, e}));
    }
  }
  d.edges.assign(edges.begin(), edges.end());
}

// Disjoint disks of very different radii: a few large ones, the others small.
inline DiagramFile random_diagram(int n, unsigned seed) {
  std::mt19937_64 engine(seed);
  const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  DiagramFile d;
  d.container_center = {3, -2};
  d.container_radius = 100;
  while (static_cast<int>(d.disks.size()) < n) {
    const double radius = d.disks.size() < 3 ? 24 - 6.0 * static_cast<double>(d.disks.size())
                                             : 0.2 * std::pow(50.0, uniform());
    const Vec2 at{3 + 200 * (uniform() - 0.5), -2 + 200 * (uniform() - 0.5)};
    if (nearest_gap(d, at) < radius + 0.2) continue;
    const double heading = 2 * pi * uniform(), speed = 0.2 + uniform();
    d.disks.push_back({at, radius, {speed * std::cos(heading), speed * std::sin(heading)}});
  }
  complete(d);
  return d;
}

inline DiagramFile square_lattice(int side) {
  DiagramFile d;
  d.container_radius = 3.0 * side;
  for (int i = 0; i < side * side; ++i) {
    // Off the lattice by a little, so that brute force meets no cocircular disks.
    const double shift = 1e-3 * std::sin(7.0 * i);
    d.disks.push_back({{4.0 * (i % side) - 2.0 * (side - 1) + shift,
                        4.0 * (i / side) - 2.0 * (side - 1) + shift * shift + 1e-3 * std::cos(i)},
                       1,
                       {0, 0}});
  }
  complete(d);
  return d;
}

inline DiagramFile lone_disk() {
  DiagramFile d;
  d.container_radius = 10;
  d.disks.push_back({{4, 3}, 2, {1, 0}});
  return d;
}

// A disk in the crack between two large ones and the container: two-edge cells and
// pairs with several edges.
inline DiagramFile crack() {
  DiagramFile d;
  d.container_radius = 10;
  d.disks = {{{-4.5, 0}, 4.4, {0.3, 0.1}},
             {{4.5, 0.1}, 4.4, {-0.3, 0}},
             {{0.01, 0}, 0.05, {0, 1}},
             {{0.02, 1.5}, 0.1, {0, -1}},
             {{-8, -5.2}, 0.2, {0, 0}}};
  complete(d);
  return d;
}

}  // namespace voroproof::internal::testing
