// The signs that decide whether a V-edge is legal, at sites of any number type.
#pragma once

#include "exact/generators.h"
#include "exact/predicates.h"

namespace voroproof {

// Of an edge [l,r,s,e]: whether its circles (l,s,r) and (r,e,l) exist, and where e lies to the
// first and s to the second (as incircle() says).
struct EdgeSigns {
  Sign start_exists, end_exists;
  Sign end_in_start, start_in_end;
};

// The tangent triple of three generators given counterclockwise, a disk taken as its base.
template <class T>
TangentTriple<T> tangent_triple(GenId a, const Site<T>& sa, GenId b, const Site<T>& sb, GenId c,
                                const Site<T>& sc) {
  if (a == container_id) return {sb, sc, sa, true};
  return {sa, sb, sc, b == container_id || c == container_id};
}

// `f`: the sign of the cotangency of the four sites.
template <class T>
EdgeSigns edge_signs(const Quad& q, const Site<T>& l, const Site<T>& r, const Site<T>& s,
                     const Site<T>& e, Sign f) {
  const TangentTriple<T> start = tangent_triple(q.l, l, q.s, s, q.r, r);
  const TangentTriple<T> end = tangent_triple(q.r, r, q.e, e, q.l, l);
  return {circle_exists(start), circle_exists(end), incircle(start, e, q.e == container_id, f),
          incircle(end, s, q.s == container_id, f)};
}

}  // namespace voroproof
