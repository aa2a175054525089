// Narrowing a root that has been isolated.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "exact/patience.h"
#include "filtered/numbers/subdivision.h"
#include "filtered/search/branch_search.h"
#include "filtered/search/collapse.h"
#include "filtered/search/flip_polynomial.h"
#include "filtered/search/newton_step.h"

namespace voroproof::internal {

DdBall CollapseSearch::newton(const Quad& q, double lo, double hi) const {
  // One step of the interval Newton method: the root lies in c - f(c) / f'([lo, hi]).
  const bool cocircular = flip_polynomial_is_cocircularity(motion_, q);
  const double c = 0.5 * (lo + hi);
  const DdBall root = newton_step(motion_, q, lo, hi, cocircular);
  if (std::isfinite(root.rad)) return root;
  const DoubleBall slope = flip_slope(motion_, q, DoubleBall::hull(lo, hi), cocircular);
  const DdBall f = flip_value(motion_, q, DdBall(c), cocircular);
  return DdBall(c) - f / DdBall(slope.mid, 0, slope.rad);
}

DdBall CollapseSearch::refine(const Quad& q, double lo, double hi) const {
  DdBall best = newton(q, lo, hi);
  const auto is_enough = [&] { return best.rad < 0.25 * (hi - lo); };
  const auto take = [&](const DdBall& root) { best = root.rad < best.rad ? root : best; };
  // Where roots are close together, f tells less than an in-circle function.
  if (!is_enough()) take(refine_branch(motion_, q, lo, hi));
  if (!is_enough()) take(refine_halved(q, lo, hi));
  return best;
}

DdBall CollapseSearch::refine_halved(const Quad& q, double lo, double hi) const {
  const bool cocircular = flip_polynomial_is_cocircularity(motion_, q);
  const auto sign_at = [&](double t) {
    return sign(flip_value(motion_, q, DdBall(t), cocircular));
  };
  const Sign at_lo = sign_at(lo);
  if (is_certain(at_lo) && sign_at(hi) == -at_lo) {
    for (;;) {
      const double middle = 0.5 * (lo + hi);
      if (!(lo < middle && middle < hi)) break;
      const Sign s = sign_at(middle);
      if (s != at_lo && s != -at_lo) break;
      (s == at_lo ? lo : hi) = middle;
      const DdBall root = newton(q, lo, hi);
      if (root.rad < 0.25 * (hi - lo)) return root;
    }
  }
  return {0.5 * (lo + hi), 0, std::numeric_limits<double>::infinity()};
}

namespace {

// A function of time with a zero that is sought, in balls of a given precision.
struct Falling {
  std::function<Ball(const Ball&)> value, slope;  // at a time, over an interval
};

// Narrows [a, b], at whose ends f has certain and different signs.
Ball narrow(const Falling& f, Sign at_a, Rational a, Rational b, const MakeBall& make) {
  Ball root = make.hull(a, b);
  for (;;) {
    Patience::ask();
    const Rational middle = (a + b) / 2;
    const Ball center = make(middle);
    const Ball value = f.value(center);
    const Ball slope = f.slope(make.hull(a, b));
    const Ball next = center - value / slope;
    if (is_certain(sign(slope)) && next.radius().scaled(2) < root.radius()) {
      // The interval Newton method gains at least two bits.
      root = next;
      const auto [low, high] = root.rational_interval();
      a = std::max(a, low);
      b = std::min(b, high);
      if (!(a < b)) return root;
    } else {
      // Not monotone enough yet, or at the limit of the precision: bisect.
      const Sign s = sign(value);
      if (s == at_a) {
        a = middle;
      } else if (s == -at_a && s != Sign::unknown) {
        b = middle;
      } else {
        return root;
      }
      root = make.hull(a, b);
    }
  }
}

}  // namespace

Ball CollapseSearch::refine(const Quad& q, const Rational& lo, const Rational& hi, int bits) const {
  const bool cocircular = flip_polynomial_is_cocircularity(motion_, q);
  const MakeBall make{bits};
  const auto branch = [&](const Quad& edge) {
    return Falling{
        [this, edge](const Ball& t) { return start_incircle(edge, sites(motion_, edge, t)); },
        [this, edge](const Ball& t) {
          return start_incircle(edge, moving_sites(motion_, edge, t)).slope;
        }};
  };
  const Falling polynomial{[&](const Ball& t) { return flip_value(motion_, q, t, cocircular); },
                           [&](const Ball& t) { return flip_slope(motion_, q, t, cocircular); }};
  // The polynomial tells nothing of a root of even order; next to a root of high order the
  // precision may not tell an end of the interval from it.
  for (const Falling& f : {polynomial, branch(q), branch(reversed(q))}) {
    const Sign at_lo = sign(f.value(make(lo))), at_hi = sign(f.value(make(hi)));
    if (is_certain(at_lo) && at_hi == -at_lo) {
      return narrow(f, at_lo, lo, hi, make);
    }
  }
  return make.hull(lo, hi);
}

}  // namespace voroproof::internal
