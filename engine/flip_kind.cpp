#include "engine/flip_kind.h"

namespace voroproof::internal {

Degrees::Degrees(const Diagram& diagram, int disks) : degree_(disks + 1, 0) {
  for (Diagram::HalfEdge h = 0; h < 2 * diagram.edges(); ++h) ++degree_[diagram.org(h) + 1];
}

FlipKind Degrees::kind_of_flip(const Diagram& diagram, const Quad& q) const {
  const auto degree = [&](GenId g) { return degree_[g + 1]; };
  // Whether all neighbours of g are generators of the quadruplet.
  const auto within = [&](GenId g) {
    for (const Diagram::HalfEdge h : diagram.ring(g)) {
      const GenId n = diagram.dest(h);
      if (n != q.l && n != q.r && n != q.s && n != q.e) return false;
    }
    return true;
  };
  const bool l3 = degree(q.l) == 3, r3 = degree(q.r) == 3;
  if (l3 && r3) return FlipKind::threethree_to_twotwo;
  if (l3 || r3) {
    for (const GenId g : {q.s, q.e}) {
      if (degree(g) == 3 && within(g)) return FlipKind::threethree_to_twofour;
    }
    return FlipKind::three_to_two;
  }
  const bool s2 = degree(q.s) == 2, e2 = degree(q.e) == 2;
  if (s2 && e2) return FlipKind::twotwo_to_threethree;
  if (s2 || e2) {
    for (const GenId g : {q.l, q.r}) {
      if (degree(g) == 4 && within(g)) return FlipKind::twofour_to_threethree;
    }
    return FlipKind::two_to_three;
  }
  return FlipKind::ordinary;
}

}  // namespace voroproof::internal
