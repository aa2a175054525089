#include "filtered/bernstein.h"

#include <cmath>

#include "filtered/lanes.h"

namespace voroproof {

namespace {

constexpr double u = 0x1p-53;

constexpr std::array<double, 9> kBinomial8{1, 8, 28, 56, 70, 56, 28, 8, 1};
constexpr std::array<double, 5> kBinomial4{1, 4, 6, 4, 1};
constexpr std::array<double, 9> kInverse8{1,        1.0 / 8,  1.0 / 28, 1.0 / 56, 1.0 / 70,
                                          1.0 / 56, 1.0 / 28, 1.0 / 8,  1};

// Products in the scaled Bernstein basis (coefficients times binomials) are plain
// convolutions.
template <class T>
inline void multiply2(const T* p, const T* q, T* r) {
  r[0] = p[0] * q[0];
  r[1] = p[0] * q[1] + p[1] * q[0];
  r[2] = p[0] * q[2] + p[1] * q[1] + p[2] * q[0];
  r[3] = p[1] * q[2] + p[2] * q[1];
  r[4] = p[2] * q[2];
}

// The generators of q at both ends of the window, in the lanes l, r, s, e, with the error of a
// coordinate or radius in err.
struct Ends {
  Lanes x0, y0, x1, y1, r, err;
};

template <bool certified>
inline void place(const Motion& motion, const Quad& q, double a, double b, Ends& e) {
  const DoubleMotion* m[4] = {&motion.doubles(q.l), &motion.doubles(q.r), &motion.doubles(q.s),
                              &motion.doubles(q.e)};
  const auto lanes = [&](double DoubleMotion::*member) {
    return Lanes{m[0]->*member, m[1]->*member, m[2]->*member, m[3]->*member};
  };
  const Lanes t = lanes(&DoubleMotion::t);
  const Lanes x = lanes(&DoubleMotion::x), y = lanes(&DoubleMotion::y);
  const Lanes vx = lanes(&DoubleMotion::vx), vy = lanes(&DoubleMotion::vy);
  const Lanes ta = a - t, tb = b - t;
  e.r = lanes(&DoubleMotion::r);
  e.x0 = x + vx * ta;
  e.y0 = y + vy * ta;
  e.x1 = x + vx * tb;
  e.y1 = y + vy * tb;
  if constexpr (certified) {
    // x + v dt: dt, the product and the sum are rounded once each, so the error is
    // below u |x + v dt| + 2u(1+u) |v dt|, with |v dt| <= |x0| + |x| and likewise
    // for the other end: 4u times (all magnitudes together) covers it. The state's
    // own error adds ex + ev |dt|.
    const Lanes size = abs(x) + abs(y) + abs(e.x0) + abs(e.y0) + abs(e.x1) + abs(e.y1);
    e.err =
        4 * u * size + lanes(&DoubleMotion::ex) + lanes(&DoubleMotion::ev) * (abs(ta) + abs(tb));
  }
}

// Scaled coefficients of the cotangency polynomial, and the bound of the error of
// the unscaled ones.
//
// Derivation of the bound. For a pair let d0, d1 be the offsets at the two ends, S =
// |d0|^2 + |d1|^2, dr the difference of radii. The Bernstein coefficients of p are
// |d0|^2 - dr^2, d0.d1 - dr^2, |d1|^2 - dr^2, all at most P = S + dr^2 in magnitude.
// If every component of the offsets and dr is within eta of the truth (both generators, and
// one rounding of the difference, at most u m or u |dr|), then products of two offsets
// err by at most eta (|d0x|+|d0y|+|d1x|+|d1y|) + 2 eta^2, squares by 2 eta (|d0x|+|d0y|) + 2 eta^2,
// both at most (2 m + 2 eta) eta for m the larger of |d0x|+|d0y| and |d1x|+|d1y|; dr^2 errs by
// (2 |dr| + eta) eta; together (2 m + 2 |dr| + 3 eta) eta. Evaluation adds at most 4u P. With error
// e_p and size P a product of two such polynomials has coefficients (weighted means of products) of
// size at most A = P P' and error e_a = P e' + P' e + e e' + 8u A. Finally f = (a-b-c)^2 - 4bc with
// S3 = A + B + C has error 2 S3 e_s + e_s^2 + 4 (B e_c + C e_b + e_b e_c), and evaluation adds at
// most 40u (S3^2 + 4BC). What is made of it later is paid for here: at most 24 subdivisions, each
// adding at most 8u times the largest coefficient, and one evaluation, 40u (three roundings on each
// of eight levels; the weight 1 - x errs by u, the value by 8u). 320u in all. The last factor pays
// for the roundings of this bound itself. Sizes are multiplied by these numbers before they are
// scaled down by u: where a coefficient overflows, its bound has done so.
//
// In lanes: first the pairs lr, ls, le, then se, re, rs, so that their products are a, b and c.
struct Pairs {
  Lanes p[3];  // scaled coefficients
  Lanes size, err;
};

template <bool certified, int a0, int a1, int a2, int b0, int b1, int b2>
inline void tangency_form(const Ends& e, Pairs& out) {
  const auto offset = [](const Lanes& x) {
    return __builtin_shufflevector(x, x, a0, a1, a2, a2) -
           __builtin_shufflevector(x, x, b0, b1, b2, b2);
  };
  const auto sum = [](const Lanes& x) {
    return __builtin_shufflevector(x, x, a0, a1, a2, a2) +
           __builtin_shufflevector(x, x, b0, b1, b2, b2);
  };
  const Lanes ax = offset(e.x0), ay = offset(e.y0), bx = offset(e.x1), by = offset(e.y1);
  const Lanes dr = offset(e.r);
  const Lanes dr2 = dr * dr;
  const Lanes q0 = ax * ax + ay * ay;
  const Lanes q2 = bx * bx + by * by;
  out.p[0] = q0 - dr2;
  out.p[1] = 2 * ((ax * bx + ay * by) - dr2);
  out.p[2] = q2 - dr2;
  if constexpr (certified) {
    const Lanes la = abs(ax) + abs(ay), lb = abs(bx) + abs(by);
    const Lanes twice = la + lb + abs(la - lb) + 2 * abs(dr);  // m + |dr|
    const Lanes eta = sum(e.err) + u * twice;
    out.size = q0 + q2 + dr2;
    out.err = (twice + 3 * eta) * eta + u * (4 * out.size);
  }
}

template <bool certified>
inline double cotangency_form(const Ends& e, double* f) {
  Pairs with_l, others;
  tangency_form<certified, 0, 0, 0, 1, 2, 3>(e, with_l);
  tangency_form<certified, 2, 1, 1, 3, 3, 2>(e, others);
  Lanes abc[5];
  multiply2(with_l.p, others.p, abc);
  double g[5], b[5], c[5];
  for (int k = 0; k < 5; ++k) {
    b[k] = 4 * abc[k][1];
    c[k] = abc[k][2];
    g[k] = abc[k][0] - abc[k][1] - abc[k][2];
  }
  // The square's mixed terms twice.
  const double d[4] = {2 * g[0], 2 * g[1], 2 * g[2], 2 * g[3]};
  f[0] = g[0] * g[0] - b[0] * c[0];
  f[1] = d[0] * g[1] - (b[0] * c[1] + b[1] * c[0]);
  f[2] = (d[0] * g[2] + g[1] * g[1]) - (b[0] * c[2] + b[1] * c[1] + b[2] * c[0]);
  f[3] = (d[0] * g[3] + d[1] * g[2]) - (b[0] * c[3] + b[1] * c[2] + b[2] * c[1] + b[3] * c[0]);
  f[4] = (d[0] * g[4] + d[1] * g[3] + g[2] * g[2]) -
         (b[0] * c[4] + b[1] * c[3] + b[2] * c[2] + b[3] * c[1] + b[4] * c[0]);
  f[5] = (d[1] * g[4] + d[2] * g[3]) - (b[1] * c[4] + b[2] * c[3] + b[3] * c[2] + b[4] * c[1]);
  f[6] = (d[2] * g[4] + g[3] * g[3]) - (b[2] * c[4] + b[3] * c[3] + b[4] * c[2]);
  f[7] = d[3] * g[4] - (b[3] * c[4] + b[4] * c[3]);
  f[8] = g[4] * g[4] - b[4] * c[4];
  if constexpr (certified) {
    const Lanes bound = with_l.size * others.size;
    const Lanes error = with_l.size * others.err + others.size * with_l.err +
                        with_l.err * others.err + u * (8 * bound);
    const double A = bound[0], B = bound[1], C = bound[2];
    const double ea = error[0], eb = error[1], ec = error[2];
    const double s3 = A + B + C;
    const double es = ea + eb + ec;
    return (2 * s3 * es + es * es + 4 * (B * ec + C * eb + eb * ec) +
            u * (320 * (s3 * s3 + 4 * B * C))) *
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
      error += s * ex + size * ep + ep * ex + u * (128 * (s * size));
    }
  }
  return certified ? error * (1 + 0x1p-40) + 1e-290 : 0;
}

}  // namespace

bool flip_polynomial_is_cocircularity(const Motion& motion, const Quad& q) {
  const DoubleMotion& l = motion.doubles(q.l);
  bool rounded = motion.seconds(q.l).er != 0 || motion.seconds(q.l).r != 0;
  for (const GenId g : {q.r, q.s, q.e}) {
    const DoubleMotion& m = motion.doubles(g);
    if (m.r != l.r) return false;
    rounded = rounded || motion.seconds(g).er != 0 || motion.seconds(g).r != 0;
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
