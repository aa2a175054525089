// The root is c - f(c) / f'(x) for c the middle of [lo, hi] and some x between c and the root (mean
// value theorem). f(c) is computed in double-doubles, f'(c) in doubles, and |f'(x) - f'(c)| is
// bounded by |x - c| times a bound of |f''|.
//
// Notation. u = 2^-53, w = u^2. Small letters are computed values, e_x bounds the distance of a
// value x to the truth, and the capital X bounds |x|. Bounds are sums and products of nonnegative
// numbers, so that all that is relatively small in them (their own roundings, x against its leading
// part, factors 1 + O(u), products of two relative errors) is paid for by the factor `up` at the
// end: some hundred operations of relative error 4 u each at most stay far below its 2^-30. `tiny`
// is above what underflow can add to one operation.
#include "filtered/search/newton_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include "exact/rounding.h"

#include "filtered/numbers/lanes.h"

namespace voroproof::internal {

namespace {

constexpr double u = unit_roundoff, w = 0x1p-106, up = 1 + 0x1p-30, tiny = 0x1p-900;

// Double-doubles without radii, normalized: |lo| <= u |hi|. While nothing overflows,
//   a + b  errs by at most 4 w (|a.hi| + |b.hi|) =: 4 w M. The leading sum is split exactly into s
//          and e, |e| <= u M. Rounding a.lo + b.lo costs u (u M); adding that to e, 2 u M in all,
//          costs 2 u (u M). The last sum is exact. Together 3 w M.
//   a * b  errs by at most 9 w |a.hi b.hi| =: 9 w M. The leading product is split exactly into p
//   and
//          e, |e| <= u M. Left out: |a.lo b.lo| <= w M. Roundings: the two mixed products, w M
//          each; their sum, of 2 u M, 2 w M; its sum with e, of 3 u M, 3 w M. The last sum is
//          exact, as |p| is the larger. Together 8 w M.
template <class T>
struct Dd {
  T hi, lo;
};

template <class T>
inline Dd<T> operator+(const Dd<T>& a, const Dd<T>& b) {
  T s, e;
  two_sum_of(a.hi, b.hi, s, e);
  Dd<T> r;
  two_sum_of<T>(s, e + (a.lo + b.lo), r.hi, r.lo);
  return r;
}
template <class T>
inline Dd<T> operator-(const Dd<T>& a, const Dd<T>& b) {
  return a + Dd<T>{-b.hi, -b.lo};
}
template <class T>
inline Dd<T> operator*(const Dd<T>& a, const Dd<T>& b) {
  const T p = a.hi * b.hi;
  const T e = product_error(a.hi, b.hi, p) + (a.hi * b.lo + a.lo * b.hi);
  const T s = p + e;
  return {s, e - (s - p)};
}

// The generators l, r, s, e at c, one in each lane.
//
// Centres x + v (c - t): the delay c - t is a double-double without error. From the state its
// radius and that of v times |delay|; 9 w |v delay| for the product, 4 w (|x| + |v delay|) for the
// sum. Below 16 w (|x| + |v delay|), with x and y together.
struct Places {
  Dd<Lanes> x, y, r;
  Lanes vx, vy;
  Lanes size;                    // above |x| + |y| and |r|
  Lanes e_centre, e_r, e_speed;  // in both coordinates together

