// A V-edge of a world in doubles with error bounds: the filter in front of MovingEdge.
#pragma once

#include "engine/world/moving_rows.h"
#include "filtered/numbers/double_roots.h"

namespace voroproof::internal {

struct RoughCollapse {
  enum class Kind {
    none,     // the edge does not collapse
    found,    // it first collapses at the only root of its polynomial in [root.lo, root.piece_hi]
    unknown,  // doubles do not tell
  };
  Kind kind = Kind::unknown;
  DoubleRoot root{};
};

// Whether the two are apart at all times of [lo, hi]: their tangency is positive. False says
// nothing.
bool are_apart(const RoughRows& rows, GenId g, GenId h, double lo, double hi);
// Whether they are so from `lo` up to `end`. False says nothing.
bool stay_apart(const RoughRows& rows, GenId g, GenId h, double lo, double end);

// Whether the edge is a legal one, which has a length, at all times of [lo, hi]. False says
// nothing.
bool is_legal_edge(const RoughRows& rows, const Quad& q, double lo, double hi);
// The first collapse, as MovingEdge::collapses_at() tells it at the roots of
// MovingEdge::polynomial(), after an instant in [lo, hi] and up to `end`, at least.
RoughCollapse rough_collapse(const MovingRows& rows, const Quad& q, double lo, double hi,
                             double end);
// The root of the edge's polynomial in [lo, hi], which contains one only, in which the polynomial
// changes its sign, as narrowly as double-doubles tell.
DdBall narrowed_root(const MovingRows& rows, const Quad& q, double lo, double hi);

}  // namespace voroproof::internal
