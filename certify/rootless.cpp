#include "certify/rootless.h"

#include <algorithm>

// Vectors never leave this file, so that how they would be passed does not matter.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace voroproof {

namespace {

constexpr double u = 0x1p-53;

// Four doubles, one an edge: every operation is that of binary64, on each.
using Lanes = double __attribute__((vector_size(32)));
using Mask = long long __attribute__((vector_size(32)));

inline Lanes magnitude(const Lanes& x) {
  constexpr long long all_but_sign = 0x7fffffffffffffff;
  return reinterpret_cast<Lanes>(reinterpret_cast<Mask>(x) & all_but_sign);
}

// Products in the scaled Bernstein basis (coefficients times binomials) are plain convolutions.
inline void multiply(const Lanes* p, const Lanes* q, Lanes* r) {
  r[0] = p[0] * q[0];
  r[1] = p[0] * q[1] + p[1] * q[0];
  r[2] = p[0] * q[2] + p[1] * q[1] + p[2] * q[0];
  r[3] = p[1] * q[2] + p[2] * q[1];
  r[4] = p[2] * q[2];
}

}  // namespace

void RootlessBatch::prove() {
  proved_.resize(spans_.size());
  for (std::size_t k = 0; k < spans_.size(); k += kLanes) {
    prove_lanes(k, std::min(kLanes, spans_.size() - k));
  }
}

