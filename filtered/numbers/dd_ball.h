// The second filter: an unevaluated sum of two doubles (about 106 bits) with a
// bound of its distance to the true value.
#pragma once

#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>

#include "exact/rational.h"
#include "filtered/numbers/lanes.h"
#include "filtered/numbers/next_double.h"

namespace voroproof::internal {

// |value - (hi + lo)| <= rad, |lo| <= u |hi| up to a small factor, u = 2^-53.
// The double-double operations are those of Joldes, Muller & Popescu, "Tight and
// rigorous error bounds for basic building blocks of double-word arithmetic" (ACM
// Trans. Math. Softw. 44, 2017): AccurateDWPlusDW has a relative error of at most
// 3u^2 + 13u^3, DWTimesDW (Algorithm 11) at most 7u^2 where u^2 = 2^-106. Both are
// below kUnit = 2^-102 with room to spare, relative to the computed result.
struct DdBall {
  double hi = 0;
  double lo = 0;
  double rad = 0;

  DdBall() = default;
  DdBall(double h, double l = 0, double r = 0) : hi(h), lo(l), rad(r) {}
};

namespace dd_detail {
inline constexpr double kUnit = 0x1p-102;
inline constexpr double kUp = 1 + 0x1p-49;    // as in double_ball.h
inline constexpr double kTiny = 4 * DBL_MIN;  // underflow of the error terms

inline void two_sum(double a, double b, double& s, double& e) {
  s = a + b;
  const double bb = s - a;
  e = (a - (s - bb)) + (b - bb);
}
inline void fast_two_sum(double a, double b, double& s, double& e) {
  s = a + b;
  e = b - (s - a);
}
inline void two_prod(double a, double b, double& p, double& e) {
  p = a * b;
  e = product_error(a, b, p);
}
}  // namespace dd_detail

inline DdBall operator-(const DdBall& a) { return {-a.hi, -a.lo, a.rad}; }
inline DdBall operator+(const DdBall& a, const DdBall& b) {
  using namespace dd_detail;
  double sh, sl, th, tl, vh, vl, zh, zl;
  two_sum(a.hi, b.hi, sh, sl);
  two_sum(a.lo, b.lo, th, tl);
  fast_two_sum(sh, sl + th, vh, vl);
  fast_two_sum(vh, tl + vl, zh, zl);
  return {zh, zl, (a.rad + b.rad + std::fabs(zh) * kUnit) * kUp};
}
inline DdBall operator-(const DdBall& a, const DdBall& b) { return a + (-b); }
inline DdBall operator*(const DdBall& a, const DdBall& b) {
  using namespace dd_detail;
  double ch, cl1, zh, zl;
  two_prod(a.hi, b.hi, ch, cl1);
  const double cl2 = a.hi * b.lo + a.lo * b.hi;
  fast_two_sum(ch, cl1 + cl2, zh, zl);
  const double am = std::fabs(a.hi) * (1 + 0x1p-50), bm = std::fabs(b.hi) * (1 + 0x1p-50);
  return {zh, zl, (am * b.rad + a.rad * (bm + b.rad) + std::fabs(zh) * kUnit + kTiny) * kUp};
}
// b must not contain zero; otherwise the radius is infinite.
inline DdBall operator/(const DdBall& a, const DdBall& b) {
  using namespace dd_detail;
  const double low = std::fabs(b.hi) * (1 - 0x1p-50) - b.rad;
  if (!(low > 0)) return {0, 0, std::numeric_limits<double>::infinity()};
  // Two quotient digits, then the error is read off the residual in balls:
  // a/b - q = (a - q b) / b.
  const double q1 = a.hi / b.hi;
  const DdBall r1 = a - b * DdBall(q1);
  const double q2 = r1.hi / b.hi;
  double qh, ql;
  fast_two_sum(q1, q2, qh, ql);
  const DdBall r2 = a - b * DdBall(qh, ql);
  const double rest = (std::fabs(r2.hi) * (1 + 0x1p-50) + r2.rad) * kUp;
  return {qh, ql, (rest / (low * (1 - 0x1p-50)) + kTiny) * kUp};
}
// The square root of the nonnegative part of the ball.
inline DdBall sqrt(const DdBall& a) {
  using namespace dd_detail;
  if (!(a.hi * (1 - 0x1p-50) > a.rad)) {
    const double top = std::sqrt((std::fmax(a.hi, 0) * (1 + 0x1p-50) + a.rad) * kUp) * kUp;
    return {0.5 * top, 0, 0.5 * top * kUp + kTiny};
  }
  const double s = std::sqrt(a.hi);
  const DdBall r1 = a - DdBall(s) * DdBall(s);
  const double correction = r1.hi / (2 * s);
  double sh, sl;
  fast_two_sum(s, correction, sh, sl);
  const DdBall q(sh, sl);
  const DdBall r2 = a - q * q;
  // |sqrt(v) - q| = |v - q^2| / (sqrt(v) + q) <= |v - q^2| / q.
  const double rest = (std::fabs(r2.hi) * (1 + 0x1p-50) + r2.rad) * kUp;
  return {sh, sl, (rest / (sh * (1 - 0x1p-50)) + kTiny) * kUp};
}

inline Sign sign(const DdBall& a) {
  const double slack = a.rad + std::fabs(a.lo);
  if (a.hi * (1 - 0x1p-50) > slack) return Sign::positive;
  if (a.hi * (1 - 0x1p-50) < -slack) return Sign::negative;
  if (a.hi == 0 && a.lo == 0 && a.rad == 0) return Sign::zero;
  return Sign::unknown;
}

// Whether all of the ball rounds to hi: it stays within half the gap between hi and its neighbour
// towards zero, the nearer of the two.
inline bool rounds_to_leading(const DdBall& a) {
  const double size = std::fabs(a.hi);
  if (!(size >= DBL_MIN * 0x1p60 && size <= DBL_MAX)) return false;
  const double below = std::bit_cast<double>(std::bit_cast<std::uint64_t>(size) - 1);
  return std::fabs(a.lo) + a.rad < 0.5 * (size - below) * (1 - 0x1p-50);
}

// Binary64 numbers around the ball: neighbours of hi, or as near as the radius lets. The sums of lo
// and the radius err by 2^-53 of themselves.
inline void enclose(const DdBall& a, double& lo, double& hi) {
  const double below = (a.lo - a.rad) * (1 + 0x1p-50), above = (a.lo + a.rad) * (1 + 0x1p-50);
  const double left = next_below(a.hi), right = next_above(a.hi);
  lo = a.lo - a.rad >= 0 ? a.hi : below > left - a.hi ? left : next_below(a.hi + below);
  hi = a.lo + a.rad <= 0 ? a.hi : above < right - a.hi ? right : next_above(a.hi + above);
}

}  // namespace voroproof::internal
