#include "filtered/bernstein.h"

#include <cmath>

namespace voroproof {

namespace {

constexpr double u = 0x1p-53;

constexpr std::array<double, 9> kBinomial8{1, 8, 28, 56, 70, 56, 28, 8, 1};
constexpr std::array<double, 5> kBinomial4{1, 4, 6, 4, 1};
constexpr std::array<double, 9> kInverse8{1,        1.0 / 8,  1.0 / 28, 1.0 / 56, 1.0 / 70,
                                          1.0 / 56, 1.0 / 28, 1.0 / 8,  1};

// Products in the scaled Bernstein basis (coefficients times binomials) are plain
// convolutions.
inline void multiply2(const double* p, const double* q, double* r) {
  r[0] = p[0] * q[0];
  r[1] = p[0] * q[1] + p[1] * q[0];
  r[2] = p[0] * q[2] + p[1] * q[1] + p[2] * q[0];
  r[3] = p[1] * q[2] + p[2] * q[1];
  r[4] = p[2] * q[2];
}

// The generators of q at both ends of the window: x[k][0..3], with the error of a
// coordinate in err.
struct Ends {
  double x0[4], y0[4], x1[4], y1[4], r[4], err[4], rerr[4];
};

template <bool certified>
inline void place(const Motion& motion, const Quad& q, double a, double b, Ends& e) {
  const GenId ids[4] = {q.l, q.r, q.s, q.e};
  // Side by side first: the compiler then computes with all four at once.
  double t[4], x[4], y[4], vx[4], vy[4], ex[4], ev[4];
  for (int i = 0; i < 4; ++i) {
    const DoubleMotion& m = motion.doubles(ids[i]);
    t[i] = m.t;
    x[i] = m.x;
    y[i] = m.y;
    vx[i] = m.vx;
    vy[i] = m.vy;
    e.r[i] = m.r;
    if constexpr (certified) {
      ex[i] = m.ex;
      ev[i] = m.ev;
      e.rerr[i] = m.er;
    }
  }
  for (int i = 0; i < 4; ++i) {
    const double ta = a - t[i];
    const double tb = b - t[i];
    e.x0[i] = x[i] + vx[i] * ta;
    e.y0[i] = y[i] + vy[i] * ta;
    e.x1[i] = x[i] + vx[i] * tb;
    e.y1[i] = y[i] + vy[i] * tb;
    if constexpr (certified) {
      // x + v dt: dt, the product and the sum are rounded once each, so the error is
      // below u |x + v dt| + 2u(1+u) |v dt|, with |v dt| <= |x0| + |x| and likewise
      // for the other end: 4u times (all magnitudes together) covers it. The state's
      // own error adds ex + ev |dt|.
      const double size = std::fabs(x[i]) + std::fabs(y[i]) + std::fabs(e.x0[i]) +
                          std::fabs(e.y0[i]) + std::fabs(e.x1[i]) + std::fabs(e.y1[i]);
      e.err[i] = 4 * u * size + ex[i] + ev[i] * (std::fabs(ta) + std::fabs(tb));
    }
  }
}

// Scaled coefficients of the cotangency polynomial, and the bound of the error of
// the unscaled ones.
//
// Derivation of the bound. For a pair let d0, d1 be the offsets at the two ends, S =
// |d0|^2 + |d1|^2, dr the difference of radii. The Bernstein coefficients of p are
// |d0|^2 - dr^2, d0.d1 - dr^2, |d1|^2 - dr^2, all at most P = S + dr^2 in magnitude.
// If every component of the offsets is within eta of the truth (both positions, and
// one rounding of the difference, at most u sqrt(S)), then products of two offsets
// err by at most eta (|d0x|+|d0y|+|d1x|+|d1y|) + 2 eta^2 <= (2 sqrt(S) + 2 eta) eta,
// squares by (2 sqrt 2 sqrt(S) + 2 eta) eta; dr^2 errs by (2 |dr| + rho) rho for an
// error rho of dr; evaluation adds at most 4u P. With error e_p and size P a product
// of two such polynomials has coefficients (weighted means of products) of size at
// most A = P P' and error e_a = P e' + P' e + e e' + 8u A. Finally f = (a-b-c)^2 - 4bc
// with S3 = A + B + C has error 2 S3 e_s + e_s^2 + 4 (B e_c + C e_b + e_b e_c), and
// evaluation adds at most 40u (S3^2 + 4BC). The subdivisions made of it later (at
// most 24, each adding at most 8u times the largest coefficient) are paid for here:
// 256u in all. The last factor pays for the roundings of this bound itself.
template <bool certified>
inline double cotangency_form(const Ends& e, double* f) {
  constexpr int I[6] = {0, 2, 0, 1, 0, 1};
  constexpr int J[6] = {1, 3, 2, 3, 3, 2};
  // Offsets of the pairs side by side, as in place().
  double dax[6], day[6], dbx[6], dby[6], ddr[6], both[6], rboth[6];
  for (int k = 0; k < 6; ++k) {
    const int i = I[k], j = J[k];
    dax[k] = e.x0[i] - e.x0[j];
    day[k] = e.y0[i] - e.y0[j];
    dbx[k] = e.x1[i] - e.x1[j];
    dby[k] = e.y1[i] - e.y1[j];
    ddr[k] = e.r[i] - e.r[j];
    if constexpr (certified) {
      both[k] = e.err[i] + e.err[j];
      rboth[k] = e.rerr[i] + e.rerr[j];
    }
  }
  double p0[6], p1[6], p2[6], size[6], err[6], squares[6], dr2s[6];
  for (int k = 0; k < 6; ++k) {
    const double ax = dax[k], ay = day[k], bx = dbx[k], by = dby[k], dr = ddr[k];
    const double dr2 = dr * dr;
    const double q0 = ax * ax + ay * ay;
    const double q2 = bx * bx + by * by;
    p0[k] = q0 - dr2;
    p1[k] = 2 * ((ax * bx + ay * by) - dr2);
    p2[k] = q2 - dr2;
    if constexpr (certified) {
      squares[k] = q0 + q2;
      dr2s[k] = dr2;
    }
  }
  if constexpr (certified) {
    // Apart, because a root may set errno and so is taken one by one.
    double roots[6];
    for (int k = 0; k < 6; ++k) roots[k] = std::sqrt(squares[k]);
    for (int k = 0; k < 6; ++k) {
      const double s = squares[k], root = roots[k], dr = ddr[k], dr2 = dr2s[k];
      const double eta = both[k] + u * root;
      const double rho = rboth[k] + u * std::fabs(dr);
      size[k] = s + dr2;
      err[k] = (3 * root + 2 * eta) * eta + (2 * std::fabs(dr) + rho) * rho + 4 * u * size[k];
    }
  }
  double p[6][3];
  for (int k = 0; k < 6; ++k) {
    p[k][0] = p0[k];
    p[k][1] = p1[k];
    p[k][2] = p2[k];
  }
  double a[5], b[5], c[5], g[5];
  multiply2(p[0], p[1], a);
  multiply2(p[2], p[3], b);
  multiply2(p[4], p[5], c);
  for (int k = 0; k < 5; ++k) g[k] = a[k] - b[k] - c[k];
  for (int k = 0; k < 9; ++k) f[k] = 0;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) f[i + j] += g[i] * g[j] - 4 * (b[i] * c[j]);
  }
  if constexpr (certified) {
    const auto product = [&](int i, double& bound, double& error) {
      bound = size[i] * size[i + 1];
      error = size[i] * err[i + 1] + size[i + 1] * err[i] + err[i] * err[i + 1] + 8 * u * bound;
    };
    double A, B, C, ea, eb, ec;
    product(0, A, ea);
    product(2, B, eb);
    product(4, C, ec);
    const double s3 = A + B + C;
    const double es = ea + eb + ec;
    return (2 * s3 * es + es * es + 4 * (B * ec + C * eb + eb * ec) +
            256 * u * (s3 * s3 + 4 * B * C)) *
               (1 + 0x1p-40) +
           1e-290;
  }
  return 0;
}

