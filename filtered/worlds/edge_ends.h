// The circles at both ends of a V-edge of a world, in any numbers.
//
// Seen from a disk l, the edge [l,r,s,e] leads from the circle that touches l, s, r to the one that
// touches l, r, e. With A, B, C the determinants of the rows x s p, y s p and x y p of s, r, e, up
// to signs, the cotangency is 4 f, f = A^2 + B^2 - C^2, and whether e is outside of the first
// circle, and s outside of the second, is told by G + sqrt(Gamma) C, with G and Gamma of either
// circle (exact/predicates.h).
#pragma once

#include "exact/predicates.h"

namespace voroproof::internal {

// u + sqrt(gamma) v.
template <class T>
struct RootExpression {
  T u, gamma, v;
};

template <class T>
struct EdgeEnds {
  TangentTriple<T> start, end;
  T a, b, c;

  EdgeEnds(const Site<T>& l, const GeneratorRow<T>& s, const GeneratorRow<T>& r,
           const GeneratorRow<T>& e)
      : start(l, s, r, false),
        end(l, r, e, false),
        a(e.x * start.sp - e.s * start.xp + e.p * start.xs),
        b(e.y * start.sp - e.s * start.yp + e.p * start.ys),
        c(e.x * start.yp - e.y * start.xp + e.p * start.xy) {}

  // Positive where e is outside of the circle at the start.
  RootExpression<T> conflict_at_start() const { return conflict_with(start); }
  // Positive where s is outside of the circle at the end.
  RootExpression<T> conflict_at_end() const { return conflict_with(end); }
  // Positive where the two circles, both of which touch all four, are one: seen from l they are in
  // one direction then.
  RootExpression<T> same_circle() const {
    return {-(start.sp * (end.xp * start.yp - end.yp * start.xp)), gamma(start),
            end.xp * start.xp + end.yp * start.yp};
  }

 private:
  RootExpression<T> conflict_with(const TangentTriple<T>& circle) const {
    return {circle.xp * a + circle.yp * b, gamma(circle), c};
  }
};

}  // namespace voroproof::internal
