// V-edges of a world in doubles with error bounds.
//
// The polynomial of an edge [l,r,s,e] is f (edge_ends.h), or C where all radii are one and grow
// alike, so that f = -C^2. While the tangencies of its neighbouring generators are positive its
// in-circle functions change their signs at roots of it only.
#pragma once

#include "filtered/numbers/double_roots.h"
#include "filtered/worlds/rough_rows.h"

namespace voroproof::internal {

// Whether the two are apart at all times of [lo, hi]: their tangency is positive. False says
// nothing.
bool are_apart(const RoughRows& rows, GenId g, GenId h, double lo, double hi);

// Whether both in-circle functions of the edge are positive at all times of [lo, hi]: it is legal
// and has a length. False says nothing.
bool is_legal_edge(const RoughRows& rows, const Quad& q, double lo, double hi);
// The same for the circle of a vertex of three disks in the plane: whether it exists.
bool has_circle(const RoughRows& rows, GenId i, GenId j, GenId k, double lo, double hi);

struct RoughCollapse {
  enum class Kind {
    none,       // nothing of the following happens
    collapses,  // both in-circle functions are positive before, vanish at the only root of the
                // polynomial in [root.lo, root.piece_hi], and are negative beyond; both circles of
                // the edge are one there, and no two of the four touch
    fails,      // a function is negative beyond that root, but the edge is no point there
    unknown,    // doubles do not tell
  };
  Kind kind = Kind::unknown;
  DoubleRoot root{};
};
// The first after an instant in [lo, hi] and up to `end`, at least, of an edge that is legal just
// after it. Where it fails a tangency has vanished before, or the edge has never been there.
RoughCollapse rough_fall(const RoughRows& rows, const Quad& q, double lo, double hi, double end);
// The same, but looking for the first that collapses.
RoughCollapse rough_collapse(const RoughRows& rows, const Quad& q, double lo, double hi,
                             double end);
// The first root of the tangency of two, in `root`, after an instant in [lo, hi] just after which
// it is positive, and up to `end`, at least: the pair fails there.
RoughCollapse rough_meeting(const RoughRows& rows, GenId g, GenId h, double lo, double hi,
                            double end);
// The first time at which the circle, which exists just after an instant in [lo, hi], ceases to,
// up to `end`, at least: it fails at the root of f or C of the three disks and infinity.
RoughCollapse rough_end_of_circle(const RoughRows& rows, GenId i, GenId j, GenId k, double lo,
                                  double hi, double end);

// The root of the edge's polynomial in [lo, hi], which contains one only, in which the polynomial
// changes its sign, as narrowly as double-doubles tell.
DdBall narrowed_root(const RoughRows& rows, const Quad& q, double lo, double hi);

}  // namespace voroproof::internal
