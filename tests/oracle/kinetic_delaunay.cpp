#include "tests/oracle/kinetic_delaunay.h"

#include <algorithm>
#include <stdexcept>

namespace voroproof::oracle {
namespace {

using Poly = std::vector<mpq_class>;

void trim(Poly& f) {
  while (!f.empty() && f.back() == 0) f.pop_back();
}

Poly sum(const Poly& f, const Poly& g, int sign) {
  Poly h(std::max(f.size(), g.size()));
  for (std::size_t i = 0; i < f.size(); ++i) h[i] += f[i];
  for (std::size_t i = 0; i < g.size(); ++i) h[i] += sign * g[i];
  trim(h);
  return h;
}

Poly product(const Poly& f, const Poly& g) {
  if (f.empty() || g.empty()) return {};
  Poly h(f.size() + g.size() - 1);
  for (std::size_t i = 0; i < f.size(); ++i)
    for (std::size_t j = 0; j < g.size(); ++j) h[i + j] += f[i] * g[j];
  trim(h);
  return h;
}

mpq_class value(const Poly& f, const mpq_class& t) {
  mpq_class v = 0;
  for (auto c = f.rbegin(); c != f.rend(); ++c) v = v * t + *c;
  return v;
}

Poly remainder(Poly f, const Poly& g) {
  while (f.size() >= g.size()) {
    const mpq_class q = f.back() / g.back();
    const std::size_t shift = f.size() - g.size();
    for (std::size_t i = 0; i < g.size(); ++i) f[i + shift] -= q * g[i];
    f.pop_back();
    trim(f);
  }
  return f;
}

std::vector<Poly> sturm(const Poly& f) {
  Poly derivative;
  for (std::size_t i = 1; i < f.size(); ++i)
    derivative.push_back(static_cast<unsigned long>(i) * f[i]);
  std::vector<Poly> chain{f, derivative};
  while (!chain.back().empty()) {
    Poly next = remainder(chain[chain.size() - 2], chain.back());
    for (mpq_class& c : next) c = -c;
    chain.push_back(std::move(next));
  }
  chain.pop_back();
  if (chain.back().size() > 1) throw std::logic_error("kinetic_delaunay: a double root");
  return chain;
}

int variations(const std::vector<Poly>& chain, const mpq_class& t) {
  int count = 0, last = 0;
  for (const Poly& f : chain) {
    const int s = sgn(value(f, t));
    if (s == 0) continue;
    count += last != 0 && s != last;
    last = s;
  }
  return count;
}

struct Interval {
  mpq_class lo, hi;
};

// The roots in (lo, hi], narrowly.
void isolate(const std::vector<Poly>& chain, const mpq_class& lo, int at_lo, const mpq_class& hi,
             int at_hi, std::vector<Interval>& roots) {
  if (at_lo == at_hi) return;
  const mpq_class tiny = mpq_class(1, mpz_class(1) << 200);
  if (at_lo - at_hi == 1 && hi - lo <= tiny) {
    roots.push_back({lo, hi});
    return;
  }
  if (hi - lo <= tiny) throw std::logic_error("kinetic_delaunay: two roots too near");
  const mpq_class mid = (lo + hi) / 2;
  const int at_mid = variations(chain, mid);
  isolate(chain, lo, at_lo, mid, at_mid, roots);
  isolate(chain, mid, at_mid, hi, at_hi, roots);
}

struct Place {
  mpq_class x, y;
};

// The circle through three places: centre and square of the radius.
struct ThreePointCircle {
  Place centre;
  mpq_class square;
};

ThreePointCircle circle_through(const Place& a, const Place& b, const Place& c) {
  const mpq_class ux = b.x - a.x, uy = b.y - a.y, wx = c.x - a.x, wy = c.y - a.y;
  const mpq_class det = 2 * (ux * wy - uy * wx);
  if (det == 0) throw std::logic_error("kinetic_delaunay: collinear points");
  const mpq_class u2 = ux * ux + uy * uy, w2 = wx * wx + wy * wy;
  const mpq_class x = (wy * u2 - uy * w2) / det, y = (ux * w2 - wx * u2) / det;
  return {{a.x + x, a.y + y}, mpq_class(x * x + y * y)};
}

// Whether the difference is positive, where it is not so small that this depends on the root.
bool clearly_positive(const mpq_class& difference) {
  if (abs(difference) < mpq_class(1, mpz_class(1) << 100))
    throw std::logic_error("kinetic_delaunay: too near to tell");
  return difference > 0;
}

// sqrt(centre^2) + sqrt(square) < radius, by squaring twice.
bool inside(const ThreePointCircle& circle, const mpq_class& radius) {
  const mpq_class d2 = circle.centre.x * circle.centre.x + circle.centre.y * circle.centre.y;
  const mpq_class rest = radius * radius - d2 - circle.square;
  return clearly_positive(rest) && clearly_positive(rest * rest - 4 * d2 * circle.square);
}

}  // namespace

std::vector<mpq_class> incircle_polynomial(const std::array<MovingPoint, 4>& points) {
  // Differences to the last: rows (x, y, x^2 + y^2), each a polynomial in t.
  std::array<Poly, 3> x, y, lift;
  for (int i = 0; i < 3; ++i) {
    const MovingPoint &p = points[i], &q = points[3];
    x[i] = {p.x - q.x, p.vx - q.vx};
    y[i] = {p.y - q.y, p.vy - q.vy};
    trim(x[i]);
    trim(y[i]);
    // Squares of absolute coordinates, less those of the base, are linear in it: translation does
    // not change the determinant.
    lift[i] = sum(product(x[i], x[i]), product(y[i], y[i]), 1);
  }
  Poly determinant;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    determinant =
        sum(determinant, product(lift[i], sum(product(x[j], y[k]), product(y[j], x[k]), -1)), 1);
  }
  return determinant;
}