  Places(const Motion& motion, const Quad& q, double c) {
    const DoubleMotion* first[4];
    const SecondMotion* second[4];
    const GenId ids[4] = {q.l, q.r, q.s, q.e};
    for (int i = 0; i < 4; ++i) {
      first[i] = &motion.doubles(ids[i]);
      second[i] = &motion.seconds(ids[i]);
    }
    // Inline: g++ warns of functions that return lanes, which processors without them pass
    // otherwise.
    const auto of_first = [&](double DoubleMotion::*member) __attribute__((always_inline)) {
      return Lanes{first[0]->*member, first[1]->*member, first[2]->*member, first[3]->*member};
    };
    const auto of_second = [&](double SecondMotion::*member) __attribute__((always_inline)) {
      return Lanes{second[0]->*member, second[1]->*member, second[2]->*member, second[3]->*member};
    };
    const Lanes rad = of_second(&SecondMotion::ex), v_rad = of_second(&SecondMotion::ev);
    Dd<Lanes> delay;
    two_sum_of(Lanes{c, c, c, c}, -of_first(&DoubleMotion::t), delay.hi, delay.lo);
    const Lanes far = abs(delay.hi);
    const auto at = [&](const Dd<Lanes>& p, const Dd<Lanes>& dp, Dd<Lanes>& out, Lanes& v) {
      out = p + dp * delay;
      v = dp.hi;
      size += abs(out.hi);
      e_centre += rad + v_rad * far + 16 * w * (abs(p.hi) + abs(dp.hi) * far) + tiny;
      e_speed += abs(dp.lo) + v_rad;
    };
    r = {of_first(&DoubleMotion::r), of_second(&SecondMotion::r)};
    e_r = of_second(&SecondMotion::er);
    size = abs(r.hi);
    e_centre = e_speed = Lanes{};
    at({of_first(&DoubleMotion::x), of_second(&SecondMotion::x)},
       {of_first(&DoubleMotion::vx), of_second(&SecondMotion::vx)}, x, vx);
    at({of_first(&DoubleMotion::y), of_second(&SecondMotion::y)},
       {of_first(&DoubleMotion::vy), of_second(&SecondMotion::vy)}, y, vy);
  }
};

// Three quantities at c with their derivatives in time, in three lanes; bounds at c, and of the
// true values within h of c.
struct Jets {
  Dd<Lanes> v;
  Lanes d;         // of the derivative
  Lanes V, D;      // V >= |v|, D >= |d|
  Lanes e_v, e_d;  // e_v <= 3 u V
  Lanes Vh, Dh, D2h;
};

// The tangencies p = x^2 + y^2 - r^2 of the offsets x, y, r of generators from each other, and p' =
// 2 (x wx + y wy), (wx, wy) their relative velocity. With s = |x| + |y|, e_s the error of (x, y) in
// both coordinates together, W = |wx| + |wy|, e_W likewise:
//   e_s   the errors of the centres, and 4 w (sizes) for the difference; e_r likewise.
//   e_v   from the offsets (s + e_s)^2 - s^2 <= 2 (s + e_s) e_s, the same for r. Squares 9 w each
//         and two sums 4 w each of at most V = s^2 + r^2: below 32 w V.
//   e_W   errors of the velocities, and u W for the difference.
//   e_d   the offsets' leading parts err by e_s + u s: 2 (s + e_s) e_W + 2 W e_s + u D, D = 2 s W.
//         Two products and a sum, each rounded: 2 u D. Below 16 u D.
//   Within h the offset grows by at most (W + e_W) h, the velocity is the same: p'' = 2 |w|^2.
// a0..a2 and b0..b2 name the lanes of the generators of three pairs. False where a p is not known
// to u V: then the bounds of what follows do not hold.
template <int a0, int a1, int a2, int b0, int b1, int b2>
bool tangency_jets(const Places& at, double h, Jets& p) {
  const auto first = [](const Lanes& x) { return __builtin_shufflevector(x, x, a0, a1, a2, a2); };
  const auto second = [](const Lanes& x) { return __builtin_shufflevector(x, x, b0, b1, b2, b2); };
  const auto offset = [&](const Dd<Lanes>& z) {
    return Dd<Lanes>{first(z.hi), first(z.lo)} - Dd<Lanes>{second(z.hi), second(z.lo)};
  };
  const auto sum = [&](const Lanes& z) { return first(z) + second(z); };
  const Dd<Lanes> x = offset(at.x), y = offset(at.y), r = offset(at.r);
  const Lanes wx = first(at.vx) - second(at.vx), wy = first(at.vy) - second(at.vy);
  p.v = x * x + y * y - r * r;
  p.d = 2 * (x.hi * wx + y.hi * wy);
  const Lanes s = abs(x.hi) + abs(y.hi), R = abs(r.hi), W = abs(wx) + abs(wy);
  const Lanes difference = 4 * w * sum(at.size);
  const Lanes e_s = sum(at.e_centre) + difference, e_r = sum(at.e_r) + difference;
  const Lanes e_W = sum(at.e_speed) + u * W;
  p.V = s * s + R * R;
  p.e_v = 2 * (s + e_s) * e_s + 2 * (R + e_r) * e_r + 32 * w * p.V + tiny;
  p.D = 2 * s * W;
  p.e_d = 2 * (s + e_s) * e_W + 2 * W * e_s + 16 * u * p.D + tiny;
  const Lanes Wh = W + e_W, sh = s + e_s + Wh * h, Rh = R + e_r;
  p.Vh = sh * sh + Rh * Rh;
  p.Dh = 2 * sh * Wh;
  p.D2h = 2 * Wh * Wh;
  const auto known = p.e_v <= u * p.V;
  return known[0] != 0 && known[1] != 0 && known[2] != 0;
}

// The products of two tangencies each.
//   e_v   from the factors P e_q + Q e_p + e_p e_q, 9 w V for the product: below 16 w V.
//         As e_p <= u P and e_q <= u Q this is at most 3 u V.
//   e_d   of p q' + p' q: from the slopes P e_q' + Q e_p'; leading parts of p and q, each off by u
//         for e and by u for the part below, 2 u D; two products and a sum, 2 u D. Below 16 u D.
Jets products(const Jets& p, const Jets& q) {
  Jets a;
  a.v = p.v * q.v;
  a.d = p.v.hi * q.d + p.d * q.v.hi;
  a.V = p.V * q.V;
  a.D = p.V * q.D + p.D * q.V;
  a.e_v = p.V * q.e_v + q.V * p.e_v + p.e_v * q.e_v + 16 * w * a.V + tiny;
  a.e_d = p.V * q.e_d + q.V * p.e_d + 16 * u * a.D + tiny;
  a.Vh = p.Vh * q.Vh;
  a.Dh = p.Vh * q.Dh + p.Dh * q.Vh;
  a.D2h = p.D2h * q.Vh + 2 * p.Dh * q.Dh + p.Vh * q.D2h;
  return a;
}

// A polynomial at c with its derivative, bounds of their errors, and of the second derivative
// within h of c.
struct Jet {
  double value, slope, e_value, e_slope, curve;
};

// f = g^2 - 4 b c.
std::optional<Jet> cotangency_jet(const Places& places, double h) {
  // a = lr se, b = ls re, c = le rs.
  Jets with_l, others;
  if (!tangency_jets<0, 0, 0, 1, 2, 3>(places, h, with_l)) return std::nullopt;
  if (!tangency_jets<2, 1, 1, 3, 3, 2>(places, h, others)) return std::nullopt;
  const Jets all = products(with_l, others);
  struct Product {
    Dd<double> v;
    double d, V, D, e_v, e_d, Vh, Dh, D2h;
    Product(const Jets& a, int k)
        : v{a.v.hi[k], a.v.lo[k]},
          d(a.d[k]),
          V(a.V[k]),
          D(a.D[k]),
          e_v(a.e_v[k]),
          e_d(a.e_d[k]),
          Vh(a.Vh[k]),
          Dh(a.Dh[k]),
          D2h(a.D2h[k]) {}
  };
  const Product A(all, 0), B(all, 1), C(all, 2);

  // f = g^2 - 4 b c for g = a - b - c, G = A + B + C.
  //   e_g   the three errors; two sums, 4 w G each: below 16 w G.
  //   e_f   from g 2 G e_g + e_g^2, from b c 4 (B e_c + C e_b + e_b e_c). Two products, 9 w G^2 and
  //         9 w 4 B C, and a sum, 4 w (G^2 + 4 B C): below 64 w (G^2 + 4 B C).
  const Dd<double> g = A.v - B.v - C.v, bc = B.v * C.v;
  const Dd<double> f = g * g - Dd<double>{4 * bc.hi, 4 * bc.lo};
  const double G = A.V + B.V + C.V, e_g = A.e_v + B.e_v + C.e_v + 16 * w * G;
  const double e_f = 2 * G * e_g + e_g * e_g + 4 * (B.V * C.e_v + C.V * B.e_v + B.e_v * C.e_v) +
                     64 * w * (G * G + 4 * B.V * C.V) + tiny;

  // f' = 2 g g' - 4 (b' c + b c'), at most F1 = 2 G G' + 4 (B' C + B C').
  //   From the slopes 2 G e_g' + 4 (e_b' C + e_c' B), where g' = a' - b' - c' is rounded twice, 2 u
  //   G'. Leading parts of values: off by 3 u G + u G (g; b and c likewise), 4 u F1 in all.
  //   Products and sums: at most four roundings on every way, 4 u F1. Below 64 u F1.
  const double g_d = A.d - B.d - C.d;
  const double slope = 2 * g.hi * g_d - 4 * (B.d * C.v.hi + B.v.hi * C.d);
  const double G_d = A.D + B.D + C.D, e_gd = A.e_d + B.e_d + C.e_d;
  const double e_slope = 2 * G * e_gd + 4 * (B.e_d * C.V + C.e_d * B.V) +
                         64 * u * (2 * G * G_d + 4 * (B.D * C.V + C.D * B.V)) + tiny;

  // |f''| <= 2 g'^2 + 2 g g'' + 4 (b'' c + 2 b' c' + b c'') within h of c.
  const double Gh = A.Vh + B.Vh + C.Vh, Gh_d = A.Dh + B.Dh + C.Dh, Gh_dd = A.D2h + B.D2h + C.D2h;
  const double curve =
      2 * Gh_d * Gh_d + 2 * Gh * Gh_dd + 4 * (B.D2h * C.Vh + 2 * B.Dh * C.Dh + B.Vh * C.D2h);
  return Jet{f.hi, slope, e_f, e_slope, curve};
}

// The cross products of the offsets to e of two of the three others, next to the tangency of the
// third: of l, r and s in lanes 0 to 2, (x, y) of the next one and (x', y') of the one after it.
//   e_v   from the offsets s e' + s' e + e e', s = |x| + |y| and e in both coordinates together.
//         Products 9 w each and a difference, 4 w, of at most V = s s': below 16 w V.
//   e_d   of w x' + x w' as for tangencies: (s + e) e_W' + W' e and the other way round, and below
//         16 u D, D = s W' + s' W.
bool cross_jets(const Places& at, double h, Jets& x) {
  const auto next = [](const Lanes& z) { return __builtin_shufflevector(z, z, 1, 2, 0, 3); };
  const auto last = [](const Lanes& z) { return __builtin_shufflevector(z, z, 2, 0, 1, 3); };
  const auto base = [](const Lanes& z) { return __builtin_shufflevector(z, z, 3, 3, 3, 3); };
  const auto offset = [&](const Dd<Lanes>& z) { return z - Dd<Lanes>{base(z.hi), base(z.lo)}; };
  const Dd<Lanes> dx = offset(at.x), dy = offset(at.y);
  const Lanes wx = at.vx - base(at.vx), wy = at.vy - base(at.vy);
  const Lanes s = abs(dx.hi) + abs(dy.hi), W = abs(wx) + abs(wy);
  const Lanes e_s = at.e_centre + base(at.e_centre) + 4 * w * (at.size + base(at.size));
  const Lanes e_W = at.e_speed + base(at.e_speed) + u * W;
  const auto of = [](const auto& turn, const Dd<Lanes>& z) {
    return Dd<Lanes>{turn(z.hi), turn(z.lo)};
  };
  x.v = of(next, dx) * of(last, dy) - of(next, dy) * of(last, dx);
  x.d = (next(wx) * last(dy.hi) - next(wy) * last(dx.hi)) +
        (next(dx.hi) * last(wy) - next(dy.hi) * last(wx));
  const Lanes far = s + e_s;
  x.V = next(s) * last(s);
  x.e_v = next(far) * last(e_s) + last(far) * next(e_s) + 16 * w * x.V + tiny;
  x.D = next(s) * last(W) + next(W) * last(s);
  x.e_d = next(far) * last(e_W) + last(far) * next(e_W) + next(W) * last(e_s) +
          last(W) * next(e_s) + 16 * u * x.D + tiny;
  const Lanes Wh = W + e_W, sh = far + Wh * h;
  x.Vh = next(sh) * last(sh);
  x.Dh = next(sh) * last(Wh) + next(Wh) * last(sh);
  x.D2h = 2 * next(Wh) * last(Wh);
  const auto known = x.e_v <= u * x.V;
  return known[0] != 0 && known[1] != 0 && known[2] != 0;
}

// C = p_l (r x s) + p_r (s x l) + p_s (l x r), base e: three products and two sums, 4 w of the
// sizes each for the value and 1 u for the slope.
std::optional<Jet> cocircularity_jet(const Places& places, double h) {
  Jets to_e, crosses;
  if (!tangency_jets<0, 1, 2, 3, 3, 3>(places, h, to_e)) return std::nullopt;
  if (!cross_jets(places, h, crosses)) return std::nullopt;
  const Jets all = products(to_e, crosses);
  const auto term = [&](int k) { return Dd<double>{all.v.hi[k], all.v.lo[k]}; };
  const auto sum = [](const Lanes& z) { return z[0] + z[1] + z[2]; };
  const Dd<double> value = term(0) + term(1) + term(2);
  return Jet{value.hi, sum(all.d), sum(all.e_v) + 16 * w * sum(all.V) + tiny,
             sum(all.e_d) + 4 * u * sum(all.D) + tiny, sum(all.D2h)};
}

}  // namespace

DdBall newton_step(const Motion& motion, const Quad& q, double lo, double hi, bool cocircular) {
  const double c = 0.5 * (lo + hi);
  const double h = std::max(hi - c, c - lo) * up;
  const DdBall unknown(c, 0, std::numeric_limits<double>::infinity());
  const Places places(motion, q, c);
  const std::optional<Jet> jet =
      cocircular ? cocircularity_jet(places, h) : cotangency_jet(places, h);
  if (!jet) return unknown;
  // Not a structured binding: C++20 lets lambdas have them, clang++ 14 does not.
  const double f = jet->value, slope = jet->slope, curve = jet->curve;
  const double e_f = jet->e_value, e_slope = jet->e_slope;

  // The slope t at x is within sigma of the computed one, so at least `least` in magnitude. f is
  // within e_f + u |f| of its leading part f, 1/t within sigma / (|slope| least) of 1/slope, and
  // the quotient is rounded, once here and once in the bound. The root is no further from c than
  // |f| / least, so that the slopes to be bounded are those within that distance: once more, with
  // the same curve.
  const double size = std::fabs(f), step = f / slope;
  const auto sigma_within = [&](double reach) { return (e_slope + curve * reach) * up; };
  const auto least_for = [&](double sigma) { return (std::fabs(slope) - sigma) * (1 - 0x1p-50); };
  const double everywhere = least_for(sigma_within(h));
  if (!(everywhere > 0)) return unknown;
  const double reach = std::min(h, ((size * (1 + 2 * u) + e_f) / everywhere) * up + tiny);
  const double sigma = sigma_within(reach), least = least_for(sigma);
  if (!(least > 0)) return unknown;
  const double off =
      ((e_f + u * size + std::fabs(step) * sigma) / least + 2 * u * std::fabs(step)) * up + tiny;
  DdBall root(0, 0, off);
  dd_detail::two_sum(c, -step, root.hi, root.lo);
  return root.rad < std::numeric_limits<double>::infinity() ? root : unknown;
}

}  // namespace voroproof::internal
