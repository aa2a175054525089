#include "engine/cell_rays.h"

#include <optional>
#include <type_traits>
#include <vector>

namespace voroproof::internal {

namespace {

std::optional<bool> is_negative(Sign s) {
  if (s == Sign::unknown) return std::nullopt;
  return s == Sign::negative;
}

}  // namespace

bool CellRays::meets(GenId i, GenId j, GenId k) const {
  if (framed_.is_infinity(k)) return true;
  if (framed_.is_wall(j)) return meets_from_wall(i, j, k);
  if (framed_.is_disk(j)) {
    return predicates_.decide([&](auto at, auto root) -> std::optional<bool> {
      const auto ri = framed_.row_of(at, j, i), rk = framed_.row_of(at, j, k);
      using T = std::decay_t<decltype(ri.x)>;
      // The circle that touches j and k with its centre on the ray has kappa = (d_k.u/l + s_k)/p_k;
      // i conflicts iff p_i kappa < l + s_i. Times l |p_k|:
      const T l2 = ri.x * ri.x + ri.y * ri.y;
      const T l = root(l2);
      const T along = rk.x * ri.x + rk.y * ri.y;
      const T q = ri.p * (along + rk.s * l) - rk.p * (l2 + ri.s * l);
      return is_negative(k == container_id ? -sign(q) : sign(q));
    });
  }
  return predicates_.decide([&](auto at, auto root) -> std::optional<bool> {
    const auto cj = at(j), ci = at(i), ck = at(k);
    using T = std::decay_t<decltype(cj.x)>;
    const T ux = ci.x - cj.x, uy = ci.y - cj.y, si = ci.r - cj.r;
    const T dx = ck.x - cj.x, dy = ck.y - cj.y, sk = ck.r - cj.r;
    const T l = root(T(ux * ux + uy * uy));
    const T along = dx * ux + dy * uy;
    const T pk = dx * dx + dy * dy - sk * sk;
    // y = O + u tau / l with tau = -p_k / (2 (s_k - d_k.u/l)); it is nearer to i iff tau
    // < (l + s_i) / 2, where s_k and s_i are R + r_k and R + r_i.
    return is_negative(sign(T(-(pk * l) - (sk * l - along) * (l + si))));
  });
}

// As far as y is from the wall, so far is it from k; it is nearer to i iff that is more than half
// of the gap between the wall and i.
bool CellRays::meets_from_wall(GenId i, GenId j, GenId k) const {
  return predicates_.decide([&](auto at, auto) -> std::optional<bool> {
    const auto target = at(i), other = at(k), line = at(j);
    using T = std::decay_t<decltype(line.x)>;
    const auto seen = [&](const Site<T>& from, const Site<T>& to) {
      return framed_.template seen_from_wall<T>(j, from, to.x, to.y);
    };
    const T gap = seen(line, target)[1] - target.r;
    if (!framed_.is_wall(k)) {
      const T along = seen(target, other)[0], high = seen(line, other)[1];
      const T square = along * along + high * high - other.r * other.r;
      return is_negative(sign(T(gap * (high + other.r) - square)));
    }
    if (framed_.tangency_of_walls(j, k) == 4) {
      return is_negative(sign(T(gap - seen(line, other)[1])));
    }
    const T high = framed_.template seen_from_wall<T>(k, other, target.x, target.y)[1];
    return is_negative(sign(T(gap - (high + high))));
  });
}

bool CellRays::is_after(GenId i, const std::array<GenId, 3>& vertex) const {
  const auto& [j, s, k] = vertex;
  // The cell of a wall is between the vertices (j, infinity, k) and (j, s, infinity).
  if (framed_.is_infinity(k) || framed_.is_infinity(s)) return framed_.is_infinity(s);
  return predicates_.decide([&](auto at, auto root) -> std::optional<bool> {
    const auto target = at(i);
    using T = std::decay_t<decltype(target.x)>;
    const auto z = framed_.center(at, root, vertex[0], vertex[1], vertex[2]);
    const Sign way = sign(framed_.template seen_from_wall<T>(vertex[0], target, z[0], z[1])[0]);
    if (way == Sign::unknown) return std::nullopt;
    return way != Sign::positive;
  });
}

Diagram diagram_between_walls(const Framed& framed, InstantPredicates& predicates) {
  const auto w = [&](int quarter) { return framed.wall(quarter & 3); };
  const Sign above = predicates.decide_sign([&](auto at, auto) {
    return sign(framed.tangency_between_walls(at, {w(0), w(1), w(2)}, w(3)));
  });
  // The wall before the first of the two between which there is an edge.
  const int k = above == Sign::positive ? 3 : 0;
  std::vector<Quad> quads{{w(k + 1), w(k + 3), w(k + 2), w(k)}};
  for (const int q : {0, 1, 2, 3}) {
    quads.push_back({w(q), container_id, w(q + 3), w(q + 1)});
    quads.push_back({w(q), w(q + 1), container_id, w(((q - k) & 1) == 1 ? q + 2 : q + 3)});
  }
  const int generators = predicates.motion().size();
  std::vector<bool> later(static_cast<std::size_t>(generators), true);
  for (const int q : {0, 1, 2, 3}) later[static_cast<std::size_t>(w(q))] = false;
  return diagram_of(generators, quads, later);
}

}  // namespace voroproof::internal
