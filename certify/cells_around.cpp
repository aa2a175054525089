#include "certify/cells_around.h"

namespace voroproof::internal {

// Collects the edges that have one of the two disks among their generators: spokes of the cells,
// and the rims around them. i may be the container, for one disk.
void CellsAround::collect(GenId i, GenId j) {
  spokes_.clear();
  all_.clear();
  if (!front_.begun) return;
  if (s_.motion.size() == 1) {
    spokes_.push_back(0);
    return;
  }
  const auto add = [this](std::vector<int>& to, int edge) {
    if (collected_[edge]) return;
    collected_[edge] = true;
    to.push_back(edge);
  };
  const auto each = [this, i, j](auto&& visit) {
    for (const GenId g : {i, j}) {
      if (g == container_id) continue;
      for (const Diagram::HalfEdge h : s_.diagram.ring(g)) visit(h);
    }
  };
  // Prefetches what will be needed of them soon: the lives, the pairs, and the generators on the
  // other sides.
  each([&](Diagram::HalfEdge h) {
    add(spokes_, h / 2);
    const Diagram::HalfEdge rim = s_.diagram.next(h);
    s_.diagram.prefetch(s_.diagram.previous(rim ^ 1));
    edges_.prefetch(rim / 2);
    pairs_.prefetch(h / 2);
    s_.motion.prefetch(s_.diagram.dest(h));
    s_.replay.prefetch_turns(s_.diagram.dest(h));
  });
  all_ = spokes_;
  each([&](Diagram::HalfEdge h) {
    const Diagram::HalfEdge rim = s_.diagram.next(h);
    add(all_, rim / 2);
    edges_.prefetch(h / 2);
    s_.motion.prefetch(s_.diagram.apex(rim ^ 1));
  });
  for (const int edge : all_) collected_[edge] = false;
}

void CellsAround::end(GenId i, GenId j, const Moment& m) {
  if (!s_.options.judges_flips()) {
    turning_.clear();
    for (const GenId g : {i, j}) {
      if (g == container_id || !front_.begun) continue;
      turning_.push_back(g);
      pairs_.end_around(g, m);
    }
    return;
  }
  collect(i, j);
  pairs_.end(spokes_, m, PairEnd::turn);
  edges_.end(all_, m);
}

void CellsAround::begin(const Moment& m) {
  for (const GenId g : turning_) pairs_.begin_around(g, m);
  for (const int e : spokes_) pairs_.begin(e, m.lo);
  edges_.postpone(all_, m);
}

}  // namespace voroproof::internal
