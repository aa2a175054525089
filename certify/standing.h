// How two generators stand to each other at a time at which they are said to collide and do not: in
// words, with the amounts.
#pragma once

#include <string>

#include "exact/ball.h"
#include "exact/predicates.h"
#include "exact/tower.h"
#include "filtered/numbers/dd_ball.h"

namespace voroproof::internal {

struct Standing {
  Sign apart;    // sign of their gap; unknown: it is nearly zero
  Sign parting;  // sign of its derivative
  bool at_rest;  // relative to each other, for certain
  double gap;    // its size, about
  double speed;  // speed at which it changes, about
  double least;  // the gap where they are nearest, about, if they approach and pass each other
  bool passes;   // they do
};

inline double about(const Rational& x) { return round_nearest(x); }
inline double about(const Tower& x) { return round_nearest(x); }
inline double about(const DdBall& x) { return x.hi; }

// "do not touch: at t = 1 they are 0.5 apart", "touch at t = 1, and part at a speed of 2": what
// follows the names of the two.
std::string text_of(const Standing& s, double t);

// A size in six digits.
std::string amount(double x);

// `c`: |d|^2 - reach^2, `b`: d.w, `a`: |w|^2, for the offset d and the relative velocity w of the
// two at a time, each with its sign; `reach`: |d| where they touch; `wall`: the first is the
// container.
Standing standing_of(Sign c_sign, Sign b_sign, Sign a_sign, double c, double b, double a,
                     double reach, bool wall);

template <class T>
Standing standing_of(const Contact<T>& k, const T& reach, bool wall) {
  return standing_of(sign(k.c), sign(k.b), sign(k.a), about(k.c), about(k.b), about(k.a),
                     about(reach), wall);
}

}  // namespace voroproof::internal
