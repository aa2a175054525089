// The rays on which a new disk finds a place in a diagram, and the diagram without disks.
#pragma once

#include <array>

#include "exact/topology/diagram.h"
#include "filtered/search/framed.h"
#include "filtered/search/instant_predicates.h"

namespace voroproof::internal {

// The ray of a generator j and a disk i leads through the centre of i: from the centre of the disk
// j, from the boundary of the container inwards, or from far out along the normal of a wall.
class CellRays {
 public:
  // They must outlive this object.
  CellRays(const Framed& framed, InstantPredicates& predicates)
      : framed_(framed), predicates_(predicates) {}

  // Whether the point y where the ray of j and i meets the edge j|k is nearer to i than to j. If it
  // is not, the gap between i and k is smaller than that between i and j.
  bool meets(GenId i, GenId j, GenId k) const;
  // Whether the ray of a wall is not before a vertex of its cell, on the way along it around that.
  // `vertex` begins with the wall.
  bool is_after(GenId i, const std::array<GenId, 3>& vertex) const;

  // The direction from the disk k to y, where y is on the edge j|k; for k = j that of the ray.
  template <class T, class Sites, class Root>
  Direction<T> to_end(Sites& at, Root& root, GenId j, GenId i, GenId k) const {
    const Site<T> from = at(k), target = at(i);
    if (framed_.is_disk(j)) return {target.x - from.x, target.y - from.y};
    return framed_.is_wall(j) ? from_wall<T>(j, at(j), target, from)
                              : from_container<T>(root, at(j), target, from);
  }

 private:
  // y = O + u tau / l with u = c_i - O, l = |u| and tau as in meets().
  template <class T, class Root>
  static Direction<T> from_container(Root& root, const Site<T>& container, const Site<T>& ci,
                                     const Site<T>& ck) {
    const T ux = ci.x - container.x, uy = ci.y - container.y;
    const T dx = ck.x - container.x, dy = ck.y - container.y, sk = ck.r - container.r;
    const T pk = dx * dx + dy * dy - sk * sk;
    const T l = root(T(ux * ux + uy * uy));
    const T below = sk * l - (dx * ux + dy * uy);  // positive
    const T scale = -pk / (below + below);         // tau / l
    return {ux * scale - dx, uy * scale - dy};
  }
  // With a the way along the wall from k to i, and 2 b the tangency of k and the wall, y is a along
  // the wall from the centre of k and (a^2 - b^2) / (2 b) away from it.
  template <class T>
  Direction<T> from_wall(GenId j, const Site<T>& line, const Site<T>& ci, const Site<T>& ck) const {
    const T a = framed_.seen_from_wall<T>(j, ck, ci.x, ci.y)[0];
    const T b = framed_.seen_from_wall<T>(j, line, ck.x, ck.y)[1] + ck.r;
    const T both = a * b;
    return framed_.reflected<T>(j, both + both, a * a - b * b);
  }
  bool meets_from_wall(GenId i, GenId j, GenId k) const;

  const Framed& framed_;
  InstantPredicates& predicates_;
};

// The diagram of the four walls of a box and of none of its disks.
Diagram diagram_between_walls(const Framed& framed, InstantPredicates& predicates);

}  // namespace voroproof::internal
