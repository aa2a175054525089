#include "exact/isometry.h"

#include <algorithm>
#include <array>

namespace voroproof::internal {

namespace {

Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y}; }
Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y}; }
bool is_zero(const Vector& v) { return sgn(v.x) == 0 && sgn(v.y) == 0; }
Rational dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }

}  // namespace

Vector Isometry::turn(const Vector& v) const {
  if (reflects) return {a * v.x + b * v.y, b * v.x - a * v.y};
  return {a * v.x - b * v.y, b * v.x + a * v.y};
}

Vector Isometry::operator()(const Vector& p) const { return turn(p) + shift; }

std::vector<Isometry> isometries(std::span<const Image> points, std::span<const Image> vectors) {
  const Image& base = points[0];
  std::vector<Image> turned;
  for (const Image& v : vectors) turned.push_back(v);
  for (const Image& p : points) turned.push_back({p.from - base.from, p.to - base.to});
  const auto first =
      std::find_if(turned.begin(), turned.end(), [](const Image& i) { return !is_zero(i.from); });
  // One vector that is not zero determines the linear part up to the choice of its kind.
  std::array<Isometry, 2> candidates{Isometry{1, 0, false, {}}, Isometry{1, 0, true, {}}};
  if (first != turned.end()) {
    const Vector &u = first->from, &v = first->to;
    const Rational size = dot(u, u);
    if (dot(v, v) != size) return {};
    candidates[0].a = dot(u, v) / size;
    candidates[0].b = (u.x * v.y - u.y * v.x) / size;
    candidates[1].a = (u.x * v.x - u.y * v.y) / size;
    candidates[1].b = (u.x * v.y + u.y * v.x) / size;
  }
  std::vector<Isometry> out;
  for (Isometry& g : candidates) {
    if (std::all_of(turned.begin(), turned.end(),
                    [&](const Image& i) { return g.turn(i.from) == i.to; })) {
      g.shift = base.to - g.turn(base.from);
      out.push_back(g);
    }
  }
  return out;
}

bool have_fixed_point(std::span<const Isometry> all) {
  // p - g(p) = 0: two linear equations u p.x + v p.y = w of each, solved by elimination.
  using Row = std::array<Rational, 3>;
  std::vector<Row> rows;
  for (const Isometry& g : all) {
    const Vector ex = g.turn({1, 0}), ey = g.turn({0, 1});
    rows.push_back({1 - ex.x, -ey.x, g.shift.x});
    rows.push_back({-ex.y, 1 - ey.y, g.shift.y});
  }
  std::size_t done = 0;
  for (int column = 0; column < 2; ++column) {
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(done), rows.end(),
                                    [&](const Row& r) { return sgn(r[column]) != 0; });
    if (pivot == rows.end()) continue;
    std::swap(rows[done], *pivot);
    for (std::size_t k = done + 1; k < rows.size(); ++k) {
      const Rational factor = rows[k][column] / rows[done][column];
      for (int c = column; c < 3; ++c) rows[k][c] -= factor * rows[done][c];
    }
    ++done;
  }
  return std::all_of(rows.begin() + static_cast<std::ptrdiff_t>(done), rows.end(),
                     [](const Row& r) { return sgn(r[2]) == 0; });
}

}  // namespace voroproof::internal
