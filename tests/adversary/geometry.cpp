#include "tests/adversary/geometry.h"

#include <algorithm>
#include <limits>
#include <set>

namespace voroproof::internal::adversary {
namespace {

// What the sites j and k give, seen from the base i (docs/design/predicates.md).
struct Triple {
  Real xp, yp, sp, xs, ys, xy, gamma, epsilon;
  Triple(const Site& i, const Site& j, const Site& k) {
    const Vec a = j.at - i.at, b = k.at - i.at;
    const Real s = j.r - i.r, t = k.r - i.r;
    const Real p = dot(a, a) - s * s, q = dot(b, b) - t * t;
    xp = a.x * q - p * b.x;
    yp = a.y * q - p * b.y;
    sp = s * q - p * t;
    xs = a.x * t - s * b.x;
    ys = a.y * t - s * b.y;
    xy = cross(a, b);
    gamma = p * q * tangency(j, k);
    epsilon = j.container() || k.container() ? 1 : -1;
  }
};

// The base must be a disk.
void turn_container_away(Site& i, Site& j, Site& k) {
  if (!i.container()) return;
  const Site first = i;
  i = j;
  j = k;
  k = first;
}

int sign_changes(const std::array<Real, 9>& b, int degree) {
  int changes = 0;
  Real last = 0;
  for (int k = 0; k <= degree; ++k) {
    const Real x = b[static_cast<std::size_t>(k)];
    if (x == 0) continue;
    if (last != 0 && (x > 0) != (last > 0)) ++changes;
    last = x;
  }
  return changes;
}

Real bisect(const Poly& p, Real lo, Real hi) {
  const bool rising = p(lo) < 0;
  for (int k = 0; k < 80; ++k) {
    const Real middle = (lo + hi) / 2;
    if (middle <= lo || middle >= hi) break;
    ((p(middle) < 0) == rising ? lo : hi) = middle;
  }
  return hi;
}

void search(const Poly& p, std::array<Real, 9> b, Real lo, Real hi, int depth,
            std::vector<Real>& found) {
  const int changes = sign_changes(b, p.degree);
  if (changes == 0) return;
  if (changes == 1 && (p(lo) < 0) != (p(hi) < 0)) {
    found.push_back(bisect(p, lo, hi));
    return;
  }
  if (depth == 0) return;  // a double root within rounding: no change of sign
  const Real middle = (lo + hi) / 2;
  std::array<Real, 9> left{};
  const auto n = static_cast<std::size_t>(p.degree);
  for (std::size_t k = 0; k <= n; ++k) {
    left[k] = b[0];
    for (std::size_t m = 0; m < n - k; ++m) b[m] = (b[m] + b[m + 1]) / 2;
  }
  // b now holds the right half.
  std::array<Real, 9> right{};
  for (std::size_t k = 0; k <= n; ++k) right[k] = b[k];
  search(p, left, lo, middle, depth - 1, found);
  search(p, right, middle, hi, depth - 1, found);
}

}  // namespace

std::optional<Circle> tangent_circle(const Site& i0, const Site& j0, const Site& k0) {
  Site i = i0, j = j0, k = k0;
  turn_container_away(i, j, k);
  const Triple t(i, j, k);
  if (!(t.gamma >= 0)) return std::nullopt;
  const Real root = std::sqrt(t.gamma);
  const Real kappa = t.xp * t.xs + t.yp * t.ys - t.epsilon * root * t.xy;
  if (!(kappa > 0)) return std::nullopt;
  const Real nx = -t.sp * t.xp + t.epsilon * root * t.yp;
  const Real ny = -t.sp * t.yp - t.epsilon * root * t.xp;
  const Circle c{{i.at.x + nx / (2 * kappa), i.at.y + ny / (2 * kappa)},
                 (t.xp * t.xp + t.yp * t.yp) / (2 * kappa) - i.r};
  if (!(c.r >= 0)) return std::nullopt;
  return c;
}

Real in_circle(Site i, Site j, Site k, const Site& e) {
  turn_container_away(i, j, k);
  const Triple t(i, j, k);
  const Vec d = e.at - i.at;
  const Real s = e.r - i.r, p = dot(d, d) - s * s;
  const Real a = d.x * t.sp - s * t.xp + p * t.xs, b = d.y * t.sp - s * t.yp + p * t.ys;
  const Real c = d.x * t.yp - d.y * t.xp + p * t.xy;
  const Real q = t.xp * a + t.yp * b - t.epsilon * std::sqrt(t.gamma) * c;
  return e.container() ? -q : q;
}

Poly operator*(const Poly& a, const Poly& b) {
  Poly c;
  c.degree = a.degree + b.degree;
  for (int i = 0; i <= a.degree; ++i) {
    for (int j = 0; j <= b.degree; ++j) {
      c.c[static_cast<std::size_t>(i + j)] +=
          a.c[static_cast<std::size_t>(i)] * b.c[static_cast<std::size_t>(j)];
    }
  }
  return c;
}

Poly operator+(const Poly& a, const Poly& b) {
  Poly c = a;
  c.degree = std::max(a.degree, b.degree);
  for (std::size_t k = 0; k < c.c.size(); ++k) c.c[k] += b.c[k];
  return c;
}

Poly operator*(Real s, Poly a) {
  for (Real& x : a.c) x *= s;
  return a;
}

Poly operator-(const Poly& a, const Poly& b) { return a + (-1) * b; }

void roots(const Poly& p, std::vector<Real>& found) {
  // Bernstein coefficients over [0, 1]: b_k = sum_j C(k,j)/C(n,j) c_j.
  static const auto ratio = [] {
    std::array<std::array<std::array<Real, 9>, 9>, 9> r{};
    const auto choose = [](int n, int k) {
      Real c = 1;
      for (int i = 0; i < k; ++i) c = c * (n - i) / (i + 1);
      return c;
    };
    for (int n = 0; n < 9; ++n) {
      for (int k = 0; k <= n; ++k) {
        for (int j = 0; j <= k; ++j) {
          r[static_cast<std::size_t>(n)][static_cast<std::size_t>(k)][static_cast<std::size_t>(j)] =
              choose(k, j) / choose(n, j);
        }
      }
    }
    return r;
  }();
  std::array<Real, 9> b{};
  const auto n = static_cast<std::size_t>(p.degree);
  for (std::size_t k = 0; k <= n; ++k) {
    for (std::size_t j = 0; j <= k; ++j) b[k] += ratio[n][k][j] * p.c[j];
  }
  search(p, b, 0, 1, 40, found);
}

Poly cotangency(const std::array<MovingSite, 4>& g, Real w) {
  const auto power = [&](std::size_t i, std::size_t j) {
    const Vec d = g[i].at - g[j].at, v = w * (g[i].v - g[j].v);
    const Real dr = g[i].r - g[j].r;
    Poly p;
    p.degree = 2;
    p.c[0] = dot(d, d) - dr * dr;
    p.c[1] = 2 * dot(d, v);
    p.c[2] = dot(v, v);
    return p;
  };
  if (g[1].r == g[0].r && g[2].r == g[0].r && g[3].r == g[0].r) {
    Poly sum;
    sum.degree = 4;
    const auto line = [](Real at, Real v) {
      Poly p;
      p.degree = 1;
      p.c[0] = at;
      p.c[1] = v;
      return p;
    };
    std::array<Poly, 3> x, y;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec d = g[k + 1].at - g[0].at, v = w * (g[k + 1].v - g[0].v);
      x[k] = line(d.x, v.x);
      y[k] = line(d.y, v.y);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      sum = sum + power(k + 1, 0) * (x[i] * y[j] - x[j] * y[i]);
    }
    return sum;
  }
  const Poly a = power(0, 1) * power(2, 3), b = power(0, 2) * power(1, 3),
             c = power(0, 3) * power(1, 2);
  const Poly d = a - b - c;
  return d * d - 4 * (b * c);
}

