// Flips that make a diagram legal.
#pragma once

#include <set>
#include <utility>

#include "exact/topology/diagram.h"

namespace voroproof::internal {

// Flips edges that are illegal, the smallest quadruplet first, until none is; returns how many.
// `is_illegal` tells of a quadruplet, and is asked anew where a flip changes it. Edges whose two
// ends have the same generators are not asked for.
template <class IsIllegal>
long legalize(Diagram& diagram, IsIllegal&& is_illegal) {
  using HalfEdge = Diagram::HalfEdge;
  std::set<std::pair<Quad, HalfEdge>> illegal;
  const auto examine = [&](HalfEdge h) {
    const Quad q = diagram.quad(h);
    if (q.s != q.e && is_illegal(q)) illegal.insert({canonical(q), h & ~1});
  };
  for (HalfEdge h = 0; h < 2 * diagram.edges(); h += 2) examine(h);
  long flips = 0;
  while (!illegal.empty()) {
    const HalfEdge h = illegal.begin()->second;
    illegal.erase(illegal.begin());
    const HalfEdge around[4] = {diagram.next(h), diagram.previous(h), diagram.next(h ^ 1),
                                diagram.previous(h ^ 1)};
    for (const HalfEdge a : around) illegal.erase({canonical(diagram.quad(a)), a & ~1});
    diagram.flip(h);
    ++flips;
    examine(h);
    for (const HalfEdge a : around) examine(a);
  }
  return flips;
}

}  // namespace voroproof::internal
