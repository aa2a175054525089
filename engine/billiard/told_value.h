// How an engine of billiards tells its numbers: as binary64.
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/billiard/meeting_time.h"
#include "filtered/billiards/number_kinds.h"

namespace voroproof::internal {

// The nearest binary64 of a value among values of that size. A value within 2^-90 of that size from
// zero, or from the middle of two binary64, is taken to be there: no ball would tell that it is.
// Throws MoreBits.
inline double told_value(const Rational& q, double) { return round_nearest(q); }
inline double told_value(const Ball& b, double size) {
  double x = 0;
  if (b.round_to_double(x)) return x;
  double hi = 0, lo = 0, error = 0;
  b.to_double_double(hi, lo, error);
  if (!(error <= size * 0x1p-90)) throw MoreBits("how a value rounds is not told");
  return std::fabs(hi) <= error ? 0 : b.midpoint_as_double();
}

template <class T>
CompactVec3 told_value(const Vector3<T>& v) {
  const Vector3<DoubleBall> near = enclosed(v);
  const double size =
      std::max({std::fabs(near[0].mid), std::fabs(near[1].mid), std::fabs(near[2].mid)});
  return {told_value(v[0], size), told_value(v[1], size), told_value(v[2], size)};
}

}  // namespace voroproof::internal