std::vector<Edge> edges_between(const std::vector<Vertex>& vertices, const Sites& sites) {
  std::set<Edge> edges;
  const int n = static_cast<int>(sites.size()) - 1;
  std::vector<std::pair<Real, const Vertex*>> around;
  for (int l = 0; l < n; ++l) {
    around.clear();
    for (const Vertex& v : vertices) {
      if (std::find(v.g.begin(), v.g.end(), l) == v.g.end()) continue;
      const Vec d = v.circle.at - site(sites, l).at;
      around.emplace_back(std::atan2(d.y, d.x), &v);
    }
    std::sort(around.begin(), around.end());
    const auto at = [l](const Vertex& v, int step) {
      const auto place = std::find(v.g.begin(), v.g.end(), l) - v.g.begin();
      return v.g[static_cast<std::size_t>((place + step) % 3)];
    };
    for (std::size_t k = 0; k < around.size(); ++k) {
      const Vertex &start = *around[k].second, &end = *around[(k + 1) % around.size()].second;
      if (at(start, 2) != at(end, 1)) return {};
      edges.insert(canonical({l, at(start, 2), at(start, 1), at(end, 2)}));
    }
  }
  if (n < 2 || static_cast<int>(edges.size()) != 3 * (n + 1) - 6) return {};
  return {edges.begin(), edges.end()};
}

std::vector<Edge> diagram_of_sites(const Sites& sites, Real* margin) {
  const int n = static_cast<int>(sites.size()) - 1;
  std::vector<Vertex> vertices;
  Real least = never;
  const auto offer = [&](const std::array<int, 3>& g) {
    const auto c = tangent_circle(site(sites, g[0]), site(sites, g[1]), site(sites, g[2]));
    if (!c) return;
    Real closest = never;
    for (int id = -1; id < n; ++id) {
      if (id == g[0] || id == g[1] || id == g[2]) continue;
      closest = std::min(closest, clearance(site(sites, id), *c));
      if (closest < 0 && (margin == nullptr || -closest > least)) return;
    }
    least = std::min(least, std::abs(closest));
    if (closest > 0) vertices.push_back({g, *c});
  };
  for (int i = -1; i < n; ++i) {
    for (int j = i + 1; j < n; ++j) {
      for (int k = j + 1; k < n; ++k) {
        offer({i, j, k});
        offer({i, k, j});
      }
    }
  }
  if (margin != nullptr) *margin = least;
  if (n < 2 || static_cast<int>(vertices.size()) != 2 * (n + 1) - 4) return {};
  return edges_between(vertices, sites);
}

}  // namespace voroproof::internal::adversary
