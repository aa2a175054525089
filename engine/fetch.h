// Memory asked for in time. Nearly everything that an event needs is out of the fast caches in
// large scenes: it is asked for level by level, each reading what the one before it has asked for.
// Nothing here changes anything. (All inlined: compilers leave out calls of functions that do
// nothing else.)
#pragma once

#include "engine/queue.h"
#include "exact/enclosure.h"
#include "exact/topology/diagram.h"
#include "filtered/motion/motion.h"

namespace voroproof::internal {

class Fetch {
 public:
  using HalfEdge = Diagram::HalfEdge;
  Fetch(const Diagram& diagram, const Motion& motion) : diagram_(diagram), motion_(motion) {}

  // The generators of the flip or contact after the present event, and the edges around it; the
  // edges of those of which one comes after that. Items before `items` are two for each edge.
  [[gnu::always_inline]] void ahead(const EventQueue& queue, const Enclosure* isolating,
                                    int items) const {
    for (const std::size_t place : {1, 2, 3, 4}) {
      const int item = queue.near(place);
      if (item < 0 || item >= items) continue;
      diagram_.prefetch(item & ~1);
      __builtin_prefetch(&isolating[item]);
    }
    const int item = queue.near(0);
    if (item < 0 || item >= items) return;
    for (const HalfEdge h : {item & ~1, item | 1}) {
      const HalfEdge side = diagram_.previous(h);
      diagram_.prefetch(side);
      queue.prefetch(side & ~1);
      for (const GenId g : {diagram_.org(h), diagram_.org(side)}) {
        __builtin_prefetch(&motion_.doubles(g));
        __builtin_prefetch(&motion_.seconds(g));
      }
      const HalfEdge other = diagram_.previous(side);
      diagram_.prefetch(other);
      queue.prefetch(other & ~1);
    }
  }

  // The triangles beyond the edges around the edge h, which is about to be dealt with.
  [[gnu::always_inline]] void around_edge(HalfEdge h) const {
    for (const HalfEdge half : {h, h ^ 1}) {
      const HalfEdge side = diagram_.previous(half), other = diagram_.previous(side);
      diagram_.prefetch(diagram_.previous(side ^ 1));
      diagram_.prefetch(diagram_.previous(other ^ 1));
    }
  }

  // The generator beyond an edge that searches are about to be made for.
  [[gnu::always_inline]] void beyond(HalfEdge h) const {
    __builtin_prefetch(&motion_.doubles(diagram_.org(diagram_.previous(h ^ 1))));
  }

  // Fetches the memory for searches of all edges around the cell of `first`'s origin.
  [[gnu::always_inline]] void around_cell(HalfEdge first) const {
    const Diagram::Ring ring(diagram_, first);
    for (const HalfEdge h : ring) diagram_.prefetch(diagram_.previous(diagram_.next(h) ^ 1));
    for (const HalfEdge h : ring) beyond(diagram_.next(h));
  }

 private:
  const Diagram& diagram_;
  const Motion& motion_;
};

}  // namespace voroproof::internal
