// Cells of points, that is of disks of radius 0. While a point touches another generator its cell
// has no area, and there is no diagram. For a single instant that does not matter: its edges have
// no length then (docs/certificate.md, Lemma 6.6). It does for longer, and where a point is between
// two.
#pragma once

#include <vector>

#include "filtered/motion/motion.h"
#include "filtered/search/contact.h"

namespace voroproof::internal {

class PointCells {
 public:
  // `motion` and `contacts` must outlive this object.
  PointCells(const Motion& motion, const ContactSearch& contacts);

  // Whether some disk is a point, and whether this one is; the container is none.
  bool any() const { return any_; }
  bool is_point(GenId g) const;

  // To be called for a point whose motion, or that of a neighbour, has changed at `now`, with its
  // neighbours. Throws Undecided where the point may touch two of them at `now`, or may go on
  // touching one. Tried in doubles, double-doubles and balls: what these do not exclude may be.
  void require_area(GenId point, const std::vector<GenId>& neighbours, const Moment& now) const;

 private:
  bool certainly_leaves(GenId point, GenId other, const Moment& now) const;

  const Motion& motion_;
  const ContactSearch& contacts_;
  bool any_ = false;
};

}  // namespace voroproof::internal