// Scaled coefficients of C (four equal radii): with base 3, C = p0 (d1 x d2) - p1 (d0
// x d2) + p2 (d0 x d1) for offsets d to the base and p = |d|^2. Sizes: |p| <= S, |d x
// d'| <= sqrt(S S'); errors as above.
template <bool certified>
inline double cocircularity_form(const Ends& e, double* f) {
  double dx0[3], dy0[3], dx1[3], dy1[3], p[3][3], root[3], eta[3];
  for (int k = 0; k < 3; ++k) {
    dx0[k] = e.x0[k] - e.x0[3];
    dy0[k] = e.y0[k] - e.y0[3];
    dx1[k] = e.x1[k] - e.x1[3];
    dy1[k] = e.y1[k] - e.y1[3];
    p[k][0] = dx0[k] * dx0[k] + dy0[k] * dy0[k];
    p[k][1] = 2 * (dx0[k] * dx1[k] + dy0[k] * dy1[k]);
    p[k][2] = dx1[k] * dx1[k] + dy1[k] * dy1[k];
    if constexpr (certified) {
      root[k] = std::sqrt(p[k][0] + p[k][2]);
      eta[k] = e.err[k] + e.err[3] + 2 * u * root[k];
    }
  }
  for (int k = 0; k < 5; ++k) f[k] = 0;
  double error = 0;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;  // p_k (d_i x d_j), cyclic
    const double cross[3] = {
        dx0[i] * dy0[j] - dy0[i] * dx0[j],
        (dx0[i] * dy1[j] - dy0[i] * dx1[j]) + (dx1[i] * dy0[j] - dy1[i] * dx0[j]),
        dx1[i] * dy1[j] - dy1[i] * dx1[j]};
    double term[5];
    multiply2(p[k], cross, term);
    for (int m = 0; m < 5; ++m) f[m] += term[m];
    if constexpr (certified) {
      const double ep = (3 * root[k] + 2 * eta[k]) * eta[k];
      const double size = root[i] * root[j];
      const double ex = 2 * (root[i] * eta[j] + root[j] * eta[i] + eta[i] * eta[j]) + 4 * u * size;
      const double s = root[k] * root[k];
      error += s * ex + size * ep + ep * ex + 128 * u * s * size;
    }
  }
  return certified ? error * (1 + 0x1p-40) + 1e-290 : 0;
}

}  // namespace

