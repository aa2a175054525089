// The length of an arc, and the area between it and its chord.
#pragma once

#include "library/conic_arc.h"

namespace voroproof::internal {

struct ArcMeasure {
  BallPoint start, end;
  // Between the chord and the arc: positive where the way from start to end turns left, negative
  // where it turns right. And its first moments about the middle of the chord.
  DoubleBall area;
  BallPoint moment;
  DoubleBall length;
};

// Calls use(ArcMeasure) for pieces of the arc in their order. Their errors are some roundings,
// those of the length about 1e-8 of it. Nothing is known (infinite radii) where the arc is not
// known to be proper.
template <class Use>
void measure_arc(const ConicArc& arc, const Use& use);

// As above for an arc that needs no halving, else false.
bool measure_piece(const ConicArc& arc, bool at_any_rate, ArcMeasure& measure);

template <class Use>
void measure_pieces(const ConicArc& arc, int halvings, const Use& use) {
  ArcMeasure measure;
  if (measure_piece(arc, halvings == 0, measure)) {
    use(measure);
    return;
  }
  for (const ConicArc& half : arc.halves()) measure_pieces(half, halvings - 1, use);
}

template <class Use>
void measure_arc(const ConicArc& arc, const Use& use) {
  constexpr int most_halvings = 16;
  measure_pieces(arc, most_halvings, use);
}

}  // namespace voroproof::internal
