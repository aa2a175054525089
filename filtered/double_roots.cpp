#include "filtered/double_roots.h"

#include <cmath>

#include "filtered/de_casteljau.h"

namespace voroproof::double_roots_detail {

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

// Value and derivative with respect to the parameter in [0, 1].
template <int degree>
double value(const double* c, double x, double& slope) {
  double w[degree + 1];
  for (int k = 0; k <= degree; ++k) w[k] = c[k];
  const double y = 1 - x;
  each_level<degree>(
      w, [&](double a, double b) { return y * a + x * b; },
      [&](auto rest) {
        if constexpr (rest == 1) slope = degree * (w[1] - w[0]);
      });
  return w[0];
}

double value(int degree, const double* c, double x, double& slope) {
  return degree == 8 ? value<8>(c, x, slope) : value<4>(c, x, slope);
}

}  // namespace

void halve(int degree, const double* c, double* left, double* right) {
  degree == 8 ? halve<8>(c, left, right) : halve<4>(c, left, right);
}

int count_roots(const Piece& p, int degree, double err) {
  int variations = 0;
  int last = 0;
  int uncertain = 0;  // since the last certain sign
  for (int k = 0; k <= degree; ++k) {
    const int s = p.c[k] > err ? 1 : p.c[k] < -err ? -1 : 0;
    if (s == 0) {
      if (k == 0 || k == degree) return -1;
      ++uncertain;
      continue;
    }
    if (last != 0) {
      if (s != last) {
        // One uncertain coefficient between different signs changes nothing.
        if (uncertain > 1) return -1;
        ++variations;
      } else if (uncertain > 0) {
        return -1;
      }
    }
    last = s;
    uncertain = 0;
  }
  return variations <= 1 ? variations : -1;
}

bool narrow(const Piece& p, int degree, double err, const TimeMap& time, DoubleRoot& root) {
  double xl = 0, xr = 1;
  const double sl = p.c[0];
  const double fl = std::fabs(p.c[0]), fr = std::fabs(p.c[degree]);
  double x = fl / (fl + fr);
  double slope = 0;
  for (int step = 0; step < 60; ++step) {
    const double f = value(degree, p.c.data(), x, slope);
    if (std::fabs(f) <= err) break;
    ((f > 0) == (sl > 0) ? xl : xr) = x;
    const double newton = f / slope;
    const double next = x - newton;
    if (next > xl && next < xr) {
      x = next;
      // The step after this one would be about its square.
      if (std::fabs(newton) < 0x1p-24) break;
    } else {
      x = 0.5 * (xl + xr);
    }
  }
  const double width = p.u1 - p.u0;
  double delta = 8 * err / std::fabs(slope) + 0x1p-42;
  for (int attempt = 0; attempt < 4; ++attempt, delta *= 64) {
    const double a = std::fmax(x - delta, xl), b = std::fmin(x + delta, xr);
    double unused = 0;
    const double fa = a > 0 ? value(degree, p.c.data(), a, unused) : p.c[0];
    const double fb = b < 1 ? value(degree, p.c.data(), b, unused) : p.c[degree];
    if (!((sl > 0 ? fa : -fa) > err) || !((sl > 0 ? fb : -fb) < -err)) continue;
    root.lo = time(p.u0 + width * a) - time.slack;
    root.hi = time(p.u0 + width * b) + time.slack;
    root.piece_hi = time(p.u1) - time.slack;
    root.after = sl > 0 ? Sign::negative : Sign::positive;
    return root.lo > time(p.u0) + time.slack && root.hi < root.piece_hi;
  }
  return false;
}

}  // namespace voroproof::double_roots_detail
