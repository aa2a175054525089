#include "filtered/search/bernstein.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include "exact/rounding.h"

#include "filtered/numbers/lanes.h"

namespace voroproof::internal {

namespace {

constexpr double u = unit_roundoff;

// Radii that differ by less than this part of a distance are nearly equal.
constexpr double kNearlyEqual = 0x1p-16;

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
  Lanes err0, err1;  // at one end
};

template <bool certified>
[[gnu::always_inline]] inline void place(const Motion& motion, const Quad& q, double a, double b,
                                         Ends& e) {
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
    const Lanes size = abs(x) + abs(y);
    const Lanes size0 = abs(e.x0) + abs(e.y0), size1 = abs(e.x1) + abs(e.y1);
    const Lanes ex = lanes(&DoubleMotion::ex), ev = lanes(&DoubleMotion::ev);
    e.err = 4 * u * (size + size0 + size1) + ex + ev * (abs(ta) + abs(tb));
    e.err0 = 4 * u * (size + size0) + ex + ev * abs(ta);
    e.err1 = 4 * u * (size + size1) + ex + ev * abs(tb);
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

// The bound for f from the sizes and errors of the pairs.
inline double cotangency_error(const Lanes& size, const Lanes& err, const Lanes& other_size,
                               const Lanes& other_err) {
  const Lanes bound = size * other_size;
  const Lanes error = size * other_err + other_size * err + err * other_err + u * (8 * bound);
  const double A = bound[0], B = bound[1], C = bound[2];
  const double ea = error[0], eb = error[1], ec = error[2];
  const double s3 = A + B + C;
  const double es = ea + eb + ec;
  return (2 * s3 * es + es * es + 4 * (B * ec + C * eb + eb * ec) +
          u * (320 * (s3 * s3 + 4 * B * C))) *
             (1 + 0x1p-40) +
         1e-290;
}

template <bool certified>
[[gnu::always_inline]] inline double cotangency_form(const Ends& e, double* f) {
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
    return cotangency_error(with_l.size, with_l.err, others.size, others.err);
  }
  return 0;
}

// Bounds that grow with the coefficient. Where generators go far all of the above is as large as at
// the far end, the values at the other one are not. For a pair let S0 = |d0|^2 + dr^2 and S1
// likewise, for all pairs S1 <= g^2 S0, and eta such that an offset or dr errs by at most eta at a
// and by g eta at b. Then d0.d1 and dr^2 are at most g S0 in magnitude, dr^2 at most g^2 S0, and
// coefficient k of p is at most g^k S0 and errs by at most g^k (5 root(S0) + 3 eta) eta: products
// of two offsets by 2 root(2) root(S0) eta + 2 eta^2, dr^2 by 2 root(S0) eta + eta^2. Sums and
// products of such bounds are again such, in the scaled basis and so in weighted means: of f as
// above, with S0 for P. Subdivision keeps within the same bounds on a part: g is linear in time.
template <int a0, int a1, int a2, int b0, int b1, int b2>
struct PairSizes {
  Lanes s0, s1, eta0, eta1;
  explicit PairSizes(const Ends& e) {
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
    s0 = ax * ax + ay * ay + dr2;
    s1 = bx * bx + by * by + dr2;
    eta0 = sum(e.err0) + 2 * u * (abs(ax) + abs(ay) + abs(dr));
    eta1 = sum(e.err1) + 2 * u * (abs(bx) + abs(by) + abs(dr));
  }
};

// Infinite where nobody goes far: the one bound for all serves well then.
[[gnu::noinline]] GrowingBound growing_bound(const Ends& ends) {
  const PairSizes<0, 0, 0, 1, 2, 3> with_l(ends);
  const PairSizes<2, 1, 1, 3, 3, 2> others(ends);
  if ((exceeding(with_l.s1, 64 * with_l.s0) | exceeding(others.s1, 64 * others.s0)) == 0) {
    return {std::numeric_limits<double>::infinity(), 1};
  }
  const Lanes growths = with_l.s1 / with_l.s0, other_growths = others.s1 / others.s0;
  double growth2 = 0;
  for (int k = 0; k < 3; ++k) growth2 = std::max({growth2, growths[k], other_growths[k]});
  // Pays for the rounding of sizes, too.
  const double growth = std::sqrt(growth2) * (1 + 0x1p-40);
  const auto error = [&](const auto& pairs) {
    const Lanes eta1 = pairs.eta1 / growth;
    const Lanes eta = pairs.eta0 > eta1 ? pairs.eta0 : eta1;
    return (5 * square_root(pairs.s0) + 3 * eta) * eta + u * (4 * pairs.s0);
  };
  return {cotangency_error(with_l.s0, error(with_l), others.s0, error(others)), growth};
}

// Scaled coefficients of C (four equal radii): with base 3, C = p0 (d1 x d2) + p1 (d2 x d0) + p2
// (d0 x d1) for offsets d to the base and p = |d|^2. Sizes: |p| <= m^2, |d x d'| <= m m', m as
// above; errors as above. The summands side by side in lanes; what is of two disks, in that of the
// third.
//
// Radii that differ, by at most `spread`, do not appear in C, but f, here four times that
// of the paper, is -4 C^2 for equal ones only: a
// pair's tangency is p = D - dr^2, D its squared distance, and f = a^2 + b^2 + c^2 - 2 (ab + bc +
// ca) in the products a = p_01 p_23 and so on. Putting D for p changes a by at most spread^2 (D_01
// + D_23 + spread^2), with e the sum of these bounds f by at most e (2 (a + b + c) + e), a + b + c
// in terms of D. Beyond the square root of that, twice what would do, |C| shows that f < 0: it is
// added to the bound.
template <bool certified>
[[gnu::always_inline]] inline double cocircularity_form(const Ends& e, double spread, double* f) {
  const auto next = [](const Lanes& x) { return __builtin_shufflevector(x, x, 1, 2, 0, 3); };
  const auto last = [](const Lanes& x) { return __builtin_shufflevector(x, x, 2, 0, 1, 3); };
  const Lanes dx0 = e.x0 - e.x0[3], dy0 = e.y0 - e.y0[3];
  const Lanes dx1 = e.x1 - e.x1[3], dy1 = e.y1 - e.y1[3];
  const Lanes p[3] = {dx0 * dx0 + dy0 * dy0, 2 * (dx0 * dx1 + dy0 * dy1), dx1 * dx1 + dy1 * dy1};
  const Lanes ix0 = next(dx0), iy0 = next(dy0), ix1 = next(dx1), iy1 = next(dy1);
  const Lanes jx0 = last(dx0), jy0 = last(dy0), jx1 = last(dx1), jy1 = last(dy1);
  const Lanes cross[3] = {ix0 * jy0 - iy0 * jx0, (ix0 * jy1 - iy0 * jx1) + (ix1 * jy0 - iy1 * jx0),
                          ix1 * jy1 - iy1 * jx1};
  Lanes term[5];
  multiply2(p, cross, term);
  const auto sum = [](const Lanes& x) { return x[0] + x[1] + x[2]; };
  for (int m = 0; m < 5; ++m) f[m] = sum(term[m]);
  if constexpr (certified) {
    const Lanes at0 = abs(dx0) + abs(dy0), at1 = abs(dx1) + abs(dy1);
    const Lanes far = at0 > at1 ? at0 : at1;
    const Lanes eta = e.err + e.err[3] + 2 * u * far;
    const Lanes s = far * far;
    const Lanes ep = (3 * far + 2 * eta) * eta;
    const Lanes size = next(far) * last(far);
    const Lanes ex =
        2 * (next(far) * last(eta) + last(far) * next(eta) + next(eta) * last(eta)) + 4 * u * size;
    double error =
        sum(s * ex + size * ep + ep * ex + u * ((64 * s) * (2 * size))) * (1 + 0x1p-40) + 1e-290;
    if (spread > 0) {
      const Lanes way = far + 2 * eta;
      const Lanes to_base = way * way, apart = (next(way) + last(way)) * (next(way) + last(way));
      const double square = spread * spread;
      const double pairs = sum(to_base + apart) + 3 * square, products = sum(to_base * apart);
      error += spread * std::sqrt(pairs) * std::sqrt(2 * products + square * pairs) * (1 + 0x1p-40);
    }
    return error;
  }
  return 0;
}

}  // namespace

