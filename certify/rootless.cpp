#include "certify/rootless.h"

#include <algorithm>
#include <bit>
#include "exact/rounding.h"

#include "certify/motion_lanes.h"

namespace voroproof::internal {

namespace {

constexpr double u = unit_roundoff;

// Products in the scaled Bernstein basis (coefficients times binomials) are plain convolutions.
inline void multiply(const Lanes* p, const Lanes* q, Lanes* r) {
  r[0] = p[0] * q[0];
  r[1] = p[0] * q[1] + p[1] * q[0];
  r[2] = p[0] * q[2] + p[1] * q[1] + p[2] * q[0];
  r[3] = p[1] * q[2] + p[2] * q[1];
  r[4] = p[2] * q[2];
}

// Where the pairs of the four generators l, r, s, e stand, so that the products of the first two,
// of the next and of the last are A, B and C.
constexpr int I[6] = {0, 2, 0, 1, 0, 1};
constexpr int J[6] = {1, 3, 2, 3, 3, 2};

// The error of all coefficients of f where those of the six tangencies are at most `size` and err
// by at most `err`.
inline Lanes cotangency_error(const Lanes* size, const Lanes* err) {
  Lanes bound[3], e[3];
  for (int k = 0; k < 3; ++k) {
    const int i = 2 * k, j = i + 1;
    bound[k] = size[i] * size[j];
    e[k] = size[i] * err[j] + size[j] * err[i] + err[i] * err[j] + u * (8 * bound[k]);
  }
  const Lanes s = bound[0] + bound[1] + bound[2], es = e[0] + e[1] + e[2];
  return (2 * s * es + es * es + 4 * (bound[1] * e[2] + bound[2] * e[1] + e[1] * e[2]) +
          0.5 * u * (80 * (s * s + 4 * bound[1] * bound[2]))) *
             (1 + 0x1p-40) +
         1e-290;
}

// The bits of a set strictly between its lowest and its highest.
unsigned inside(unsigned bits) {
  return bits == 0 ? 0 : (std::bit_floor(bits) - 1) & ~((bits & -bits) * 2 - 1);
}

constexpr double binomials[9] = {1, 8, 28, 56, 70, 56, 28, 8, 1};

// Whether every tangency is positive, between a disk and the container negative, over the whole
// time: p within err, coefficient by coefficient.
LaneMask separated(const Lanes (&radius)[4], const Lanes (&p)[6][3], const Lanes (&err)[6]) {
  LaneMask all = ~LaneMask{};
  for (int k = 0; k < 6; ++k) {
    const LaneMask wall = (radius[I[k]] < 0) ^ (radius[J[k]] < 0);
    for (int i = 0; i < 3; ++i) {
      const Lanes limit = i == 1 ? 2 * err[k] : err[k];
      all &= (wall & (p[k][i] < -limit)) | (~wall & (p[k][i] > limit));
    }
  }
  return all;
}

}  // namespace

int most_roots(unsigned above, unsigned below) {
  if (above == 0 || below == 0) return 0;
  return ((above & inside(below)) | (below & inside(above))) != 0 ? 2 : 1;
}

void RootlessBatch::prove() {
  found_.assign(spans_.size(), Found::nothing);
  end_signs_.resize(spans_.size());
  for (std::size_t k = 0; k < spans_.size(); k += kLanes) {
    const std::size_t count = std::min(kLanes, spans_.size() - k);
    const std::array<const Span*, kLanes> of = lanes(k, count);
    std::array<double, kLanes> a{}, b{};
    for (std::size_t i = 0; i < kLanes; ++i) {
      a[i] = of[i]->a;
      b[i] = of[i]->b;
    }
    judge(gather(of), a, b, k, count);
  }
}

void RootlessBatch::prove_instant() {
  found_.assign(spans_.size(), Found::nothing);
  for (std::size_t k = 0; k < spans_.size(); k += kLanes) {
    const std::size_t count = std::min(kLanes, spans_.size() - k);
    judge_at(gather(lanes(k, count)), spans_[k].a, spans_[k].b, k, count);
  }
}

// The cotangency is the same function in whatever order the four are.

void RootlessBatch::prove_around(const Quad& q, const std::array<GenId, 4>& outer,
                                 const std::array<double, 4>& from, double b) {
  found_.assign(kLanes, Found::nothing);
  end_signs_.resize(kLanes);
  const DoubleMotion &s = motion_.doubles(q.s), &e = motion_.doubles(q.e);
  const std::array<MotionLanes, 4> g{
      MotionLanes(motion_.doubles(q.l)), MotionLanes(motion_.doubles(q.r)), MotionLanes(e, e, s, s),
      MotionLanes(motion_.doubles(outer[0]), motion_.doubles(outer[1]), motion_.doubles(outer[2]),
                  motion_.doubles(outer[3]))};
  judge(g, from, {b, b, b, b}, 0, kLanes);
}

void RootlessBatch::prove_around_flipped(const Quad& q, const std::array<GenId, 4>& outer, double a,
                                         double b) {
  found_.assign(kLanes, Found::nothing);
  const DoubleMotion &l = motion_.doubles(q.l), &r = motion_.doubles(q.r);
  const std::array<MotionLanes, 4> g{
      MotionLanes(motion_.doubles(q.s)), MotionLanes(motion_.doubles(q.e)), MotionLanes(r, l, l, r),
      MotionLanes(motion_.doubles(outer[0]), motion_.doubles(outer[1]), motion_.doubles(outer[2]),
                  motion_.doubles(outer[3]))};
  judge_at(g, a, b, 0, kLanes);
}

// The last of them again where there are fewer.
std::array<const RootlessBatch::Span*, RootlessBatch::kLanes> RootlessBatch::lanes(
    std::size_t first, std::size_t count) const {
  std::array<const Span*, kLanes> of{};
  for (std::size_t k = 0; k < kLanes; ++k) of[k] = &spans_[first + std::min(k, count - 1)];
  return of;
}

std::array<MotionLanes, 4> RootlessBatch::gather(const std::array<const Span*, kLanes>& of) const {
  const auto role = [&](GenId Quad::*id) {
    return MotionLanes(motion_.doubles(of[0]->q.*id), motion_.doubles(of[1]->q.*id),
                       motion_.doubles(of[2]->q.*id), motion_.doubles(of[3]->q.*id));
  };
  return {role(&Quad::l), role(&Quad::r), role(&Quad::s), role(&Quad::e)};
}

// The cotangency polynomial f = (A - B - C)^2 - 4BC, A, B and C being products of two tangencies
// p_ij p_kl, in the Bernstein basis of degree 8 over [a, b]: without a root where all coefficients
// have one sign, and with one at most where they change it once.
//
// Error bound. A coordinate at an end of the interval is x + v dt: dt, the product and the sum are
// rounded once each, which is below 4u times all the magnitudes together, and the motion's own
// errors add ex + ev |dt|; ex is that of the radius as well. For a pair let d0, d1 be the offsets
// at the two ends, d the sum of the magnitudes of their four components, dr the difference of
// radii. The coefficients of p are |d0|^2 - dr^2, d0.d1 - dr^2 and |d1|^2 - dr^2, at most P = d^2 +
// dr^2 in magnitude. With every component and dr within eta of the truth (both coordinates, and one
// rounding of at most u D, D = d + |dr|) they err by at most 2 eta (d + eta) + eta (2 |dr| + eta) =
// eta (2 D + 3 eta), and evaluation adds at most 4u P. A product of two such polynomials has
// coefficients (weighted means of products) of size at most A = P P' and error e_A = P e' + P' e +
// e e' + 8u A. Finally f errs by 2 S e_S + e_S^2 + 4 (B e_C + C e_B + e_B e_C), S = A + B + C, and
// evaluation adds at most 40u (S^2 + 4BC). The last factor pays for the roundings of the bound
// itself, the last summand of each for underflow. Sizes are multiplied before they are scaled down
// by u, by more than the binomials: where a coefficient overflows, its bound has done so, and
// nothing is beyond it.
void RootlessBatch::judge(const std::array<MotionLanes, 4>& generators,
                          const std::array<double, kLanes>& from,
                          const std::array<double, kLanes>& to, std::size_t first,
                          std::size_t count) {
  const Lanes a{from[0], from[1], from[2], from[3]}, b{to[0], to[1], to[2], to[3]};
  Lanes x0[4], y0[4], x1[4], y1[4], radius[4], error[4];
  for (int i = 0; i < 4; ++i) {
    const MotionLanes& g = generators[i];
    const Lanes ta = a - g.t, tb = b - g.t;
    x0[i] = g.x + g.vx * ta;
    y0[i] = g.y + g.vy * ta;
    x1[i] = g.x + g.vx * tb;
    y1[i] = g.y + g.vy * tb;
    radius[i] = g.r;
    const Lanes size = abs(g.x) + abs(g.y) + abs(x0[i]) + abs(y0[i]) + abs(x1[i]) + abs(y1[i]);
    error[i] = 4 * u * size + g.ex + g.ev * (abs(ta) + abs(tb));
  }
  Lanes p[6][3], size[6], err[6];
  for (int k = 0; k < 6; ++k) {
    const int i = I[k], j = J[k];
    const Lanes ax = x0[i] - x0[j], ay = y0[i] - y0[j], bx = x1[i] - x1[j], by = y1[i] - y1[j];
    const Lanes dr = radius[i] - radius[j], dr2 = dr * dr;
    p[k][0] = ax * ax + ay * ay - dr2;
    p[k][1] = 2 * (ax * bx + ay * by - dr2);
    p[k][2] = bx * bx + by * by - dr2;
    const Lanes d = abs(ax) + abs(ay) + abs(bx) + abs(by), all = d + abs(dr);
    const Lanes eta = error[i] + error[j] + u * all;
    size[k] = d * d + dr2;
    err[k] = eta * (2 * all + 3 * eta) + u * (4 * size[k]) + 0x1p-1000;
  }
  Lanes A[5], B[5], C[5], g[5], twice[5], f[9];
  multiply(p[0], p[1], A);
  multiply(p[2], p[3], B);
  multiply(p[4], p[5], C);
  for (int k = 0; k < 5; ++k) {
    g[k] = A[k] - B[k] - C[k];
    twice[k] = 2 * g[k];
    B[k] = 4 * B[k];
  }
  for (int k = 0; k < 9; ++k) f[k] = Lanes{};
  for (int i = 0; i < 5; ++i) {
    f[2 * i] += g[i] * g[i];
    for (int j = i + 1; j < 5; ++j) f[i + j] += twice[i] * g[j];
    for (int j = 0; j < 5; ++j) f[i + j] -= B[i] * C[j];
  }
  const Lanes total = cotangency_error(size, err);
  LaneMask positive = f[0] > total, negative = f[0] < -total;
  for (int k = 1; k < 9; ++k) {
    const Lanes limit = total * binomials[k];
    positive &= f[k] > limit;
    negative &= f[k] < -limit;
  }
  const LaneMask proved = positive | negative;
  for (std::size_t k = 0; k < count; ++k) {
    if (proved[k] != 0) found_[first + k] = Found::rootless;
  }
  if (!any(~proved)) return;
  const LaneMask asked = separated(radius, p, err) & ~proved;
  for (std::size_t k = 0; k < count; ++k) {
    if (asked[k] != 0) count_roots(f, total, k, first + k);
  }
}

// At most one root, by Descartes' rule for the coefficients of one lane, each within `total`.
void RootlessBatch::count_roots(const Lanes (&f)[9], const Lanes& total, std::size_t lane,
                                std::size_t k) {
  unsigned above = 0, below = 0;  // what is not a number may be both
  for (int i = 0; i < 9; ++i) {
    const double limit = total[lane] * binomials[i];
    above |= (f[i][lane] < -limit ? 0U : 1U) << i;
    below |= (f[i][lane] > limit ? 0U : 1U) << i;
  }
  if (most_roots(above, below) > 1) return;
  found_[k] = Found::one_root;
  const bool up = (above >> 8) != 0, down = (below >> 8) != 0;
  end_signs_[k] = up && down ? Sign::unknown : up ? Sign::positive : Sign::negative;
}

// As above, at one time with an uncertainty: the polynomials are constants. A coordinate moves by
// at most |v| + ev times half the interval from where it is at the middle.
void RootlessBatch::judge_at(const std::array<MotionLanes, 4>& generators, double a, double b,
                             std::size_t first, std::size_t count) {
  const DoubleBall hull = DoubleBall::hull(a, b);
  Lanes x[4], y[4], radius[4], error[4];
  for (int i = 0; i < 4; ++i) {
    const MotionLanes& g = generators[i];
    const Lanes dt = hull.mid - g.t;
    x[i] = g.x + g.vx * dt;
    y[i] = g.y + g.vy * dt;
    radius[i] = g.r;
    const Lanes size = abs(g.x) + abs(g.y) + abs(x[i]) + abs(y[i]);
    const Lanes speed = abs(g.vx) + abs(g.vy) + g.ev;
    error[i] = (4 * u * size + g.ex + g.ev * abs(dt) + speed * hull.rad) * (1 + 0x1p-40) + 1e-290;
  }
  Lanes p[6], size[6], err[6];
  for (int k = 0; k < 6; ++k) {
    const int i = I[k], j = J[k];
    const Lanes dx = x[i] - x[j], dy = y[i] - y[j];
    const Lanes dr = radius[i] - radius[j], dr2 = dr * dr;
    p[k] = dx * dx + dy * dy - dr2;
    const Lanes d = abs(dx) + abs(dy), all = d + abs(dr);
    const Lanes eta = error[i] + error[j] + u * all;
    size[k] = d * d + dr2;
    err[k] = eta * (2 * all + 3 * eta) + u * (4 * size[k]);
  }
  const Lanes B = p[2] * p[3], C = p[4] * p[5], g = p[0] * p[1] - B - C;
  const LaneMask proved = abs(g * g - 4 * (B * C)) > cotangency_error(size, err);
  for (std::size_t k = 0; k < count; ++k) {
    if (proved[k] != 0) found_[first + k] = Found::rootless;
  }
}

}  // namespace voroproof::internal
