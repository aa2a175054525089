// The first filter: a double with a bound of its distance to the true value.
#pragma once

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>

#include "exact/rational.h"
#include "exact/rounding.h"

namespace voroproof::internal {

// |value - mid| <= rad. Error analysis, u = 2^-53 (rounding to nearest):
//   a o b       is computed with |fl(a o b) - a o b| <= u |fl(a o b)| + 2^-1074,
//   the radius  is a sum of at most five nonnegative terms, each computed with a
//               relative error of at most 3u, so that the factor kUp = 1 + 2^-49
//               (16 u) turns it into an upper bound.
// An overflow gives inf or NaN, whose sign is unknown.
struct DoubleBall {
  double mid = 0;
  double rad = 0;

  DoubleBall() = default;
  DoubleBall(double m, double r = 0) : mid(m), rad(r) {}
  // The interval [lo, hi] as a ball.
  static DoubleBall hull(double lo, double hi);
};

namespace double_ball_detail {
inline constexpr double u = unit_roundoff;
inline constexpr double kUp = 1 + 0x1p-49;
inline constexpr double kTiny = DBL_MIN;  // far above any underflow error of one operation
}  // namespace double_ball_detail

inline DoubleBall DoubleBall::hull(double lo, double hi) {
  const double m = 0.5 * lo + 0.5 * hi;
  const double r = std::max(hi - m, m - lo);
  return {m, r * double_ball_detail::kUp + double_ball_detail::kTiny};
}

inline DoubleBall operator+(const DoubleBall& a, const DoubleBall& b) {
  using namespace double_ball_detail;
  const double m = a.mid + b.mid;
  return {m, (a.rad + b.rad + std::fabs(m) * u) * kUp};
}
inline DoubleBall operator-(const DoubleBall& a, const DoubleBall& b) {
  using namespace double_ball_detail;
  const double m = a.mid - b.mid;
  return {m, (a.rad + b.rad + std::fabs(m) * u) * kUp};
}
inline DoubleBall operator-(const DoubleBall& a) { return {-a.mid, a.rad}; }
inline DoubleBall operator*(const DoubleBall& a, const DoubleBall& b) {
  using namespace double_ball_detail;
  const double m = a.mid * b.mid;
  return {m, (std::fabs(a.mid) * b.rad + a.rad * (std::fabs(b.mid) + b.rad) + std::fabs(m) * u +
              kTiny) *
                 kUp};
}
// b must not contain zero; otherwise the radius is infinite.
inline DoubleBall operator/(const DoubleBall& a, const DoubleBall& b) {
  using namespace double_ball_detail;
  const double low = (std::fabs(b.mid) - b.rad) * (1 - 0x1p-50);
  if (!(low > 0)) return {0, std::numeric_limits<double>::infinity()};
  const double m = a.mid / b.mid;
  // |a/b - m0| <= (rad_a + |m0| rad_b) / low for the exact quotient m0 of midpoints. The
  // product |m0| rad_b may underflow, and so may m: kTiny before the division for that.
  return {m,
          ((a.rad + std::fabs(m) * (1 + 4 * u) * b.rad + kTiny) / low + std::fabs(m) * u + kTiny) *
              kUp};
}
// The square root of the nonnegative part of the ball.
inline DoubleBall sqrt(const DoubleBall& a) {
  using namespace double_ball_detail;
  if (!(a.mid > a.rad)) {
    const double top = std::sqrt((std::fmax(a.mid, 0) + a.rad) * kUp) * kUp;
    return {0.5 * top, 0.5 * top * kUp + kTiny};
  }
  const double m = std::sqrt(a.mid);
  return {m, (a.rad / m + m * u + kTiny) * kUp};
}

inline Sign sign(const DoubleBall& a) {
  if (a.mid > a.rad) return Sign::positive;
  if (a.mid < -a.rad) return Sign::negative;
  if (a.mid == 0 && a.rad == 0) return Sign::zero;
  return Sign::unknown;
}

}  // namespace voroproof::internal