bool flip_polynomial_is_cocircularity(const Motion& motion, const Quad& q) {
  const double radius = motion.doubles(q.l).r;
  for (const GenId g : {q.r, q.s, q.e}) {
    if (motion.doubles(g).r != radius) return false;
  }
  if (motion.radii_are_doubles()) return true;
  const auto& disks = motion.input().disks;
  return q.l != container_id && disks[q.l].radius == disks[q.r].radius &&
         disks[q.l].radius == disks[q.s].radius && disks[q.l].radius == disks[q.e].radius;
}

namespace {

// Four radii that are equal, or where the search for a collapse asks, nearly: so that C tells more
// than f, whose roots are close to each other then.
struct Likeness {
  bool equal = false;
  double spread = 0;  // of those not equal, a bound on the differences; 0 where they are not small
};

template <bool nearly>
[[gnu::always_inline]] inline Likeness likeness(const Motion& motion, const Quad& q,
                                                const Ends& e) {
  const Lanes differences = abs(e.r - e.r[0]);
  double small = 0;
  if constexpr (nearly) {
    small = kNearlyEqual * (std::fabs(e.x0[0] - e.x0[1]) + std::fabs(e.y0[0] - e.y0[1]));
  }
  if (exceeding(differences, Lanes{small, small, small, small}) != 0) return {};
  if (exceeding(differences, Lanes{}) == 0 && flip_polynomial_is_cocircularity(motion, q)) {
    return {.equal = true};
  }
  if constexpr (nearly) {
    const double error = std::max({e.err[0], e.err[1], e.err[2], e.err[3]});
    const double largest = std::max({differences[1], differences[2], differences[3]});
    const double spread = 2 * (largest + error) * (1 + 0x1p-40);
    if (spread < 2 * small) return {.spread = spread};
  }
  return {};
}

// Whether all scaled coefficients are beyond their bounds on one side.
template <int degree>
bool has_one_sign(const double* c, double err) {
  const double side = c[0] > 0 ? 1 : -1;
  if (!(side * c[degree] > err)) return false;
  if constexpr (degree == 4) return exceeding(side * load(c), err * Lanes{1, 4, 6, 4}) == 0xf;
  return (exceeding(side * load(c), err * Lanes{1, 8, 28, 56}) &
          exceeding(side * load(c + 4), err * Lanes{70, 56, 28, 8})) == 0xf;
}

template <bool certified, bool nearly>
bool form_flip_polynomial_of(const Motion& motion, const Quad& q, double a, double b,
                             BernsteinForm& out) {
  Ends ends;
  place<certified>(motion, q, a, b, ends);
  const Likeness alike = likeness<nearly>(motion, q, ends);
  out.spread = alike.spread;
  out.degree = alike.equal || alike.spread > 0 ? 4 : 8;
  out.err = out.degree == 4 ? cocircularity_form<certified>(ends, out.spread, out.c.data())
                            : cotangency_form<certified>(ends, out.c.data());
  if (out.degree == 4 ? has_one_sign<4>(out.c.data(), out.err)
                      : has_one_sign<8>(out.c.data(), out.err)) {
    return true;
  }
  if (out.degree == 4) {
    out.c[1] *= 0.25;
    out.c[2] *= 1.0 / 6;
    out.c[3] *= 0.25;
  } else {
    for (int k = 1; k < 8; ++k) out.c[k] *= kInverse8[k];
    if constexpr (nearly) {
      // An infinite bound for all says that coefficients may have overflowed: no other holds then.
      out.bound = out.err < std::numeric_limits<double>::infinity() ? growing_bound(ends)
                                                                    : GrowingBound{out.err, 1};
    }
  }
  return false;
}

}  // namespace

template <bool certified>
bool form_flip_polynomial(const Motion& motion, const Quad& q, double a, double b,
                          BernsteinForm& out) {
  return form_flip_polynomial_of<certified, false>(motion, q, a, b, out);
}

bool form_for_collapse(const Motion& motion, const Quad& q, double a, double b,
                       BernsteinForm& out) {
  return form_flip_polynomial_of<true, true>(motion, q, a, b, out);
}

template bool form_flip_polynomial<true>(const Motion&, const Quad&, double, double,
                                         BernsteinForm&);
template bool form_flip_polynomial<false>(const Motion&, const Quad&, double, double,
                                          BernsteinForm&);

}  // namespace voroproof::internal