std::vector<DelaunayFlip> delaunay_flips(const std::vector<MovingPoint>& points,
                                         const mpq_class& container_radius,
                                         const mpq_class& horizon) {
  const int n = static_cast<int>(points.size());
  std::vector<DelaunayFlip> flips;
  const auto examine = [&](const std::array<int, 4>& four) {
    const Poly f =
        incircle_polynomial({points[four[0]], points[four[1]], points[four[2]], points[four[3]]});
    if (f.size() < 2) return;
    const std::vector<Poly> chain = sturm(f);
    std::vector<Interval> roots;
    isolate(chain, 0, variations(chain, 0), horizon, variations(chain, horizon), roots);
    for (const Interval& root : roots) {
      const auto place = [&](int i) -> Place {
        return {points[i].x + root.lo * points[i].vx, points[i].y + root.lo * points[i].vy};
      };
      const ThreePointCircle circle =
          circle_through(place(four[0]), place(four[1]), place(four[2]));
      bool empty = inside(circle, container_radius);
      for (int m = 0; m < n && empty; ++m) {
        if (std::find(four.begin(), four.end(), m) != four.end()) continue;
        const Place p = place(m);
        const mpq_class x = p.x - circle.centre.x, y = p.y - circle.centre.y;
        empty = clearly_positive(x * x + y * y - circle.square);
      }
      if (empty) flips.push_back({root.lo, root.hi, four});
    }
  };
  for (int a = 0; a < n; ++a)
    for (int b = a + 1; b < n; ++b)
      for (int c = b + 1; c < n; ++c)
        for (int d = c + 1; d < n; ++d) examine({a, b, c, d});
  std::sort(flips.begin(), flips.end(),
            [](const DelaunayFlip& p, const DelaunayFlip& q) { return p.lo < q.lo; });
  for (std::size_t k = 1; k < flips.size(); ++k)
    if (flips[k].lo <= flips[k - 1].hi) throw std::logic_error("kinetic_delaunay: two at once");
  return flips;
}

}  // namespace voroproof::oracle