// The cotangency polynomial f = (A - B - C)^2 - 4BC, A, B and C being products of two tangencies
// p_ij p_kl, in the Bernstein basis of degree 8 over [a, b]: without a root where all coefficients
// have one sign.
//
// Error bound. A coordinate at an end of the interval is x + v dt: dt, the product and the sum are
// rounded once each, which is below 4u times all the magnitudes together, and the motion's own
// errors add ex + ev |dt|. For a pair let d0, d1 be the offsets at the two ends, D the sum of the
// magnitudes of their four components, dr the difference of radii. The coefficients of p are
// |d0|^2 - dr^2, d0.d1 - dr^2 and |d1|^2 - dr^2, at most P = D^2 + dr^2 in magnitude. With every
// component within eta of the truth (both coordinates, and one rounding of at most uD) and dr
// within rho they err by at most 2 eta (D + eta) + rho (2 |dr| + rho), and evaluation adds at most
// 4u P. A product of two such polynomials has coefficients (weighted means of products) of size at
// most A = P P' and error e_A = P e' + P' e + e e' + 8u A. Finally f errs by 2 S e_S + e_S^2 +
// 4 (B e_C + C e_B + e_B e_C), S = A + B + C, and evaluation adds at most 40u (S^2 + 4BC). The last
// factor pays for the roundings of the bound itself, the last summand for underflow.
void RootlessBatch::prove_lanes(std::size_t first, std::size_t count) {
  const Span* span[kLanes];
  for (std::size_t k = 0; k < kLanes; ++k) span[k] = &spans_[first + std::min(k, count - 1)];
  const Lanes a{span[0]->a, span[1]->a, span[2]->a, span[3]->a};
  const Lanes b{span[0]->b, span[1]->b, span[2]->b, span[3]->b};
  Lanes x0[4], y0[4], x1[4], y1[4], radius[4], error[4], radius_error[4];
  constexpr GenId Quad::*roles[4] = {&Quad::l, &Quad::r, &Quad::s, &Quad::e};
  for (int i = 0; i < 4; ++i) {
    const DoubleMotion& m0 = motion_.doubles(span[0]->q.*roles[i]);
    const DoubleMotion& m1 = motion_.doubles(span[1]->q.*roles[i]);
    const DoubleMotion& m2 = motion_.doubles(span[2]->q.*roles[i]);
    const DoubleMotion& m3 = motion_.doubles(span[3]->q.*roles[i]);
    const Lanes t{m0.t, m1.t, m2.t, m3.t};
    const Lanes x{m0.x, m1.x, m2.x, m3.x}, vx{m0.vx, m1.vx, m2.vx, m3.vx};
    const Lanes y{m0.y, m1.y, m2.y, m3.y}, vy{m0.vy, m1.vy, m2.vy, m3.vy};
    const Lanes ex{m0.ex, m1.ex, m2.ex, m3.ex}, ev{m0.ev, m1.ev, m2.ev, m3.ev};
    const Lanes ta = a - t, tb = b - t;
    x0[i] = x + vx * ta;
    y0[i] = y + vy * ta;
    x1[i] = x + vx * tb;
    y1[i] = y + vy * tb;
    radius[i] = Lanes{m0.r, m1.r, m2.r, m3.r};
    radius_error[i] = Lanes{m0.er, m1.er, m2.er, m3.er};
    const Lanes size = magnitude(x) + magnitude(y) + magnitude(x0[i]) + magnitude(y0[i]) +
                       magnitude(x1[i]) + magnitude(y1[i]);
    error[i] = 4 * u * size + ex + ev * (magnitude(ta) + magnitude(tb));
  }
  constexpr int I[6] = {0, 2, 0, 1, 0, 1};
  constexpr int J[6] = {1, 3, 2, 3, 3, 2};
  Lanes p[6][3], size[6], err[6];
  for (int k = 0; k < 6; ++k) {
    const int i = I[k], j = J[k];
    const Lanes ax = x0[i] - x0[j], ay = y0[i] - y0[j], bx = x1[i] - x1[j], by = y1[i] - y1[j];
    const Lanes dr = radius[i] - radius[j], dr2 = dr * dr;
    p[k][0] = ax * ax + ay * ay - dr2;
    p[k][1] = 2 * (ax * bx + ay * by - dr2);
    p[k][2] = bx * bx + by * by - dr2;
    const Lanes d = magnitude(ax) + magnitude(ay) + magnitude(bx) + magnitude(by);
    const Lanes eta = error[i] + error[j] + u * d;
    const Lanes rho = radius_error[i] + radius_error[j] + u * magnitude(dr);
    size[k] = d * d + dr2;
    err[k] = 2 * eta * (d + eta) + rho * (2 * magnitude(dr) + rho) + 4 * u * size[k];
  }
  Lanes A[5], B[5], C[5], g[5], f[9];
  multiply(p[0], p[1], A);
  multiply(p[2], p[3], B);
  multiply(p[4], p[5], C);
  for (int k = 0; k < 5; ++k) g[k] = A[k] - B[k] - C[k];
  for (int k = 0; k < 9; ++k) f[k] = Lanes{};
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) f[i + j] += g[i] * g[j] - 4 * (B[i] * C[j]);
  }
  Lanes bound[3], e[3];
  for (int k = 0; k < 3; ++k) {
    const int i = 2 * k, j = i + 1;
    bound[k] = size[i] * size[j];
    e[k] = size[i] * err[j] + size[j] * err[i] + err[i] * err[j] + 8 * u * bound[k];
  }
  const Lanes s = bound[0] + bound[1] + bound[2], es = e[0] + e[1] + e[2];
  const Lanes total =
      (2 * s * es + es * es + 4 * (bound[1] * e[2] + bound[2] * e[1] + e[1] * e[2]) +
       40 * u * (s * s + 4 * bound[1] * bound[2])) *
          (1 + 0x1p-40) +
      1e-290;
  constexpr double binomials[9] = {1, 8, 28, 56, 70, 56, 28, 8, 1};
  Mask positive = f[0] > total, negative = f[0] < -total;
  for (int k = 1; k < 9; ++k) {
    const Lanes limit = total * binomials[k];
    positive &= f[k] > limit;
    negative &= f[k] < -limit;
  }
  const Mask proved = positive | negative;
  for (std::size_t k = 0; k < count; ++k) proved_[first + k] = proved[k] != 0;
}

}  // namespace voroproof
