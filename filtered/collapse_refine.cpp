// Narrowing a root that has been isolated.
#include <algorithm>
#include <cmath>

#include "filtered/collapse.h"
#include "filtered/flip_polynomial.h"
#include "filtered/newton_step.h"
#include "filtered/subdivision.h"

namespace voroproof {

DdBall CollapseSearch::refine(const Quad& q, double lo, double hi) const {
  // One step of the interval Newton method: the root lies in c - f(c) / f'([lo, hi]).
  const bool cocircular = flip_polynomial_is_cocircularity(motion_, q);
  const double c = 0.5 * (lo + hi);
  if (!cocircular) {
    const DdBall root = newton_step(motion_, q, lo, hi);
    if (std::isfinite(root.rad)) return root;
  }
  const DoubleBall slope =
      flip_value_and_slope(motion_, q, DoubleBall::hull(lo, hi), cocircular).slope;
  const DdBall f = flip_value(motion_, q, DdBall(c), cocircular);
  return DdBall(c) - f / DdBall(slope.mid, 0, slope.rad);
}

Ball CollapseSearch::refine(const Quad& q, const Rational& lo, const Rational& hi, int bits) const {
  const bool cocircular = flip_polynomial_is_cocircularity(motion_, q);
  const MakeBall make{bits};
  Rational a = lo, b = hi;
  Ball root = make.hull(a, b);
  const Sign at_lo = sign(flip_value(motion_, q, make(lo), cocircular));
  const Sign at_hi = sign(flip_value(motion_, q, make(hi), cocircular));
  // Of a root of even order the polynomial tells nothing; next to one of high order the precision
  // may not tell an end of the interval from it.
  if (at_lo == Sign::unknown || at_lo == Sign::zero || at_hi != -at_lo) return root;
  for (;;) {
    const Rational middle = (a + b) / 2;
    const Ball center(middle, bits);
    const Ball f = flip_value(motion_, q, center, cocircular);
    const Ball slope = flip_value_and_slope(motion_, q, make.hull(a, b), cocircular).slope;
    const Ball next = center - f / slope;
    if (sign(slope) != Sign::unknown && next.radius().scaled(2) < root.radius()) {
      // The interval Newton method gains at least two bits.
      root = next;
      Rational mid, rad = 1;
      mpfr_get_q(mid.get_mpq_t(), root.midpoint());
      const long e = static_cast<long>(root.radius().exponent()) + 1;
      if (e >= 0) {
        rad <<= static_cast<unsigned long>(e);
      } else {
        rad >>= static_cast<unsigned long>(-e);
      }
      a = std::max<Rational>(a, mid - rad);
      b = std::min<Rational>(b, mid + rad);
      if (!(a < b)) return root;
    } else {
      // Not monotone enough yet, or at the limit of the precision: bisect.
      const Sign s = sign(f);
      if (s == at_lo) {
        a = middle;
      } else if (s == -at_lo && s != Sign::unknown) {
        b = middle;
      } else {
        return root;
      }
      root = make.hull(a, b);
    }
  }
}

}  // namespace voroproof
