// The signs that decide whether a V-edge is legal, at sites of any number type.
#pragma once

#include "exact/generators.h"
#include "exact/predicates.h"
#include "filtered/search/edge_predicates.h"

namespace voroproof::internal {

// Whether the circles (l,s,r) and (r,e,l) of an edge [l,r,s,e] exist, and where e lies to the
// first and s to the second (as incircle() says).
struct EdgeSigns {
  Sign start_exists, end_exists;
  Sign end_in_start, start_in_end;
};

// `f`: the sign of the cotangency of the four sites.
template <class T>
EdgeSigns edge_signs(const Quad& q, const Site<T>& l, const Site<T>& r, const Site<T>& s,
                     const Site<T>& e, Sign f) {
  const auto [start, end] = EdgeTriples<T>::of(q, {l, r, s, e});
  return {circle_exists(start), circle_exists(end), incircle(start, e, q.e == container_id, f),
          incircle(end, s, q.s == container_id, f)};
}

}  // namespace voroproof::internal
