// First: it says that the templates below may be used with lanes on any processor.
#include "filtered/lanes.h"

#include "filtered/rough_judge.h"

#include "filtered/rough_circles.h"

namespace voroproof {

Verdict judge_roughly(const Motion& motion, const Quad& q, double lo, double hi, Sign f) {
  const RoughCircles circles(motion, q, lo, hi);
  if (!circles.usable()) return Verdict::unknown;
  const auto [start, end] = circles.exist();
  for (const Sign exists : {start, end}) {
    if (exists == Sign::negative) return Verdict::stays;
    if (exists != Sign::positive) return Verdict::unknown;
  }
  const auto [e, s] = circles.in_circle(f);
  if (e == Sign::positive || s == Sign::positive) return Verdict::stays;
  return e == Sign::negative && s == Sign::negative ? Verdict::collapses : Verdict::unknown;
}

}  // namespace voroproof