bool flip_polynomial_is_cocircularity(const Motion& motion, const Quad& q) {
  const DoubleMotion& l = motion.doubles(q.l);
  bool rounded = l.er != 0;
  for (const GenId g : {q.r, q.s, q.e}) {
    const DoubleMotion& m = motion.doubles(g);
    if (m.r != l.r) return false;
    rounded = rounded || m.er != 0;
  }
  // Equal doubles are equal radii unless one is rounded: then ask for the values.
  if (!rounded) return true;
  const auto& disks = motion.input().disks;
  return q.l != container_id && disks[q.l].radius == disks[q.r].radius &&
         disks[q.l].radius == disks[q.s].radius && disks[q.l].radius == disks[q.e].radius;
}

template <bool certified>
bool form_flip_polynomial(const Motion& motion, const Quad& q, double a, double b,
                          BernsteinForm& out) {
  Ends ends;
  place<certified>(motion, q, a, b, ends);
  const bool equal = ends.r[0] == ends.r[1] && ends.r[0] == ends.r[2] && ends.r[0] == ends.r[3] &&
                     flip_polynomial_is_cocircularity(motion, q);
  out.degree = equal ? 4 : 8;
  out.err = equal ? cocircularity_form<certified>(ends, out.c.data())
                  : cotangency_form<certified>(ends, out.c.data());
  const double* binomial = equal ? kBinomial4.data() : kBinomial8.data();
  int positive = 0, negative = 0;
  for (int k = 0; k <= out.degree; ++k) {
    const double bound = certified ? out.err * binomial[k] : 0.0;
    positive += out.c[k] > bound;
    negative += out.c[k] < -bound;
  }
  if (positive == out.degree + 1 || negative == out.degree + 1) return true;
  if (equal) {
    out.c[1] *= 0.25;
    out.c[2] *= 1.0 / 6;
    out.c[3] *= 0.25;
  } else {
    for (int k = 1; k < 8; ++k) out.c[k] *= kInverse8[k];
  }
  return false;
}

template bool form_flip_polynomial<true>(const Motion&, const Quad&, double, double,
                                         BernsteinForm&);
template bool form_flip_polynomial<false>(const Motion&, const Quad&, double, double,
                                          BernsteinForm&);

}  // namespace voroproof
