#include "filtered/search/bernstein.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/predicates.h"
#include "exact/rounding.h"
#include "filtered/numbers/bound.h"
#include "filtered/numbers/form.h"
#include "filtered/numbers/lanes.h"
#include "filtered/search/quad_lanes.h"

namespace voroproof::internal {

namespace {

constexpr double u = unit_roundoff;

// Radii that differ by less than this part of a distance are nearly equal.
constexpr double kNearlyEqual = 0x1p-16;

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

// The offsets of three pairs, one in each lane.
template <class Pairs>
struct Offsets {
  Form<Lanes, 1> x, y;
  Form<Lanes, 0> r;
  explicit Offsets(const Ends& e)
      : x{{difference<Pairs>(e.x0), difference<Pairs>(e.x1)}},
        y{{difference<Pairs>(e.y0), difference<Pairs>(e.y1)}},
        r{{difference<Pairs>(e.r)}} {}
  Form<Lanes, 2> tangency() const { return tangency_of(x, y, r); }
  Lanes far0() const { return abs(x.c[0]) + abs(y.c[0]); }
  Lanes far1() const { return abs(x.c[1]) + abs(y.c[1]); }
  Lanes far() const { return larger(far0(), far1()); }
};

template <class Pairs>
Bound<Lanes> bound_of(const Offsets<Pairs>& d, const Ends& e) {
  return tangency_bound(d.far(), abs(d.r.c[0]), sum<Pairs>(e.err));
}

Form<double, 4> lane(const Form<Lanes, 4>& f, int k) {
  return {{f.c[0][k], f.c[1][k], f.c[2][k], f.c[3][k], f.c[4][k]}};
}

// Pays in the bound for the later use of a form: at most 24 subdivisions, which round once on each
// level of the scheme, and one evaluation, which rounds three times there; the weight 1 - x errs by
// u on each level as well, the value by as much again. That is 29 u of the size for each degree;
// the binomials, which are divided by before, cost 2 u.
template <int degree, class T>
[[gnu::always_inline]] inline T with_later_use(const Bound<T>& b) {
  return (b.err + unit_roundoff * (30.0 * degree * b.size)) * bound_up + 1e-290;
}

double cotangency_error(const Bound<Lanes>& with_l, const Bound<Lanes>& others) {
  const Bound<Lanes> abc = with_l * others;
  return with_later_use<8>(cotangency_bound<double>({total(abc.size), total(abc.err)}));
}

template <bool certified>
[[gnu::always_inline]] inline double cotangency_form(const Ends& e, Form<double, 8>& f) {
  const Offsets<PairsWithL> d(e);
  const Offsets<OtherPairs> o(e);
  const Form<Lanes, 4> abc = d.tangency() * o.tangency();
  f = cotangency_of(lane(abc, 0), lane(abc, 1), lane(abc, 2));
  return certified ? cotangency_error(bound_of(d, e), bound_of(o, e)) : 0;
}

// Bounds that grow with the coefficient. Where generators go far all of the above is as large as at
// the far end, the values at the other one are not. For a pair let S0 = |d0|^2 + dr^2 and S1
// likewise, for all pairs S1 <= g^2 S0, and eta such that an offset or dr errs by at most eta at a
// and by g eta at b. Then d0.d1 and dr^2 are at most g S0 in magnitude, dr^2 at most g^2 S0, and
// coefficient k of p is at most g^k S0 and errs by at most g^k (5 root(S0) + 3 eta) eta: products
// of two offsets by 2 root(2) root(S0) eta + 2 eta^2, dr^2 by 2 root(S0) eta + eta^2. Sums and
// products of such bounds are again such, in the scaled basis and so in weighted means: of f as
// above, with S0 for the size of p. Subdivision keeps within the same bounds on a part: g is linear
// in time.
struct PairSizes {
  Lanes s0, s1, eta0, eta1;
  template <class Pairs>
  PairSizes(const Offsets<Pairs>& d, const Ends& e) {
    const Lanes dr = abs(d.r.c[0]), dr2 = dr * dr;
    s0 = d.x.c[0] * d.x.c[0] + d.y.c[0] * d.y.c[0] + dr2;
    s1 = d.x.c[1] * d.x.c[1] + d.y.c[1] * d.y.c[1] + dr2;
    eta0 = sum<Pairs>(e.err0) + 2 * u * (d.far0() + dr);
    eta1 = sum<Pairs>(e.err1) + 2 * u * (d.far1() + dr);
  }
};

// Infinite where nobody goes far: the one bound for all serves well then.
[[gnu::noinline]] GrowingBound growing_bound(const Ends& ends) {
  const PairSizes with_l(Offsets<PairsWithL>(ends), ends);
  const PairSizes others(Offsets<OtherPairs>(ends), ends);
  if ((exceeding(with_l.s1, 64 * with_l.s0) | exceeding(others.s1, 64 * others.s0)) == 0) {
    return {std::numeric_limits<double>::infinity(), 1};
  }
  const Lanes growths = with_l.s1 / with_l.s0, other_growths = others.s1 / others.s0;
  double growth2 = 0;
  for (int k = 0; k < 3; ++k) growth2 = std::max({growth2, growths[k], other_growths[k]});
  // Pays for the rounding of sizes, too.
  const double growth = std::sqrt(growth2) * bound_up;
  const auto bound = [&](const PairSizes& pairs) -> Bound<Lanes> {
    const Lanes eta = larger(pairs.eta0, pairs.eta1 / growth);
    return {pairs.s0,
            (5 * square_root(pairs.s0) + 3 * eta) * eta + (4 * u * pairs.s0 + bound_tiny)};
  };
  return {cotangency_error(bound(with_l), bound(others)), growth};
}

// C, of equal radii, base the last of the four. The summands side by side in lanes; what is of two
// disks, in that of the third.
//
// Radii that differ, by at most `spread`, do not appear in C, but f, here four times that of the
// paper, is -4 C^2 for equal ones only: a pair's tangency is p = D - dr^2, D its squared distance,
// and f = a^2 + b^2 + c^2 - 2 (ab + bc + ca) in the products a = p_01 p_23 and so on. Putting D for
// p changes a by at most spread^2 (D_01 + D_23 + spread^2), with e the sum of these bounds f by at
// most e (2 (a + b + c) + e), a + b + c in terms of D. Beyond the square root of that, twice what
// would do, |C| shows that f < 0: it is added to the bound.
template <bool certified>
[[gnu::always_inline]] inline double cocircularity_form(const Ends& e, double spread,
                                                        Form<double, 4>& f) {
  const auto each = [](const auto& turned, const Form<Lanes, 1>& x) -> Form<Lanes, 1> {
    return {{turned(x.c[0]), turned(x.c[1])}};
  };
  const Offsets<PairsWithBase> d(e);
  // The tangency is taken without the radii, which may differ by `spread`.
  const Form<Lanes, 2> p = tangency_of(d.x, d.y, Form<Lanes, 0>{});
  const Form<Lanes, 4> terms =
      cocircularity_term(p, each(next, d.x), each(next, d.y), each(last, d.x), each(last, d.y));
  for (int k = 0; k < 5; ++k) f.c[k] = total(terms.c[k]);
  if constexpr (certified) {
    const Lanes far = d.far(), err = sum<PairsWithBase>(e.err), eta = err + u * far;
    const Bound<Lanes> bounds =
        tangency_bound(far, err) * determinant_bound(next(far), next(eta), last(far), last(eta));
    // The sum of the terms is rounded twice: there is room for that in their later use.
    double error = total(with_later_use<4>(bounds));
    if (spread > 0) {
      const Lanes way = far + 2 * eta;
      const Lanes to_base = way * way, apart = (next(way) + last(way)) * (next(way) + last(way));
      const double square = spread * spread;
      const double pairs = total(to_base + apart) + 3 * square, products = total(to_base * apart);
      error += spread * std::sqrt(pairs) * std::sqrt(2 * products + square * pairs) * bound_up;
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
  double spread = 0;  // bound on the differences of unequal radii; 0 where they are not small
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

// Whether the tangencies of these pairs have the signs of separated generators, coefficient by
// coefficient.
template <class Pairs>
bool are_separated(const Ends& e) {
  const Offsets<Pairs> d(e);
  const Form<Lanes, 2> p = d.tangency();
  const Lanes limit = bound_of(d, e).err * bound_up;
  const auto wall = (Pairs::first(e.r) < 0) ^ (Pairs::second(e.r) < 0);
  const Lanes side = wall ? -1 + Lanes{} : 1 + Lanes{};
  return (exceeding(side * p.c[0], limit) & exceeding(side * p.c[1], 2 * limit) &
          exceeding(side * p.c[2], limit)) == 0xf;
}

// Whether all coefficients are beyond their bounds on one side.
template <int degree>
bool has_one_sign(const Form<double, degree>& f, double err) {
  const double* c = f.c.data();
  const double side = c[0] > 0 ? 1 : -1;
  if (!(side * c[degree] > err)) return false;
  if constexpr (degree == 4) return exceeding(side * load(c), err * Lanes{1, 4, 6, 4}) == 0xf;
  return (exceeding(side * load(c), err * Lanes{1, 8, 28, 56}) &
          exceeding(side * load(c + 4), err * Lanes{70, 56, 28, 8})) == 0xf;
}

// Sets `out` to the coefficients of f without the binomials.
template <int degree>
void unscale(const Form<double, degree>& f, BernsteinForm& out) {
  constexpr std::array<int, degree + 1> scale = binomials<degree>();
  for (int k = 0; k <= degree; ++k) out.c[k] = f.c[k] * (1.0 / scale[k]);
}

template <bool certified, bool nearly>
bool form_flip_polynomial_of(const Motion& motion, const Quad& q, double a, double b,
                             BernsteinForm& out) {
  Ends ends;
  place<certified>(motion, q, a, b, ends);
  const Likeness alike = likeness<nearly>(motion, q, ends);
  out.spread = alike.spread;
  if (alike.equal || alike.spread > 0) {
    Form<double, 4> f;
    out.degree = 4;
    out.err = cocircularity_form<certified>(ends, out.spread, f);
    if (has_one_sign(f, out.err)) return true;
    unscale(f, out);
    return false;
  }
  Form<double, 8> f;
  out.degree = 8;
  out.err = cotangency_form<certified>(ends, f);
  if (has_one_sign(f, out.err)) return true;
  unscale(f, out);
  if constexpr (nearly) {
    // An infinite bound for all says that coefficients may have overflowed: no other holds then.
    out.bound = out.err < std::numeric_limits<double>::infinity() ? growing_bound(ends)
                                                                  : GrowingBound{out.err, 1};
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

bool are_separated(const Motion& motion, const Quad& q, double a, double b) {
  Ends ends;
  place<true>(motion, q, a, b, ends);
  return are_separated<PairsWithL>(ends) && are_separated<OtherPairs>(ends);
}

template bool form_flip_polynomial<true>(const Motion&, const Quad&, double, double,
                                         BernsteinForm&);
template bool form_flip_polynomial<false>(const Motion&, const Quad&, double, double,
                                          BernsteinForm&);

}  // namespace voroproof::internal
