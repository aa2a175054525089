// The ids of generators, and how V-edges are named by them.
#pragma once

#include <algorithm>
#include <array>
#include <compare>

namespace voroproof::internal {

// The disks are 0 .. n-1, the container is -1.
using GenId = int;
inline constexpr GenId container_id = -1;

// A V-edge [l, r, s, e]: directed from its start vertex [l, s, r] to its end vertex
// [l, r, e], with generator l on the left and r on the right. {l, r} is the paper's
// crossing disk pair (CDP), {s, e} the traversing disk pair (TDP); the orientation
// makes the name unique even where two edges share both pairs (Configuration I).
struct Quad {
  GenId l, r, s, e;
  auto operator<=>(const Quad&) const = default;
};

// The same edge walked backwards.
constexpr Quad reversed(const Quad& q) { return {q.r, q.l, q.e, q.s}; }

// The name that writers use for the edge: the smaller of its two, which differ in l and r, or else
// in s and e.
constexpr Quad canonical(const Quad& q) {
  return q.r < q.l || (q.r == q.l && q.e < q.s) ? reversed(q) : q;
}

// The edge that a flip leaves in the place of q.
constexpr Quad flipped(const Quad& q) { return {q.s, q.e, q.r, q.l}; }

// Whether q can name an edge at all: l, r and each of s, e are distinct. s = e is
// possible (a cell of two edges).
constexpr bool names_an_edge(const Quad& q) {
  return q.l != q.r && q.s != q.l && q.s != q.r && q.e != q.l && q.e != q.r;
}

// Whether the two edges have the same four generators, in whatever roles.
constexpr bool same_generators(const Quad& a, const Quad& b) {
  if (a.l + a.r + a.s + a.e != b.l + b.r + b.s + b.e) return false;
  std::array<GenId, 4> x{a.l, a.r, a.s, a.e}, y{b.l, b.r, b.s, b.e};
  std::sort(x.begin(), x.end());
  std::sort(y.begin(), y.end());
  return x == y;
}

// A V-vertex: its generators in counterclockwise order of their contact points, written
// with the smallest first.
using Triple = std::array<GenId, 3>;

constexpr Triple canonical(const Triple& v) {
  if (v[1] < v[0] && v[1] < v[2]) return {v[1], v[2], v[0]};
  if (v[2] < v[0] && v[2] < v[1]) return {v[2], v[0], v[1]};
  return v;
}
constexpr Triple start_vertex(const Quad& q) { return canonical(Triple{q.l, q.s, q.r}); }
constexpr Triple end_vertex(const Quad& q) { return canonical(Triple{q.l, q.r, q.e}); }

}  // namespace voroproof::internal
