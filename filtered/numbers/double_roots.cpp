#include "filtered/numbers/double_roots.h"

#include <algorithm>
#include <cmath>

#include "filtered/numbers/de_casteljau.h"
#include "filtered/numbers/lanes.h"
#include "filtered/numbers/sign_variations.h"

namespace voroproof::internal::double_roots_detail {

namespace {

template <int degree>
void halve(const double* c, double* left, double* right) {
  double w[degree + 1];
  for (int k = 0; k <= degree; ++k) w[k] = c[k];
  left[0] = w[0];
  right[degree] = w[degree];
  each_level<degree>(
      w, [](double a, double b) { return 0.5 * (a + b); },
      [&](auto rest) {
        left[degree - rest] = w[0];
        right[rest] = w[rest];
      });
}

// Value and the first two derivatives with respect to the parameter in [0, 1].
template <int degree>
double value(const double* c, double x, double& slope, double& curve) {
  double w[degree + 1];
  for (int k = 0; k <= degree; ++k) w[k] = c[k];
  const double y = 1 - x;
  each_level<degree>(
      w, [&](double a, double b) { return y * a + x * b; },
      [&](auto rest) {
        if constexpr (rest == 2) curve = degree * (degree - 1) * ((w[2] - w[1]) - (w[1] - w[0]));
        if constexpr (rest == 1) slope = degree * (w[1] - w[0]);
      });
  return w[0];
}

double value(int degree, const double* c, double x, double& slope, double& curve) {
  return degree == 8 ? value<8>(c, x, slope, curve) : value<4>(c, x, slope, curve);
}

// Values at four parameters.
template <int degree>
Lanes values(const double* c, const Lanes& x) {
  Lanes w[degree + 1];
  for (int k = 0; k <= degree; ++k) w[k] = Lanes{c[k], c[k], c[k], c[k]};
  const Lanes y = 1 - x;
  each_level<degree>(
      w, [&](const Lanes& a, const Lanes& b) { return y * a + x * b; }, [](auto) {});
  return w[0];
}

Lanes values(int degree, const double* c, const Lanes& x) {
  return degree == 8 ? values<8>(c, x) : values<4>(c, x);
}

template <int degree>
int count_roots(const double* c, const Lanes& low, const Lanes& high, double last) {
  unsigned positive = exceeding(load(c), low) | static_cast<unsigned>(c[degree] > last) << degree;
  unsigned negative = exceeding(-load(c), low) | static_cast<unsigned>(-c[degree] > last) << degree;
  if constexpr (degree == 8) {
    positive |= exceeding(load(c + 4), high) << 4;
    negative |= exceeding(-load(c + 4), high) << 4;
  }
  return roots_by_signs(positive, negative, degree);
}

}  // namespace

void halve(int degree, const double* c, double* left, double* right) {
  degree == 8 ? halve<8>(c, left, right) : halve<4>(c, left, right);
}

int count_roots(const Piece& p, int degree, double err) {
  const Lanes bound{err, err, err, err};
  return degree == 8 ? count_roots<8>(p.c.data(), bound, bound, err)
                     : count_roots<4>(p.c.data(), bound, bound, err);
}
int count_roots(const Piece& p, int, const Errors& err) {
  return count_roots<8>(p.c.data(), err.low, err.high, err.last);
}

Errors errors_of(const Piece& p, const GrowingBound& bound, double err) {
  const double left = (1 - p.u0) + bound.growth * p.u0;
  const double growth = ((1 - p.u1) + bound.growth * p.u1) / left;
  const double left2 = left * left, left4 = left2 * left2, growth2 = growth * growth;
  const double first = bound.first * (left4 * left4) * (1 + 0x1p-40);
  const double growth4 = growth2 * growth2;
  const Lanes low = first * Lanes{1, growth, growth2, growth2 * growth}, high = growth4 * low;
  const Lanes all{err, err, err, err};
  // The order of the comparisons matters: what is no number is no bound.
  return {low < all ? low : all, high < all ? high : all, std::min(err, growth4 * high[0])};
}

bool narrow(const Piece& p, int degree, double err, const TimeMap& time, DoubleRoot& root) {
  double xl = 0, xr = 1;
  const double sl = p.c[0];
  // First where the polygon of the coefficients crosses zero.
  int k = 0;
  while (k < degree - 1 && (p.c[k + 1] > 0) == (sl > 0)) ++k;
  const double crossing = p.c[k] / (p.c[k] - p.c[k + 1]);
  double x = (k + std::min(std::max(0.0, crossing), 1.0)) / degree;
  double slope = 0, curve = 0;
  for (int step = 0; step < 60; ++step) {
    const double f = value(degree, p.c.data(), x, slope, curve);
    if (std::fabs(f) <= err) break;
    ((f > 0) == (sl > 0) ? xl : xr) = x;
    // Halley's method. Far from the root its denominator may vanish: then Newton's.
    const double newton = f / slope;
    const double bend = 1 - 0.5 * newton * (curve / slope);
    const double change = bend > 0.5 ? newton / bend : newton;
    const double next = x - change;
    if (next > xl && next < xr) {
      x = next;
      // The step after this one would be about its cube, or Newton's its square.
      if (std::fabs(change) < (bend > 0.5 ? 0x1p-16 : 0x1p-24)) break;
    } else {
      x = 0.5 * (xl + xr);
    }
  }
  const double width = p.u1 - p.u0;
  // Not as narrow as can be: after a flip the next search starts at the enclosure's end and must
  // see the sign of the polynomial there.
  double delta = 16 * err / std::fabs(slope) + 0x1p-42;
  for (int attempt = 0; attempt < 2; ++attempt, delta *= 64 * 64) {
    // The narrower enclosure and, in case that it is none, a wider one.
    const double wide = 64 * delta;
    const Lanes at{std::max(xl, x - delta), std::min(xr, x + delta), std::max(xl, x - wide),
                   std::min(xr, x + wide)};
    Lanes f = values(degree, p.c.data(), at);
    if (!(sl > 0)) f = -f;
    for (int end = 0; end < 4; end += 2) {
      if (!(f[end] > err) || !(f[end + 1] < -err)) continue;
      root.lo = time(p.u0 + width * at[end]) - time.slack;
      root.hi = time(p.u0 + width * at[end + 1]) + time.slack;
      root.piece_hi = time(p.u1) - time.slack;
      root.after = sl > 0 ? Sign::negative : Sign::positive;
      return root.lo > time(p.u0) + time.slack && root.hi < root.piece_hi;
    }
  }
  return false;
}

}  // namespace voroproof::internal::double_roots_detail
