// The root is c - f(c) / f'(x) for c the middle of [lo, hi] and some x between c and the root (mean
// value theorem). f(c) is computed in double-doubles, f'(c) in doubles, and |f'(x) - f'(c)| is
// bounded by |x - c| times a bound of |f''|.
// Notation and bounds: filtered/numbers/jet.h.
#include "filtered/search/newton_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "exact/predicates.h"
#include "filtered/numbers/jet.h"
#include "filtered/search/quad_lanes.h"

namespace voroproof::internal {

namespace {

constexpr double u = unit_roundoff, w = jet_w, up = jet_up, tiny = jet_tiny;

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
// False where a p is not known to u V: then the bounds of what follows do not hold.
template <class Pairs>
bool tangency_jets(const Places& at, double h, Jet<Lanes>& p) {
  const auto offset = [&](const Dd<Lanes>& z) -> Dd<Lanes> {
    return Dd<Lanes>{Pairs::first(z.hi), Pairs::first(z.lo)} -
           Dd<Lanes>{Pairs::second(z.hi), Pairs::second(z.lo)};
  };
  const Dd<Lanes> x = offset(at.x), y = offset(at.y), r = offset(at.r);
  const Lanes wx = difference<Pairs>(at.vx), wy = difference<Pairs>(at.vy);
  p.v = tangency_of(x, y, r);
  p.d = 2 * (x.hi * wx + y.hi * wy);
  const Lanes s = abs(x.hi) + abs(y.hi), R = abs(r.hi), W = abs(wx) + abs(wy);
  const Lanes rounded = 4 * w * sum<Pairs>(at.size);
  const Lanes e_s = sum<Pairs>(at.e_centre) + rounded, e_r = sum<Pairs>(at.e_r) + rounded;
  const Lanes e_W = sum<Pairs>(at.e_speed) + u * W;
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

Jet<double> lane(const Jet<Lanes>& a, int k) {
  return {{a.v.hi[k], a.v.lo[k]},
          a.d[k],
          a.V[k],
          a.D[k],
          a.e_v[k],
          a.e_d[k],
          a.Vh[k],
          a.Dh[k],
          a.D2h[k]};
}

std::optional<Jet<double>> cotangency_jet(const Places& places, double h) {
  Jet<Lanes> with_l, others;
  if (!tangency_jets<PairsWithL>(places, h, with_l)) return std::nullopt;
  if (!tangency_jets<OtherPairs>(places, h, others)) return std::nullopt;
  const Jet<Lanes> abc = with_l * others;
  return cotangency_of(lane(abc, 0), lane(abc, 1), lane(abc, 2));
}

// The determinants of the offsets to e of two of the three others, next to the tangency of the
// third: of l, r and s in lanes 0 to 2, (x, y) of the next one and (x', y') of the one after it.
//   e_v   from the offsets s e' + s' e + e e', s = |x| + |y| and e in both coordinates together.
//         Products 9 w each and a difference, 4 w, of at most V = s s': below 16 w V.
//   e_d   of w x' + x w' as for tangencies: (s + e) e_W' + W' e and the other way round, and below
//         16 u D, D = s W' + s' W.
bool determinant_jets(const Places& at, double h, Jet<Lanes>& x) {
  using Pairs = PairsWithBase;
  const auto offset = [&](const Dd<Lanes>& z) -> Dd<Lanes> {
    return z - Dd<Lanes>{Pairs::second(z.hi), Pairs::second(z.lo)};
  };
  const Dd<Lanes> dx = offset(at.x), dy = offset(at.y);
  const Lanes wx = difference<Pairs>(at.vx), wy = difference<Pairs>(at.vy);
  const Lanes s = abs(dx.hi) + abs(dy.hi), W = abs(wx) + abs(wy);
  const Lanes e_s = sum<Pairs>(at.e_centre) + 4 * w * sum<Pairs>(at.size);
  const Lanes e_W = sum<Pairs>(at.e_speed) + u * W;
  const auto of = [](const auto& turn, const Dd<Lanes>& z) {
    return Dd<Lanes>{turn(z.hi), turn(z.lo)};
  };
  x.v = determinant(of(next, dx), of(next, dy), of(last, dx), of(last, dy));
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

// The summands of C in the lanes of l, r and s.
std::optional<Jet<double>> cocircularity_jet(const Places& places, double h) {
  Jet<Lanes> to_e, determinants;
  if (!tangency_jets<PairsWithBase>(places, h, to_e)) return std::nullopt;
  if (!determinant_jets(places, h, determinants)) return std::nullopt;
  const Jet<Lanes> terms = to_e * determinants;
  // Two sums.
  const auto value = [&](int k) { return Dd<double>{terms.v.hi[k], terms.v.lo[k]}; };
  const double V = total(terms.V), D = total(terms.D);
  return Jet<double>{value(0) + value(1) + value(2),
                     total(terms.d),
                     V,
                     D,
                     total(terms.e_v) + 8 * w * V,
                     total(terms.e_d) + 2 * u * D,
                     total(terms.Vh),
                     total(terms.Dh),
                     total(terms.D2h)};
}

}  // namespace

DdBall newton_step(const Motion& motion, const Quad& q, double lo, double hi, bool cocircular) {
  const double c = 0.5 * (lo + hi);
  const double h = std::max(hi - c, c - lo) * up;
  const DdBall unknown(c, 0, std::numeric_limits<double>::infinity());
  const Places places(motion, q, c);
  const std::optional<Jet<double>> jet =
      cocircular ? cocircularity_jet(places, h) : cotangency_jet(places, h);
  if (!jet) return unknown;
  const double f = jet->v.hi, slope = jet->d, curve = jet->D2h;
  const double e_f = jet->e_v, e_slope = jet->e_d;

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
